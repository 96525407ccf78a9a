//! Time against error, both logarithmic: which method is accurate enough, and which of those is fastest.
//!
//! The nearer a point is to the lower left corner, the better. Those that none beats in both are ringed, and a gray
//! staircase joins them: it is the least time that buys each error. What is wrong altogether stands on a line of its own, right of
//! every error.

use std::path::Path;

use kurbo::Point;

use super::axis::{Axis, place};
use super::canvas::{Align, Canvas, TEXT_SIZE, text_width};
use super::legend::Legend;
use super::lines::{Series, draw_line};
use super::sheet::Sheet;
use super::style::Look;
use crate::output::OutputError;

/// Both axes are logarithmic.
const LOG_LOG: [bool; 2] = [true; 2];
const FLOOR: &str = "f32 floor";
const WRONG: &str = "wrong";
/// Between a line and its name.
const GAP: f64 = 10.0;
/// From the largest error to the line of what is wrong, in decades.
const BEYOND: f64 = 0.5;

/// A work–precision plot: what it is called, its axes and its curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PrecisionPlot {
    /// What stands above; may be empty.
    pub title: String,
    /// What the error is, with its unit.
    pub x_label: String,
    /// What the time is, with its unit.
    pub y_label: String,
    /// The curves, in the order of the legend: points `[error, time]`, joined in their order. An infinite error is one that
    /// is wrong altogether. Any other point that is not finite and positive breaks its curve, and a note under the legend
    /// counts it.
    pub curves: Vec<Series>,
    /// The error that rounding to `f32` leaves to every method, if it is known.
    pub floor: Option<f64>,
}

impl PrecisionPlot {
    /// The points that are ringed, by curve and point, from the least error to the least time.
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

    /// The times of what is wrong, in plot coordinates, by curve.
    fn wrong(&self) -> Vec<Vec<f64>> {
        let wrong = |[error, time]: &[f64; 2]| place(*time, true).filter(|_| *error == f64::INFINITY);
        self.curves.iter().map(|curve| curve.points.iter().filter_map(wrong).collect()).collect()
    }

    /// The curves in plot coordinates.
    fn placed(&self) -> Vec<Vec<Option<[f64; 2]>>> {
        self.curves.iter().map(|curve| curve.placed(LOG_LOG)).collect()
    }
}

/// The points that no other is as good as in both coordinates and better than in one, from the least first coordinate
/// on; what is not finite is left out. Equal points are all kept.
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

/// Draws a work–precision plot at `path`, as SVG or PNG by its extension.
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
            Look::of(i).mark(canvas, sheet.at([beyond.unwrap_or_default(), time]));
        }
        draw_curves(canvas, &curves, &front.iter().map(at).collect::<Vec<_>>());
    })
}

fn legend(chart: &PrecisionPlot, placed: &[Vec<Option<[f64; 2]>>], wrong: &[Vec<f64>]) -> Legend {
    let missing = placed.iter().flatten().filter(|p| p.is_none()).count() - wrong.iter().flatten().count();
    let mut legend = Legend::of(chart.curves.iter().map(|c| &c.name), missing);
    if placed.iter().flatten().any(Option::is_some) {
        legend.entries.push(("Pareto front".into(), Look::BEST));
    }
    legend
}

/// Lines first and markers last, so that none of them is hidden.
fn draw_curves(canvas: &mut Canvas, curves: &[Vec<Option<Point>>], front: &[Point]) {
    Look::BEST.join(canvas, stairs(front));
    for (i, curve) in curves.iter().enumerate() {
        draw_line(canvas, curve, Look::of(i));
    }
    for at in front {
        Look::BEST.mark(canvas, *at);
    }
    for (i, curve) in curves.iter().enumerate() {
        curve.iter().flatten().for_each(|at| Look::of(i).mark(canvas, *at));
    }
}

/// From each place right to below which the next one is, and down to it.
fn stairs(front: &[Point]) -> Vec<Point> {
    let mut line: Vec<_> = front.windows(2).flat_map(|pair| [pair[0], Point::new(pair[1].x, pair[0].y)]).collect();
    line.extend(front.last());
    line
}

/// An upright line with its name at the foot, where little is: a small error takes its time.
fn draw_limit(canvas: &mut Canvas, sheet: &Sheet, error: f64, name: &str) {
    let [foot, head] = [sheet.y.range.start, sheet.y.range.end].map(|time| sheet.at([error, time]));
    Look::LIMIT.join(canvas, [foot, head]);
    let fits = foot.x + GAP + text_width(name) <= sheet.window().x1;
    let (align, aside) = if fits { (Align::Start, GAP) } else { (Align::End, -GAP) };
    canvas.write(name, foot + (aside, -GAP - TEXT_SIZE / 2.0), align);
}
