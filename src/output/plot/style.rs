//! How series look, and the legend that says so.

use plotters::{
    element::DashedPathElement,
    prelude::{Circle, Color, PathElement, Polygon, RGBColor},
};

use super::{Area, Drawn, words};

/// A place on the canvas, in pixels from its top left corner.
pub(super) type Place = (i32, i32);

const STROKE_WIDTH: u32 = 3;
const MARKER_RADIUS: i32 = 8;

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

/// Lengths of dash and gap in pixels.
const DASHES: [Option<(i32, i32)>; 5] = [None, Some((18, 9)), Some((5, 7)), Some((32, 8)), Some((10, 14))];

const MARKERS: [Marker; 6] =
    [Marker::Disc, Marker::Square, Marker::Triangle, Marker::Cross, Marker::Diamond, Marker::Ring];

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Marker {
    Disc,
    Ring,
    Square,
    Diamond,
    Triangle,
    Cross,
}

/// How one series is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Look {
    color: RGBColor,
    dash: Option<(i32, i32)>,
    marker: Option<Marker>,
}

impl Look {
    /// The look of the series of this number; the first 210 all differ.
    pub fn of(series: usize) -> Self {
        Self {
            color: COLORS[series % COLORS.len()],
            dash: DASHES[series % DASHES.len()],
            marker: Some(MARKERS[series % MARKERS.len()]),
        }
    }

    /// A grey line, for what is not data.
    pub fn aside() -> Self {
        Self { color: RGBColor(0x80, 0x80, 0x80), dash: None, marker: None }
    }

    /// Draws a line through places of the canvas.
    pub fn stroke(self, canvas: &Area, mut line: Vec<Place>) -> Drawn<()> {
        line.dedup();
        let style = self.color.stroke_width(STROKE_WIDTH);
        match self.dash {
            None => canvas.draw(&PathElement::new(line, style)),
            Some((dash, gap)) => canvas.draw(&DashedPathElement::new(line, dash, gap, style)),
        }
        .map_err(words)
    }

    /// Draws a marker at a place of the canvas.
    pub fn mark(self, canvas: &Area, (x, y): Place) -> Drawn<()> {
        let filled = self.color.filled();
        let outline = self.color.stroke_width(STROKE_WIDTH);
        let r = MARKER_RADIUS;
        let polygon = |corners: &[Place]| {
            let corners: Vec<_> = corners.iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
            canvas.draw(&Polygon::new(corners, filled))
        };
        match self.marker {
            None => Ok(()),
            Some(Marker::Disc) => canvas.draw(&Circle::new((x, y), r, filled)),
            Some(Marker::Ring) => canvas.draw(&Circle::new((x, y), r, outline)),
            Some(Marker::Square) => polygon(&[(-r, -r), (r, -r), (r, r), (-r, r)]),
            Some(Marker::Diamond) => polygon(&[(0, -r - 3), (r + 3, 0), (0, r + 3), (-r - 3, 0)]),
            Some(Marker::Triangle) => polygon(&[(0, -r - 2), (r + 1, r - 1), (-r - 1, r - 1)]),
            Some(Marker::Cross) => canvas
                .draw(&PathElement::new([(x - r, y - r), (x + r, y + r)], outline))
                .and_then(|()| canvas.draw(&PathElement::new([(x - r, y + r), (x + r, y - r)], outline))),
        }
        .map_err(words)
    }
}
