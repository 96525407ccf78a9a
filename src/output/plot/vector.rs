//! A plot as SVG.
//!
//! The drawing library's own SVG has no curves and only whole pixels; this writes what it would, and [`Figure`]s as they are.

use std::fmt::{Display, Write};

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, FontTransform};
use tiny_skia::PathSegment;

use super::figure::Figure;
use super::glyphs::SIZE;

/// A canvas of shapes, to be read by a browser.
pub(super) struct Vector {
    text: String,
}

impl Vector {
    pub fn new((width, height): (u32, u32)) -> Self {
        let text = format!(
            "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\">\n"
        );
        Self { text }
    }

    /// The whole file.
    pub fn encode(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }

    pub fn line(&mut self, (x1, y1): BackendCoord, (x2, y2): BackendCoord, style: &impl BackendStyle) {
        let place = format_args!("x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"").to_string();
        self.element("line", style.color(), &format!("{} {place}", stroke(style)));
    }

    pub fn rectangle(&mut self, from: BackendCoord, to: BackendCoord, style: &impl BackendStyle, filled: bool) {
        let [x, y] = [from.0.min(to.0), from.1.min(to.1)];
        let [width, height] = [(to.0 - from.0).abs(), (to.1 - from.1).abs()];
        let place = format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"");
        self.element("rect", style.color(), &format!("{} {place}", outline_or_fill(style, filled)));
    }

    pub fn circle(&mut self, (x, y): BackendCoord, radius: u32, style: &impl BackendStyle, filled: bool) {
        let place = format!("cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"");
        self.element("circle", style.color(), &format!("{} {place}", outline_or_fill(style, filled)));
    }

    pub fn stroke(&mut self, points: impl IntoIterator<Item = BackendCoord>, style: &impl BackendStyle) {
        let shape = format!("fill=\"none\" {} points=\"{}\"", stroke(style), listed(points));
        self.element("polyline", style.color(), &shape);
    }

    pub fn polygon(&mut self, points: impl IntoIterator<Item = BackendCoord>, style: &impl BackendStyle) {
        let shape = format!("fill=\"{}\" points=\"{}\"", hexadecimal(style.color()), listed(points));
        self.element("polygon", style.color(), &shape);
    }

    pub fn text(&mut self, text: &str, style: &impl BackendTextStyle, (x, y): BackendCoord) {
        let anchor = match style.anchor().h_pos {
            HPos::Left => "start",
            HPos::Center => "middle",
            HPos::Right => "end",
        };
        let down = match style.anchor().v_pos {
            VPos::Top => "0.76em",
            VPos::Center => "0.5ex",
            VPos::Bottom => "-0.5ex",
        };
        let turn = match style.transform() {
            FontTransform::None => String::new(),
            FontTransform::Rotate90 => format!(" transform=\"rotate(90, {x}, {y})\""),
            FontTransform::Rotate180 => format!(" transform=\"rotate(180, {x}, {y})\""),
            FontTransform::Rotate270 => format!(" transform=\"rotate(270, {x}, {y})\""),
        };
        let color = style.color();
        self.put(format_args!(
            "<text x=\"{x}\" y=\"{y}\" dy=\"{down}\" text-anchor=\"{anchor}\" font-family=\"{}\" font-size=\"{}\" \
             opacity=\"{}\" fill=\"{}\"{turn}>{}</text>\n",
            style.family().as_str(),
            style.size() / SIZE,
            color.alpha,
            hexadecimal(color),
            escaped(text),
        ));
    }

    /// Curves, to a hundredth of a pixel.
    pub fn figure(&mut self, figure: &Figure) {
        let mut data = String::new();
        for segment in figure.path.segments() {
            match segment {
                PathSegment::MoveTo(p) => write_points(&mut data, 'M', &[p]),
                PathSegment::LineTo(p) => write_points(&mut data, 'L', &[p]),
                PathSegment::QuadTo(a, p) => write_points(&mut data, 'Q', &[a, p]),
                PathSegment::CubicTo(a, b, p) => write_points(&mut data, 'C', &[a, b, p]),
                PathSegment::Close => data.push('Z'),
            }
        }
        let fill = figure.fill.map_or("fill=\"none\"".to_owned(), |color| {
            format!("fill=\"{}\" fill-opacity=\"{}\" fill-rule=\"evenodd\"", hexadecimal(color), color.alpha)
        });
        let stroke = figure.stroke.map_or(String::new(), |stroke| {
            let dash = stroke.dash.map_or(String::new(), |(dash, gap)| format!(" stroke-dasharray=\"{dash} {gap}\""));
            let line = format!(" stroke=\"{}\" stroke-width=\"{}\"", hexadecimal(stroke.color), stroke.width);
            line + " stroke-linejoin=\"round\"" + &dash
        });
        self.put(format_args!("<path {fill}{stroke} d=\"{data}\"/>\n"));
    }

    fn element(&mut self, name: &str, color: BackendColor, attributes: &str) {
        if color.alpha > 0.0 {
            self.put(format_args!("<{name} opacity=\"{}\" {attributes}/>\n", color.alpha));
        }
    }

    fn put(&mut self, text: std::fmt::Arguments) {
        // Writing to a string does not fail.
        let _ = self.text.write_fmt(text);
    }
}

fn write_points(data: &mut String, command: char, points: &[tiny_skia::Point]) {
    data.push(command);
    for (i, p) in points.iter().enumerate() {
        let space = if i == 0 { "" } else { " " };
        let _ = write!(data, "{space}{},{}", hundredths(p.x), hundredths(p.y));
    }
}

/// A number to a hundredth, without −0.
fn hundredths(value: f32) -> impl Display {
    (f64::from(value) * 100.0).round() / 100.0 + 0.0
}

fn stroke(style: &impl BackendStyle) -> String {
    format!("stroke=\"{}\" stroke-width=\"{}\"", hexadecimal(style.color()), style.stroke_width())
}

fn outline_or_fill(style: &impl BackendStyle, filled: bool) -> String {
    if filled {
        return format!("fill=\"{}\" stroke=\"none\"", hexadecimal(style.color()));
    }
    format!("fill=\"none\" {}", stroke(style))
}

fn listed(points: impl IntoIterator<Item = BackendCoord>) -> String {
    points.into_iter().map(|(x, y)| format!("{x},{y}")).collect::<Vec<_>>().join(" ")
}

fn hexadecimal(color: BackendColor) -> String {
    let (red, green, blue) = color.rgb;
    format!("#{red:02X}{green:02X}{blue:02X}")
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            other => escaped.push(other),
        }
    }
    escaped
}
