//! How series look.

use plotters::{
    element::DashedPathElement,
    prelude::{BLACK, Circle, Color, PathElement, Polygon, RGBColor, WHITE},
};
use plotters_backend::BackendColor;

use super::{Area, Drawn, figure::Pen, paths::SurfaceKind, words};

/// A place on the canvas, in pixels from its top left corner.
pub(super) type Place = (i32, i32);

const STROKE_WIDTH: u32 = 3;
const THIN: u32 = 2;
const MARKER_RADIUS: i32 = 8;
const HALO_RADIUS: i32 = 16;

/// Okabe and Ito's colours without yellow, which is too faint for lines on white.
const COLORS: [RGBColor; 7] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
    RGBColor(0x00, 0x00, 0x00),
    RGBColor(0xe6, 0x9f, 0x00),
    RGBColor(0x56, 0xb4, 0xe9),
];

/// Of what is not data.
const GREY: RGBColor = RGBColor(0x80, 0x80, 0x80);

/// Of surfaces.
const DARK: RGBColor = RGBColor(0x40, 0x40, 0x40);
/// Of media.
const GLASS: RGBColor = RGBColor(0x78, 0x9c, 0xc8);

/// Lengths of dash and gap in pixels.
const DASHES: [Option<(i32, i32)>; 5] = [None, Some((18, 9)), Some((5, 7)), Some((32, 8)), Some((10, 14))];

/// The shapes of markers, and whether they are hollow. Sixteen of them, seven colours and five dashes have no common
/// divisor, so that they only come together again after all their combinations.
const MARKERS: [Marker; 16] = [
    Marker(Shape::Disc, false),
    Marker(Shape::Square, false),
    Marker(Shape::Up, false),
    Marker(Shape::Cross, false),
    Marker(Shape::Diamond, false),
    Marker(Shape::Disc, true),
    Marker(Shape::Plus, false),
    Marker(Shape::Square, true),
    Marker(Shape::Down, false),
    Marker(Shape::Up, true),
    Marker(Shape::Star, false),
    Marker(Shape::Diamond, true),
    Marker(Shape::Hourglass, false),
    Marker(Shape::Down, true),
    Marker(Shape::Right, false),
    Marker(Shape::Hourglass, true),
];

/// A shape, and whether it is hollow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Marker(Shape, bool);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    Disc,
    Square,
    Up,
    Down,
    Right,
    Diamond,
    Hourglass,
    Cross,
    Plus,
    Star,
    /// A wide ring around another marker.
    Halo,
}

/// How one series is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Look {
    color: RGBColor,
    dash: Option<(i32, i32)>,
    marker: Option<Marker>,
    width: u32,
}

impl Look {
    /// The look of the series of this number; the first 560 all differ, and the first 16 by their markers alone.
    pub fn of(series: usize) -> Self {
        Self {
            color: COLORS[series % COLORS.len()],
            dash: DASHES[series % DASHES.len()],
            marker: Some(MARKERS[series % MARKERS.len()]),
            width: STROKE_WIDTH,
        }
    }

    /// A grey line, for what is not data.
    pub fn aside() -> Self {
        Self { color: GREY, dash: None, marker: None, width: STROKE_WIDTH }
    }

    /// A thin dashed grey line, for a limit.
    pub fn limit() -> Self {
        Self { color: GREY, dash: Some((14, 8)), marker: None, width: THIN }
    }

    /// A thin grey line through wide rings, for the best of the data.
    pub fn best() -> Self {
        Self { color: GREY, dash: None, marker: Some(Marker(Shape::Halo, true)), width: THIN }
    }

    /// A dark line, for an opaque surface.
    pub fn solid() -> Self {
        Self { color: DARK, dash: None, marker: None, width: STROKE_WIDTH }
    }

    /// A light line, for the surface of a medium.
    pub fn glass() -> Self {
        Self { color: GLASS, dash: None, marker: None, width: STROKE_WIDTH }
    }

    /// A thin dark line, for what swallows rays.
    pub fn hole() -> Self {
        Self { color: DARK, dash: None, marker: None, width: THIN }
    }

    /// A black cross, for a place that was found.
    pub fn focus() -> Self {
        Self { color: BLACK, dash: None, marker: Some(Marker(Shape::Cross, false)), width: STROKE_WIDTH }
    }

    /// A black plus, for a place that was given.
    pub fn center() -> Self {
        Self { marker: Some(Marker(Shape::Plus, false)), ..Self::focus() }
    }

