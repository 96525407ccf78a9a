//! The styles of series and of other elements.

use kurbo::{Affine, BezPath, Circle, Point, Shape as _};

use super::canvas::{Canvas, Fill, Pen};

const STROKE_WIDTH: f64 = 3.0;
const THIN: f64 = 2.0;
const FINE: f64 = 1.0;
/// The approximate half size of a marker in pixels.
const RADIUS: f64 = 8.0;
const HALO_RADIUS: f64 = 16.0;

/// The Okabe–Ito palette without yellow, which is too faint for lines on white.
const COLORS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9"];
/// The color of elements that are not data.
const GREY: &str = "#808080";
/// The color of elements behind them.
const LIGHT: &str = "#c8c8c8";
/// The color of surfaces.
const DARK: &str = "#404040";
/// The color of media.
const GLASS: &str = "#789cc8";

/// The lengths of dash and gap in pixels.
const DASHES: [Option<[f64; 2]>; 5] =
    [None, Some([18.0, 9.0]), Some([5.0, 7.0]), Some([32.0, 8.0]), Some([10.0, 14.0])];

/// The shapes of markers, filled or hollow. Sixteen markers, seven colors and five dashes have no common divisor, so that combinations
/// repeat only after all have been used.
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

/// A shape, and `true` if it is hollow.
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

/// The style of one series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Style {
    pen: Pen,
    marker: Option<Marker>,
}

impl Style {
    /// Returns the style of a series by its index; the first 560 all differ, and the first 16 by their markers alone.
    pub fn of(series: usize) -> Self {
        let pen =
            Pen { color: COLORS[series % COLORS.len()], width: STROKE_WIDTH, dash: DASHES[series % DASHES.len()] };
        Self { pen, marker: Some(MARKERS[series % MARKERS.len()]) }
    }

    /// A gray line for elements that are not data.
    pub const ASIDE: Self = Self::line(GREY, STROKE_WIDTH);
    /// A fine light line behind the data.
    pub const BEHIND: Self = Self::line(LIGHT, FINE);
    /// A thin dashed gray line for a limit.
    pub const LIMIT: Self = Self { pen: Pen { color: GREY, width: THIN, dash: Some([14.0, 8.0]) }, marker: None };
    /// A thin gray line through wide rings for the Pareto front.
    pub const BEST: Self = Self { marker: Some(Marker(Shape::Halo, true)), ..Self::line(GREY, THIN) };
    /// A dark line for an opaque surface.
    pub const SOLID: Self = Self::line(DARK, STROKE_WIDTH);
    /// A light line for the surface of a medium.
    pub const GLASS: Self = Self::line(GLASS, STROKE_WIDTH);
    /// A thin dark line for a capture surface.
    pub const HOLE: Self = Self::line(DARK, THIN);
    /// A black cross for a computed position.
    pub const FOCUS: Self = Self { marker: Some(Marker(Shape::Cross, false)), ..Self::line("black", STROKE_WIDTH) };
    /// A black plus for a given position.
    pub const CENTER: Self = Self { marker: Some(Marker(Shape::Plus, false)), ..Self::FOCUS };

    const fn line(color: &'static str, width: f64) -> Self {
        Self { pen: Pen { color, width, dash: None }, marker: None }
    }

    /// Returns the fill of an area in this color.
    pub fn fill(self, opacity: f64) -> Fill {
        Fill(self.pen.color, opacity)
    }

    /// Strokes a path.
    pub fn stroke(self, canvas: &mut Canvas, path: &BezPath) {
        canvas.draw(path, None, Some(self.pen));
    }

    /// Draws a line through positions.
    pub fn join(self, canvas: &mut Canvas, places: impl IntoIterator<Item = Point>) {
        self.stroke(canvas, &joined(places));
    }

    /// Draws the marker at a position, if the style has one.
    pub fn mark(self, canvas: &mut Canvas, at: Point) {
        let Some(Marker(shape, hollow)) = self.marker else { return };
        let path = Affine::translate(at.to_vec2()) * shape.path();
        let pen = Pen { dash: None, ..self.pen };
        match shape {
            Shape::Cross | Shape::Plus | Shape::Star => canvas.draw(&path, None, Some(pen)),
            _ if hollow => canvas.draw(&path, Some(Fill("white", 1.0)), Some(pen)),
            _ => canvas.draw(&path, Some(self.fill(1.0)), None),
        }
    }
}

impl Shape {
    /// Returns the outline around [0, 0], or the strokes.
    fn path(self) -> BezPath {
        const R: f64 = RADIUS;
        let polygon = |corners: &[[f64; 2]]| ring(corners.iter().map(|[x, y]| Point::new(*x, *y)));
        let strokes = |ends: &[[f64; 4]]| {
            let lines = ends.iter().flat_map(|[a, b, c, d]| joined([(*a, *b), (*c, *d)].map(Point::from)));
            lines.collect::<BezPath>()
        };
        match self {
            Self::Disc => Circle::new(Point::ORIGIN, R).to_path(1e-2),
            Self::Halo => Circle::new(Point::ORIGIN, HALO_RADIUS).to_path(1e-2),
            Self::Square => polygon(&[[-R, -R], [R, -R], [R, R], [-R, R]]),
            Self::Up => polygon(&[[0.0, -R - 2.0], [R + 1.0, R - 1.0], [-R - 1.0, R - 1.0]]),
            Self::Down => polygon(&[[0.0, R + 2.0], [R + 1.0, 1.0 - R], [-R - 1.0, 1.0 - R]]),
            Self::Right => polygon(&[[R + 2.0, 0.0], [1.0 - R, R + 1.0], [1.0 - R, -R - 1.0]]),
            Self::Diamond => polygon(&[[0.0, -R - 3.0], [R + 3.0, 0.0], [0.0, R + 3.0], [-R - 3.0, 0.0]]),
            Self::Hourglass => polygon(&[[-R, -R - 1.0], [R, -R - 1.0], [-R, R + 1.0], [R, R + 1.0]]),
            Self::Cross => strokes(&[[-R, -R, R, R], [-R, R, R, -R]]),
            Self::Plus => strokes(&[[-R - 2.0, 0.0, R + 2.0, 0.0], [0.0, -R - 2.0, 0.0, R + 2.0]]),
            Self::Star => {
                let half = R / 2.0;
                strokes(&[[-R - 1.0, 0.0, R + 1.0, 0.0], [-half, -R, half, R], [-half, R, half, -R]])
            }
        }
    }
}

/// Returns the line through positions, or nothing for fewer than two.
pub(super) fn joined(places: impl IntoIterator<Item = Point>) -> BezPath {
    let mut path = BezPath::new();
    for at in places {
        if path.elements().is_empty() {
            path.move_to(at);
        } else {
            path.line_to(at);
        }
    }
    if path.elements().len() > 1 { path } else { BezPath::new() }
}

/// Returns the closed line through positions, or nothing for fewer than two.
pub(super) fn ring(places: impl IntoIterator<Item = Point>) -> BezPath {
    let mut path = joined(places);
    if !path.is_empty() {
        path.close_path();
    }
    path
}
