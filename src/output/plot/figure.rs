//! Curves in fractions of pixels, which the drawing library does not have: they go straight to the paper.

use std::iter::{Empty, empty};

use plotters::element::{Drawable, PointCollection};
use plotters_backend::{BackendColor, BackendCoord, DrawingErrorKind};
use tiny_skia::Path;

use super::paper::Paper;

/// How a curve is stroked.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    pub color: BackendColor,
    /// Pixels.
    pub width: u32,
    /// Lengths of dash and gap in pixels.
    pub dash: Option<(i32, i32)>,
}

/// A path in pixels from the top left corner of the canvas.
pub(super) struct Figure {
    pub path: Path,
    /// Of its inside, by the even–odd rule: a ring has a hole.
    pub fill: Option<BackendColor>,
    pub stroke: Option<Pen>,
}

impl PointCollection<'_, BackendCoord> for &Figure {
    type Point = BackendCoord;
    type IntoIter = Empty<BackendCoord>;

    fn point_iter(self) -> Self::IntoIter {
        empty()
    }
}

impl Drawable<Paper<'_>> for Figure {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        _: I,
        paper: &mut Paper,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<std::io::Error>> {
        paper.figure(self);
        Ok(())
    }
}
