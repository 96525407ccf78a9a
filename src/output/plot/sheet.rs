//! A sheet: the canvas with axes, title and legend, and its file.

use std::io::Write;
use std::path::Path;

use kurbo::{Point, Rect};

use super::axis::Axis;
use super::canvas::{Align, CANVAS, Canvas, Pen, TEXT_SIZE};
use super::legend::{Legend, MARGIN};
use super::style::joined;
use crate::output::{AtomicFile, OutputError, has_extension};

/// The room for the labels of the x axis below the plot, and of the y axis next to it.
const LABEL_ROOM: [f64; 2] = [90.0, 140.0];
/// The room for a title, and its size.
const TITLE_ROOM: f64 = 40.0;
const TITLE_SIZE: f64 = 29.0;
/// The length of a tick, and the distance from the axis to its numbers.
const TICK: f64 = 5.0;
const GAP: f64 = 10.0;
const AXIS: Pen = Pen { color: "black", width: 1.0, dash: None };
const GRID: Pen = Pen { color: "#cccccc", width: 1.0, dash: None };

/// Returns `true` for the name of an SVG, and `false` for that of a PNG.
fn is_svg(path: &Path) -> Result<bool, OutputError> {
    let is_svg = has_extension(path, "svg");
    if is_svg || has_extension(path, "png") {
        Ok(is_svg)
    } else {
        Err(OutputError::PlotFormat { path: path.to_owned() })
    }
}

/// Checks that a plot can be written at `path`, before its data are computed.
///
/// # Errors
///
/// Returns [`OutputError::PlotFormat`] for an extension other than `.svg` and `.png`, and the errors of [`AtomicFile::create`].
pub fn check_plot(path: &Path) -> Result<(), OutputError> {
    is_svg(path)?;
    AtomicFile::create(path).map(drop)
}

/// The area of data on the canvas, with its axes.
pub(super) struct Sheet<'a> {
    pub title: &'a str,
    pub x: Axis,
    pub y: Axis,
    pub legend: &'a Legend,
}

impl Sheet<'_> {
    /// Returns the area in pixels that a title and a legend leave for data.
    pub fn room(title: &str, legend: &Legend) -> Rect {
        let [width, height] = CANVAS.map(f64::from);
        let right = legend.left().min(width) - MARGIN;
        let top = MARGIN + if title.is_empty() { 0.0 } else { TITLE_ROOM };
        Rect::new(MARGIN + LABEL_ROOM[1], top, right, height - MARGIN - LABEL_ROOM[0])
    }

    /// Returns the area of data, in pixels.
    pub fn window(&self) -> Rect {
        Self::room(self.title, self.legend)
    }

    /// Returns the canvas position of a point in plot coordinates.
    pub fn at(&self, [x, y]: [f64; 2]) -> Point {
        let window = self.window();
        let part = |value: f64, axis: &Axis| (value - axis.range.start) / axis.span();
        Point::new(window.x0 + part(x, &self.x) * window.width(), window.y1 - part(y, &self.y) * window.height())
    }

    /// Draws axes, data by `draw`, and the legend, and writes the file.
    pub fn save(&self, path: &Path, draw: impl FnOnce(&mut Canvas)) -> Result<(), OutputError> {
        let is_svg = is_svg(path)?;
        let mut file = AtomicFile::create(path)?;
        let mut canvas = Canvas::new();
        self.draw_axes(&mut canvas);
        draw(&mut canvas);
        self.legend.draw(&mut canvas);
        let bytes = if is_svg {
            canvas.svg().into_bytes()
        } else {
            canvas.png().map_err(|problem| OutputError::Plot { path: path.to_owned(), problem })?
        };
        file.write_all(&bytes).map_err(|e| file.failed(e))?;
        file.finish()
    }

    /// Draws the grid first, so that the axes and their names are on top.
    fn draw_axes(&self, canvas: &mut Canvas) {
        let Rect { x0, y0, x1, y1 } = self.window();
        let mut line = |ends: [(f64, f64); 2], pen| {
            canvas.draw(&joined(ends.map(|p| sharp(p.into()))), None, Some(pen));
        };
        let columns = self.x.ticks().into_iter().map(|(x, text)| (self.at([x, self.y.range.start]).x, text));
        let rows = self.y.ticks().into_iter().map(|(y, text)| (self.at([self.x.range.start, y]).y, text));
        let (columns, rows): (Vec<_>, Vec<_>) = (columns.collect(), rows.collect());
        for (x, _) in &columns {
            line([(*x, y0), (*x, y1)], GRID);
            line([(*x, y1), (*x, y1 + TICK)], AXIS);
        }
        for (y, _) in &rows {
            line([(x0, *y), (x1, *y)], GRID);
            line([(x0 - TICK, *y), (x0, *y)], AXIS);
        }
        line([(x0, y0), (x0, y1)], AXIS);
        line([(x0, y1), (x1, y1)], AXIS);
        for (x, text) in &columns {
            canvas.write(text, Point::new(*x, y1 + TICK + GAP + TEXT_SIZE / 2.0), Align::Middle);
        }
        for (y, text) in &rows {
            canvas.write(text, Point::new(x0 - GAP, *y), Align::End);
        }
        let [middle_x, middle_y] = [f64::midpoint(x0, x1), f64::midpoint(y0, y1)];
        canvas.write(&self.x.label, Point::new(middle_x, y1 + LABEL_ROOM[0] - TEXT_SIZE / 2.0), Align::Middle);
        canvas.write_upwards(&self.y.label, Point::new(MARGIN + TEXT_SIZE / 2.0, middle_y));
        if !self.title.is_empty() {
            canvas.write_title(self.title, Point::new(middle_x, MARGIN + TITLE_SIZE / 2.0), TITLE_SIZE);
        }
    }
}

/// Returns the center of the pixel at a position, where a vertical line is sharp.
fn sharp(at: Point) -> Point {
    at.floor() + (0.5, 0.5)
}
