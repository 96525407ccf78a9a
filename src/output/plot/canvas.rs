//! The canvas of plots: SVG elements, which are written as a file or rendered to a PNG.
//!
//! The SVG names no font except `sans-serif`. The PNG uses Ubuntu Light (Ubuntu Font Licence 1.0), which is part of the program, so that no
//! font must be installed.

use std::fmt::Display;
use std::io::Cursor;

use epaint_default_fonts::UBUNTU_LIGHT;
use image::{ImageFormat, RgbImage};
use kurbo::{BezPath, PathEl, Point, Rect, Shape};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use svg::node::element::{ClipPath, Element, Group, Path, SVG};
use svg::node::{Node, Text};

/// The width and height of a plot in pixels, including the legend.
pub(super) const CANVAS: [u32; 2] = [1600, 1200];
/// The size of text in pixels.
pub(super) const TEXT_SIZE: f64 = 23.0;
/// The distance from the center of a line of text down to its baseline, relative to its size.
const HALF_HEIGHT: f64 = 0.35;
/// The approximate width of a character relative to the size of text, because the reader chooses the font of an SVG.
const CHARACTER: f64 = 0.68;

/// A color with its opacity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fill(pub &'static str, pub f64);

/// The style of a stroked line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pen {
    pub color: &'static str,
    /// The width in pixels.
    pub width: f64,
    /// The lengths of dash and gap in pixels.
    pub dash: Option<[f64; 2]>,
}

/// The alignment of text: its start, center or end is at its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Align {
    Start,
    Middle,
    End,
}

/// The elements of a plot in drawing order.
#[derive(Debug)]
pub(super) struct Canvas(Group);

impl Canvas {
    pub fn new() -> Self {
        Self(Group::new())
    }

    /// Draws a path, filled by the even–odd rule, so that a ring has a hole.
    pub fn draw(&mut self, path: &BezPath, fill: Option<Fill>, pen: Option<Pen>) {
        if path.is_empty() {
            return;
        }
        let mut element = Path::new().set("d", data(path)).set("fill", fill.map_or("none", |Fill(color, _)| color));
        if let Some(Fill(_, opacity)) = fill {
            element = element.set("fill-opacity", opacity).set("fill-rule", "evenodd");
        }
        if let Some(Pen { color, width, dash }) = pen {
            element = element.set("stroke", color).set("stroke-width", width).set("stroke-linejoin", "round");
            if let Some(dash) = dash {
                element = element.set("stroke-dasharray", dash.to_vec());
            }
        }
        self.0.append(element);
    }

    /// Draws elements clipped to a window.
    pub fn clipped(&mut self, window: Rect, draw: impl FnOnce(&mut Self)) {
        let mut inside = Self::new();
        draw(&mut inside);
        self.0.append(ClipPath::new().set("id", "window").add(Path::new().set("d", data(&window.to_path(0.1)))));
        self.0.append(inside.0.set("clip-path", "url(#window)"));
    }

    /// Writes a line of text, vertically centered at a position.
    pub fn write(&mut self, text: &str, at: Point, align: Align) {
        self.0.append(label(text, at, align, TEXT_SIZE));
    }

    /// Writes an upward line of text around its center.
    pub fn write_upwards(&mut self, text: &str, at: Point) {
        let mut label = label(text, at, Align::Middle, TEXT_SIZE);
        label.assign("transform", format!("rotate(-90 {} {})", at.x, at.y));
        self.0.append(label);
    }

    /// Writes a line of text of another size around its center.
    pub fn write_title(&mut self, text: &str, at: Point, size: f64) {
        self.0.append(label(text, at, Align::Middle, size));
    }

    /// Returns the plot as SVG.
    pub fn svg(self) -> String {
        let [width, height] = CANVAS;
        let paper = Path::new().set("d", format!("M0,0 H{width} V{height} H0 Z")).set("fill", "white");
        let whole = SVG::new().set("width", width).set("height", height).set("viewBox", (0, 0, width, height));
        format!("{}\n", whole.set("font-family", "sans-serif").add(paper).add(self.0))
    }

    /// Returns the plot as a PNG.
    pub fn png(self) -> Result<Vec<u8>, String> {
        let mut options = Options::default();
        options.fontdb_mut().load_font_data(UBUNTU_LIGHT.to_vec());
        let font =
            options.fontdb.faces().next().map(|face| face.families[0].0.clone()).ok_or("the font is not valid")?;
        options.fontdb_mut().set_sans_serif_family(font);
        let tree = Tree::from_str(&self.svg(), &options).map_err(words)?;
        let [width, height] = CANVAS;
        let mut pixels = Pixmap::new(width, height).ok_or("the size is not valid for an image")?;
        pixels.fill(Color::WHITE);
        resvg::render(&tree, Transform::identity(), &mut pixels.as_mut());
        let mut picture = RgbImage::new(width, height);
        for (to, from) in picture.pixels_mut().zip(pixels.pixels()) {
            to.0 = [from.red(), from.green(), from.blue()];
        }
        let mut bytes = Cursor::new(Vec::new());
        picture.write_to(&mut bytes, ImageFormat::Png).map_err(words)?;
        Ok(bytes.into_inner())
    }
}

/// Returns the approximate width of a line of text in pixels.
pub(super) fn text_width(text: &str) -> f64 {
    text.chars().count() as f64 * CHARACTER * TEXT_SIZE
}

fn label(text: &str, at: Point, align: Align, size: f64) -> Element {
    let anchor = match align {
        Align::Start => "start",
        Align::Middle => "middle",
        Align::End => "end",
    };
    let mut label = Element::new("text");
    label.assign("x", hundredths(at.x));
    label.assign("y", hundredths(at.y + HALF_HEIGHT * size));
    label.assign("text-anchor", anchor);
    label.assign("font-size", size);
    label.append(Text::new(text));
    label
}

/// Returns the SVG data of a path, to a hundredth of a pixel.
fn data(path: &BezPath) -> String {
    let round = |p: Point| Point::new(hundredths(p.x), hundredths(p.y));
    let rounded = path.iter().map(|element| match element {
        PathEl::MoveTo(p) => PathEl::MoveTo(round(p)),
        PathEl::LineTo(p) => PathEl::LineTo(round(p)),
        PathEl::QuadTo(a, p) => PathEl::QuadTo(round(a), round(p)),
        PathEl::CurveTo(a, b, p) => PathEl::CurveTo(round(a), round(b), round(p)),
        PathEl::ClosePath => PathEl::ClosePath,
    });
    rounded.collect::<BezPath>().to_svg()
}

/// Rounds a number to a hundredth, without −0.
fn hundredths(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
}

fn words(error: impl Display) -> String {
    error.to_string()
}
