//! A plot in pixels, with smooth edges.
//!
//! Strokes and markers are centred on pixels, so that an upright line of odd width is sharp. Host memory: four bytes
//! per pixel, and three more while it is encoded.

use std::io;

use ::png::{BitDepth, ColorType, Encoder, EncodingError, SrgbRenderingIntent};
use plotters_backend::{BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind, FontTransform};
use tiny_skia::{Color, FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, StrokeDash, Transform};

use super::{Drawn, figure::Figure, glyphs::Line};

/// The middle of a pixel, from its corner.
const MIDDLE: f32 = 0.5;

/// A canvas of pixels, white at first.
pub(super) struct Raster {
    pixels: Pixmap,
}

type Done = Result<(), DrawingErrorKind<io::Error>>;

impl Raster {
    pub fn new((width, height): (u32, u32)) -> Drawn<Self> {
        let mut pixels =
            Pixmap::new(width, height).ok_or_else(|| format!("no canvas of {width} by {height} pixels"))?;
        pixels.fill(Color::WHITE);
        Ok(Self { pixels })
    }

    /// The picture as a PNG; it has no alpha, since it is drawn on white.
    pub fn encode(&self) -> Result<Vec<u8>, EncodingError> {
        let rgb: Vec<u8> = self.pixels.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect();
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, self.pixels.width(), self.pixels.height());
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&rgb)?;
        writer.finish()?;
        Ok(bytes)
    }

    pub fn stroke(&mut self, line: impl IntoIterator<Item = BackendCoord>, style: &impl BackendStyle) {
        self.outline(joined(line, false), style);
    }

    pub fn polygon(&mut self, corners: impl IntoIterator<Item = BackendCoord>, style: &impl BackendStyle) {
        self.fill(joined(corners, true), style);
    }

    /// A rectangle between two corners; filled, it covers whole pixels.
    pub fn rectangle(&mut self, from: BackendCoord, to: BackendCoord, style: &impl BackendStyle, fill: bool) {
        if !fill {
            self.outline(joined([from, (to.0, from.1), to, (from.0, to.1)], true), style);
            return;
        }
        let [x0, y0, x1, y1] = [from.0.min(to.0), from.1.min(to.1), from.0.max(to.0), from.1.max(to.1)];
        self.fill(Rect::from_ltrb(x0 as f32, y0 as f32, x1 as f32, y1 as f32).map(PathBuilder::from_rect), style);
    }

    pub fn circle(&mut self, center: BackendCoord, radius: u32, style: &impl BackendStyle, fill: bool) {
        let (x, y) = middle(center);
        let circle = PathBuilder::from_circle(x, y, radius as f32);
        if fill {
            self.fill(circle, style);
        } else {
            self.outline(circle, style);
        }
    }

    /// Curves, shifted as all else is, so that they fit it.
    pub fn figure(&mut self, figure: &Figure) {
        let place = Transform::from_translate(MIDDLE, MIDDLE);
        if let Some(color) = figure.fill {
            self.pixels.fill_path(&figure.path, &paint(&color), FillRule::EvenOdd, place, None);
        }
        if let Some(pen) = figure.stroke {
            let dash = pen.dash.and_then(|(dash, gap)| StrokeDash::new(vec![dash as f32, gap as f32], 0.0));
            let stroke = Stroke { width: pen.width as f32, line_join: LineJoin::Round, dash, ..Stroke::default() };
            self.pixels.stroke_path(&figure.path, &paint(&pen.color), &stroke, place, None);
        }
    }

    /// Text about a place, as a browser would set it there: see [`Line`].
    pub fn text(&mut self, text: &str, style: &impl BackendTextStyle, (x, y): BackendCoord) -> Done {
        let line = Line::new(text, style.size()).map_err(|e| DrawingErrorKind::FontError(e.into()))?;
        let turn = match style.transform() {
            FontTransform::None => 0.0,
            FontTransform::Rotate90 => 90.0,
            FontTransform::Rotate180 => 180.0,
            FontTransform::Rotate270 => 270.0,
        };
        let (right, down) = line.offset(style.anchor());
        let place = Transform::from_rotate(turn).post_translate(x as f32, y as f32).pre_translate(right, down);
        if let Some(shape) = line.shape {
            let paint = paint(&style.color());
            self.pixels.fill_path(&shape, &paint, FillRule::Winding, place, None);
        }
        Ok(())
    }

    fn outline(&mut self, path: Option<Path>, style: &impl BackendStyle) {
        let stroke = Stroke { width: style.stroke_width() as f32, line_join: LineJoin::Round, ..Stroke::default() };
        if let Some(path) = path {
            self.pixels.stroke_path(&path, &paint(style), &stroke, Transform::identity(), None);
        }
    }

    fn fill(&mut self, path: Option<Path>, style: &impl BackendStyle) {
        if let Some(path) = path {
            self.pixels.fill_path(&path, &paint(style), FillRule::Winding, Transform::identity(), None);
        }
    }
}

fn middle((x, y): BackendCoord) -> (f32, f32) {
    (x as f32 + MIDDLE, y as f32 + MIDDLE)
}

/// A path through places; none through fewer than two.
fn joined(places: impl IntoIterator<Item = BackendCoord>, closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (x, y) in places.into_iter().map(middle) {
        if path.is_empty() {
            path.move_to(x, y);
        } else {
            path.line_to(x, y);
        }
    }
    if closed {
        path.close();
    }
    path.finish()
}

fn paint(style: &impl BackendStyle) -> Paint<'static> {
    let color = style.color();
    let (red, green, blue) = color.rgb;
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(red, green, blue, (color.alpha * 255.0).round() as u8);
    paint
}
