//! Work–precision diagrams of time against error on logarithmic axes, which show the fastest method for each accuracy.
//!
//! Points closer to the lower left corner are better. Rings mark the Pareto front, and a gray staircase joins it: the least time for each
//! error. Gross errors are on a separate line, to the right of all errors.

use std::path::Path;

use kurbo::Point;

use super::axis::{Axis, place};
use super::canvas::{Align, Canvas, TEXT_SIZE, text_width};
use super::legend::Legend;
use super::lines::{Series, draw_line};
use super::sheet::Sheet;
use super::style::Style;
use crate::output::OutputError;

/// Both axes are logarithmic.
const LOG_LOG: [bool; 2] = [true; 2];
const FLOOR: &str = "smallest error";
const WRONG: &str = "wrong";
/// The distance between a line and its name.
const GAP: f64 = 10.0;
/// The distance from the largest error to the line of gross errors, in decades.
const BEYOND: f64 = 0.5;

/// A work–precision diagram with its title, axes and curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PrecisionPlot {
    /// The title above the diagram; may be empty.
    pub title: String,
    /// The label of the error, with its unit.
    pub x_label: String,
    /// The label of the time, with its unit.
    pub y_label: String,
    /// The curves in the order of the legend, with points `[error, time]` in the order of the line. An infinite error is a gross error.
    /// Another point that is not finite and positive breaks its curve, and a note under the legend counts it.
    pub curves: Vec<Series>,
    /// The error that rounding to `f32` causes for every method, if it is known.
    pub floor: Option<f64>,
}

impl PrecisionPlot {
    /// Returns the Pareto front by curve and point, from the least error to the least time.
    #[must_use]
    pub fn front(&self) -> Vec<(usize, usize)> {
        let (places, points): (Vec<_>, Vec<_>) = self
            .curves
            .iter()
            .enumerate()
            .flat_map(|(i, curve)| curve.points.iter().enumerate().map(move |(k, point)| ((i, k), *point)))
            .filter(|(_, [error, time])| place(*error, true).and(place(*time, true)).is_some())
            .unzip();
        pareto_front(&points).into_iter().map(|i| places[i]).collect()
    }

    /// Returns the times of gross errors in plot coordinates, by curve.
    fn wrong(&self) -> Vec<Vec<f64>> {
        let wrong = |[error, time]: &[f64; 2]| place(*time, true).filter(|_| *error == f64::INFINITY);
        self.curves.iter().map(|curve| curve.points.iter().filter_map(wrong).collect()).collect()
    }

    /// Returns the curves in plot coordinates.
    fn placed(&self) -> Vec<Vec<Option<[f64; 2]>>> {
        self.curves.iter().map(|curve| curve.placed(LOG_LOG)).collect()
    }
}

/// Returns the Pareto front of minimal points in the order of the first coordinate, without points that are not finite. Equal points are
/// all included.
#[must_use]
pub fn pareto_front(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<_> = (0..points.len()).filter(|i| points[*i].iter().all(|v| v.is_finite())).collect();
    order.sort_by(|a, b| points[*a].partial_cmp(&points[*b]).unwrap_or(std::cmp::Ordering::Equal));
    let mut front: Vec<usize> = Vec::new();
    for i in order {
        if front.last().is_none_or(|last| points[i][1] < points[*last][1] || same(&points[i], &points[*last])) {
            front.push(i);
        }
    }
    front
}

#[allow(clippy::float_cmp)] // 0 and −0 are the same place
fn same(a: &[f64; 2], b: &[f64; 2]) -> bool {
    a == b
}

/// Draws a work–precision diagram at `path`, as SVG or PNG by its extension.
///
/// # Errors
///
/// Returns [`OutputError::PlotFormat`] for another extension, and an error if the file cannot be drawn or written.
pub fn plot_precision(path: &Path, chart: &PrecisionPlot) -> Result<(), OutputError> {
    let placed = chart.placed();
    let all = || placed.iter().flatten().flatten();
    let floor = chart.floor.and_then(|floor| place(floor, true));
    let wrong = chart.wrong();
    let largest = all().map(|p| p[0]).chain(floor).fold(f64::NEG_INFINITY, f64::max);
    let beyond =
        Some(if largest.is_finite() { largest + BEYOND } else { 0.0 }).filter(|_| wrong.iter().any(|w| !w.is_empty()));
    let sheet = Sheet {
        title: &chart.title,
        x: Axis::around(&chart.x_label, true, all().map(|p| p[0]).chain(floor).chain(beyond)),
        y: Axis::around(&chart.y_label, true, all().map(|p| p[1]).chain(wrong.iter().flatten().copied())),
        legend: &legend(chart, &placed, &wrong),
    };
    let front: Vec<_> = chart.front().into_iter().filter_map(|(curve, point)| placed[curve][point]).collect();
    let at = |p: &[f64; 2]| sheet.at(*p);
    let curves: Vec<Vec<_>> = placed.iter().map(|curve| curve.iter().map(|p| p.as_ref().map(at)).collect()).collect();
    sheet.save(path, |canvas| {
        for (error, name) in [(floor, FLOOR), (beyond, WRONG)] {
            if let Some(error) = error {
                draw_limit(canvas, &sheet, error, name);
            }
        }
        for (i, time) in wrong.iter().enumerate().flat_map(|(i, times)| times.iter().map(move |time| (i, *time))) {
            Style::of(i).mark(canvas, sheet.at([beyond.unwrap_or_default(), time]));
        }
        draw_curves(canvas, &curves, &front.iter().map(at).collect::<Vec<_>>());
    })
}

fn legend(chart: &PrecisionPlot, placed: &[Vec<Option<[f64; 2]>>], wrong: &[Vec<f64>]) -> Legend {
    let missing = placed.iter().flatten().filter(|p| p.is_none()).count() - wrong.iter().flatten().count();
    let mut legend = Legend::of(chart.curves.iter().map(|c| &c.name), missing);
    if placed.iter().flatten().any(Option::is_some) {
        legend.entries.push(("Pareto front".into(), Style::BEST));
    }
    legend
}

/// Draws lines first and markers last, so that no marker is hidden.
fn draw_curves(canvas: &mut Canvas, curves: &[Vec<Option<Point>>], front: &[Point]) {
    Style::BEST.join(canvas, stairs(front));
    for (i, curve) in curves.iter().enumerate() {
        draw_line(canvas, curve, Style::of(i));
    }
    for at in front {
        Style::BEST.mark(canvas, *at);
    }
    for (i, curve) in curves.iter().enumerate() {
        curve.iter().flatten().for_each(|at| Style::of(i).mark(canvas, *at));
    }
}

/// Returns a staircase, which goes right to below the next point, and then down to it.
fn stairs(front: &[Point]) -> Vec<Point> {
    let mut line: Vec<_> = front.windows(2).flat_map(|pair| [pair[0], Point::new(pair[1].x, pair[0].y)]).collect();
    line.extend(front.last());
    line
}

/// Draws a vertical line with its name at the bottom, where points are rare, because small errors take time.
fn draw_limit(canvas: &mut Canvas, sheet: &Sheet, error: f64, name: &str) {
    let [foot, head] = [sheet.y.range.start, sheet.y.range.end].map(|time| sheet.at([error, time]));
    Style::LIMIT.join(canvas, [foot, head]);
    let fits = foot.x + GAP + text_width(name) <= sheet.window().x1;
    let (align, aside) = if fits { (Align::Start, GAP) } else { (Align::End, -GAP) };
    canvas.write(name, foot + (aside, -GAP - TEXT_SIZE / 2.0), align);
}
