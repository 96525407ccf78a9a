//! Charts of lines with linear or logarithmic axes.

use std::path::Path;

use kurbo::Point;

use super::axis::{Axis, place};
use super::canvas::Canvas;
use super::legend::Legend;
use super::sheet::Sheet;
use super::style::Style;
use crate::output::OutputError;

/// The largest number of markers on a line; more would hide its dashes.
const MARKS: usize = 20;

/// A chart with its title, axes and lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// The title above the chart; may be empty.
    pub title: String,
    /// The label of x, with its unit.
    pub x_label: String,
    /// The label of y, with its unit.
    pub y_label: String,
    /// Is `true` if x is logarithmic.
    pub log_x: bool,
    /// Is `true` if y is logarithmic.
    pub log_y: bool,
    /// The lines, in the order of the legend.
    pub series: Vec<Series>,
}

impl Chart {
    /// Creates a chart with linear axes and these labels.
    #[must_use]
    pub fn linear(title: impl Into<String>, [x, y]: [&str; 2], series: Vec<Series>) -> Self {
        Self { title: title.into(), x_label: x.to_owned(), y_label: y.to_owned(), series, ..Self::default() }
    }

    /// Creates a chart with logarithmic axes and these labels.
    #[must_use]
    pub fn logarithmic(title: impl Into<String>, labels: [&str; 2], series: Vec<Series>) -> Self {
        Self { log_x: true, log_y: true, ..Self::linear(title, labels, series) }
    }
}

/// A line of a chart.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// The name in the legend.
    pub name: String,
    /// The points `[x, y]` in the order of the line. A point that is not finite, or not positive on a logarithmic axis, breaks the line,
    /// and a note under the legend counts it.
    pub points: Vec<[f64; 2]>,
}

impl Series {
    /// Creates a series.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { name: name.into(), points }
    }

    /// Appends a point to the series `name`, which is created if it is missing.
    pub fn extend(all: &mut Vec<Self>, name: &str, point: [f64; 2]) {
        match all.iter_mut().find(|series| series.name == name) {
            Some(series) => series.points.push(point),
            None => all.push(Self::new(name, vec![point])),
        }
    }

    /// Returns the points in plot coordinates; `None` breaks the line.
    pub(super) fn placed(&self, [log_x, log_y]: [bool; 2]) -> Vec<Option<[f64; 2]>> {
        self.points.iter().map(|[x, y]| Some([place(*x, log_x)?, place(*y, log_y)?])).collect()
    }
}

/// Draws a chart at `path`, as SVG or PNG by its extension.
///
/// # Errors
///
/// Returns [`OutputError::PlotFormat`] for another extension, and an error if the file cannot be drawn or written.
pub fn plot_lines(path: &Path, chart: &Chart) -> Result<(), OutputError> {
    let placed: Vec<_> = chart.series.iter().map(|series| series.placed([chart.log_x, chart.log_y])).collect();
    let all = || placed.iter().flatten().flatten();
    let missing = placed.iter().flatten().filter(|p| p.is_none()).count();
    let sheet = Sheet {
        title: &chart.title,
        x: Axis::around(&chart.x_label, chart.log_x, all().map(|p| p[0])),
        y: Axis::around(&chart.y_label, chart.log_y, all().map(|p| p[1])),
        legend: &Legend::of(chart.series.iter().map(|s| &s.name), missing),
    };
    sheet.save(path, |canvas| {
        for (i, line) in placed.iter().enumerate() {
            let line: Vec<_> = line.iter().map(|p| p.map(|p| sheet.at(p))).collect();
            draw_line(canvas, &line, Style::of(i));
            let every = line.len().div_ceil(MARKS).max(1);
            line.iter().step_by(every).flatten().for_each(|at| Style::of(i).mark(canvas, *at));
        }
    })
}

/// Draws a line with a break at each missing position.
pub(super) fn draw_line(canvas: &mut Canvas, line: &[Option<Point>], look: Style) {
    for part in line.split(Option::is_none) {
        look.join(canvas, part.iter().copied().flatten());
    }
}
