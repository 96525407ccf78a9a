//! Time against error, both logarithmic: which method is accurate enough, and which of those is fastest.
//!
//! The nearer a point is to the lower left corner, the better. Those that none beats in both are ringed, and a grey
//! staircase joins them: it is the least time that buys each error. What is wrong altogether stands on a line of its own, right of
//! every error.

use std::path::Path;

use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{
    Area, Drawn, OutputError, Plot, Series,
    axis::{Axis, place},
    frame,
    legend::{Legend, text_width},
    save,
    style::{Look, Place},
    write,
};

const FLOOR: &str = "f32 floor";
const WRONG: &str = "wrong";
/// Between a line and its name.
const GAP: i32 = 10;
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
            .filter(|(_, point)| log_log(*point).is_some())
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
        self.curves.iter().map(|curve| curve.points.iter().map(|point| log_log(*point)).collect()).collect()
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
    let x = Axis::around(&chart.x_label, true, all().map(|p| p[0]).chain(floor).chain(beyond));
    let y = Axis::around(&chart.y_label, true, all().map(|p| p[1]).chain(wrong.iter().flatten().copied()));
    let front: Vec<_> = chart.front().into_iter().filter_map(|(curve, point)| placed[curve][point]).collect();
    save(path, &legend(chart, &placed, &wrong), |canvas, area| {
        let plot = frame(area, &chart.title, &x, &y)?;
        if let Some(floor) = floor {
            draw_limit(canvas, &plot, (floor, FLOOR), [&x, &y])?;
        }
        if let Some(beyond) = beyond {
            draw_limit(canvas, &plot, (beyond, WRONG), [&x, &y])?;
            let mut marks = wrong.iter().enumerate().flat_map(|(i, times)| times.iter().map(move |time| (i, *time)));
            marks.try_for_each(|(i, time)| Look::of(i).mark(canvas, plot.backend_coord(&(beyond, time))))?;
        }
        let at = |p: &[f64; 2]| plot.backend_coord(&(p[0], p[1]));
        let curves: Vec<Vec<_>> =
            placed.iter().map(|curve| curve.iter().map(|p| p.as_ref().map(at)).collect()).collect();
        draw_curves(canvas, &curves, &front.iter().map(at).collect::<Vec<_>>())
    })
}

/// A point in plot coordinates, if it has any.
fn log_log([error, time]: [f64; 2]) -> Option<[f64; 2]> {
    Some([place(error, true)?, place(time, true)?])
}

fn legend(chart: &PrecisionPlot, placed: &[Vec<Option<[f64; 2]>>], wrong: &[Vec<f64>]) -> Legend {
    let missing = placed.iter().flatten().filter(|p| p.is_none()).count() - wrong.iter().flatten().count();
    let mut legend = Legend::of(chart.curves.iter().map(|c| &c.name), missing);
    if placed.iter().flatten().any(Option::is_some) {
        legend.entries.push(("Pareto front".into(), Look::best()));
    }
    legend
}

/// Lines first and markers last, so that none of them is hidden.
fn draw_curves(canvas: &Area, curves: &[Vec<Option<Place>>], front: &[Place]) -> Drawn<()> {
    Look::best().stroke(canvas, stairs(front))?;
    for (i, curve) in curves.iter().enumerate() {
        for part in curve.split(Option::is_none) {
            Look::of(i).stroke(canvas, part.iter().copied().flatten().collect())?;
        }
    }
    front.iter().try_for_each(|at| Look::best().mark(canvas, *at))?;
    for (i, curve) in curves.iter().enumerate() {
        curve.iter().flatten().try_for_each(|at| Look::of(i).mark(canvas, *at))?;
    }
    Ok(())
}

/// From each place right to below which the next one is, and down to it.
fn stairs(front: &[Place]) -> Vec<Place> {
    let mut line: Vec<_> = front.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]).collect();
    line.extend(front.last());
    line
}

/// An upright line with its name at the foot, where little is: a small error takes its time.
fn draw_limit(canvas: &Area, plot: &Plot, (error, name): (f64, &str), [x, y]: [&Axis; 2]) -> Drawn<()> {
    let foot = plot.backend_coord(&(error, y.range.start));
    let head = plot.backend_coord(&(error, y.range.end));
    Look::limit().stroke(canvas, vec![foot, head])?;
    let (right, _) = plot.backend_coord(&(x.range.end, y.range.start));
    let fits = foot.0 + GAP + text_width(name) <= right;
    let (h_pos, gap) = if fits { (HPos::Left, GAP) } else { (HPos::Right, -GAP) };
    write(canvas, name, (foot.0 + gap, foot.1 - GAP), Pos::new(h_pos, VPos::Bottom))
}
