//! Text as shapes, for a plot in pixels: the font is part of the program, so that none need be installed.
//!
//! It is Ubuntu Light, under the Ubuntu Font Licence 1.0. A character that it lacks becomes its empty box.

use ab_glyph::{Font, FontRef, OutlineCurve, Point};
use epaint_default_fonts::UBUNTU_LIGHT;
use plotters_backend::text_anchor::{HPos, Pos, VPos};
use tiny_skia::{Path, PathBuilder, Transform};

use super::{Drawn, words};

/// The library's size of a font, in ems: that of its SVG.
pub(super) const SIZE: f64 = 1.24;
/// From the anchor of text that hangs down to its baseline, in ems.
const HANG: f32 = 0.76;

/// A line of text, with its baseline from the origin to the right.
pub(super) struct Line {
    /// The outlines of its glyphs; none of blanks.
    pub shape: Option<Path>,
    width: f32,
    em: f32,
    x_height: f32,
}

impl Line {
    /// Sets a text at the library's size of a font.
    pub fn new(text: &str, size: f64) -> Drawn<Self> {
        let font = FontRef::try_from_slice(UBUNTU_LIGHT).map_err(words)?;
        let em = (size / SIZE) as f32;
        let scale = em / font.units_per_em().unwrap_or(1000.0);
        let (shape, width) = set(&font, text);
        Ok(Self {
            shape: shape.and_then(|shape| shape.transform(Transform::from_scale(scale, -scale))),
            width: width * scale,
            em,
            x_height: font.outline(font.glyph_id('x')).map_or(0.0, |x| x.bounds.height().abs() * scale),
        })
    }

    /// How far right and down of its anchor the text begins, the same as in the library's SVG.
    pub fn offset(&self, anchor: Pos) -> (f32, f32) {
        let right = match anchor.h_pos {
            HPos::Left => 0.0,
            HPos::Center => -self.width / 2.0,
            HPos::Right => -self.width,
        };
        let down = match anchor.v_pos {
            VPos::Top => HANG * self.em,
            VPos::Center => self.x_height / 2.0,
            VPos::Bottom => -self.x_height / 2.0,
        };
        (right, down)
    }
}

/// The outline and width of a text in the font's own units, upwards.
fn set(font: &FontRef, text: &str) -> (Option<Path>, f32) {
    let mut path = PathBuilder::new();
    let mut x = 0.0;
    let mut last = None;
    for glyph in text.chars().map(|c| font.glyph_id(c)) {
        x += last.map_or(0.0, |last| font.kern_unscaled(last, glyph));
        append(&mut path, font.outline(glyph).map(|outline| outline.curves).unwrap_or_default(), x);
        x += font.h_advance_unscaled(glyph);
        last = Some(glyph);
    }
    (path.finish(), x)
}

/// Appends a glyph, shifted right by `x`; where a curve does not go on from the last one, the next contour begins.
fn append(path: &mut PathBuilder, curves: Vec<OutlineCurve>, x: f32) {
    let mut at = None;
    for curve in curves {
        let (start, end) = match &curve {
            OutlineCurve::Line(a, b) | OutlineCurve::Quad(a, _, b) | OutlineCurve::Cubic(a, _, _, b) => (*a, *b),
        };
        if at != Some(start) {
            path.move_to(start.x + x, start.y);
        }
        at = Some(end);
        match curve {
            OutlineCurve::Line(_, Point { x: x1, y: y1 }) => path.line_to(x1 + x, y1),
            OutlineCurve::Quad(_, b, c) => path.quad_to(b.x + x, b.y, c.x + x, c.y),
            OutlineCurve::Cubic(_, b, c, d) => path.cubic_to(b.x + x, b.y, c.x + x, c.y, d.x + x, d.y),
        }
    }
}