    /// What the inside of a surface is filled with, if it has one that light comes or stays in.
    pub fn inside(kind: SurfaceKind) -> Option<BackendColor> {
        match kind {
            SurfaceKind::Medium => Some(GLASS.mix(0.2).to_backend_color()),
            SurfaceKind::Landmark("horizon" | "capture") => Some(DARK.mix(0.6).to_backend_color()),
            SurfaceKind::Opaque | SurfaceKind::Landmark(_) => None,
        }
    }

    /// How its line is stroked where it is a curve.
    pub fn pen(self) -> Pen {
        Pen { color: self.color.to_backend_color(), width: self.width, dash: self.dash }
    }

    /// Draws a line through places of the canvas.
    pub fn stroke(self, canvas: &Area, mut line: Vec<Place>) -> Drawn<()> {
        line.dedup();
        let style = self.color.stroke_width(self.width);
        match self.dash {
            None => canvas.draw(&PathElement::new(line, style)),
            Some((dash, gap)) => canvas.draw(&DashedPathElement::new(line, dash, gap, style)),
        }
        .map_err(words)
    }

    /// Draws a marker at a place of the canvas.
    pub fn mark(self, canvas: &Area, at: Place) -> Drawn<()> {
        let Some(Marker(shape, hollow)) = self.marker else { return Ok(()) };
        match shape {
            Shape::Disc => self.disc(canvas, at, MARKER_RADIUS, hollow),
            Shape::Halo => self.disc(canvas, at, HALO_RADIUS, hollow),
            Shape::Cross | Shape::Plus | Shape::Star => self.strokes(canvas, at, shape.corners()),
            _ => self.polygon(canvas, at, shape.corners(), hollow),
        }
    }

    fn disc(self, canvas: &Area, at: Place, radius: i32, hollow: bool) -> Drawn<()> {
        let inside = if hollow { WHITE } else { self.color };
        canvas.draw(&Circle::new(at, radius, inside.filled())).map_err(words)?;
        let outline = self.color.stroke_width(self.width);
        if hollow { canvas.draw(&Circle::new(at, radius, outline)).map_err(words) } else { Ok(()) }
    }

    fn polygon(self, canvas: &Area, at: Place, corners: &[Place], hollow: bool) -> Drawn<()> {
        let mut corners: Vec<_> = corners.iter().map(|by| shifted(at, *by)).collect();
        let inside = if hollow { WHITE } else { self.color };
        canvas.draw(&Polygon::new(corners.clone(), inside.filled())).map_err(words)?;
        // Beyond the first corner, so that it is joined like the others.
        corners.extend_from_within(..2);
        let outline = self.color.stroke_width(self.width);
        if hollow { canvas.draw(&PathElement::new(corners, outline)).map_err(words) } else { Ok(()) }
    }

    /// Strokes between pairs of places.
    fn strokes(self, canvas: &Area, at: Place, ends: &[Place]) -> Drawn<()> {
        ends.chunks(2).try_for_each(|ends| {
            let line: Vec<_> = ends.iter().map(|by| shifted(at, *by)).collect();
            canvas.draw(&PathElement::new(line, self.color.stroke_width(self.width))).map_err(words)
        })
    }
}

impl Shape {
    /// Corners of a polygon about its middle, or the ends of strokes; none of what is round.
    fn corners(self) -> &'static [Place] {
        const R: i32 = MARKER_RADIUS;
        match self {
            Self::Disc | Self::Halo => &[],
            Self::Square => &[(-R, -R), (R, -R), (R, R), (-R, R)],
            Self::Up => &[(0, -R - 2), (R + 1, R - 1), (-R - 1, R - 1)],
            Self::Down => &[(0, R + 2), (R + 1, 1 - R), (-R - 1, 1 - R)],
            Self::Right => &[(R + 2, 0), (1 - R, R + 1), (1 - R, -R - 1)],
            Self::Diamond => &[(0, -R - 3), (R + 3, 0), (0, R + 3), (-R - 3, 0)],
            Self::Hourglass => &[(-R, -R - 1), (R, -R - 1), (-R, R + 1), (R, R + 1)],
            Self::Cross => &[(-R, -R), (R, R), (-R, R), (R, -R)],
            Self::Plus => &[(-R - 2, 0), (R + 2, 0), (0, -R - 2), (0, R + 2)],
            Self::Star => &[(-R - 1, 0), (R + 1, 0), (-R / 2, -R), (R / 2, R), (-R / 2, R), (R / 2, -R)],
        }
    }
}

fn shifted((x, y): Place, (right, down): Place) -> Place {
    (x + right, y + down)
}
