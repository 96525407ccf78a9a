//! Paths of rays, seen along one coordinate axis.
//!
//! The two axes in which the paths extend furthest are shown, at the same scale. A path is drawn by how its ray
//! ended, with a marker where it did.

use std::{f64::consts::TAU, path::Path};

use super::{Area, Drawn, OutputError, Plot, axis::Axis, data_size, frame, legend::Legend, save, style::Look};

const AXIS_NAMES: [&str; 3] = ["x", "y", "z"];
/// Corners of the polygon that is drawn for a circle.
const CIRCLE_CORNERS: i32 = 180;

/// The path of one ray.
#[derive(Debug, Clone, PartialEq)]
pub struct PathLine<'a> {
    /// Points along it in scene coordinates; it is broken where one is not finite.
    pub points: Vec<[f64; 3]>,
    /// The name of how the ray ended.
    pub status: &'a str,
}

/// Draws paths at `path`, as SVG or PNG by its extension, with the outline of the bounding ball `(center, radius)` if
/// there is one.
pub fn plot_paths(path: &Path, lines: &[PathLine], bound: Option<([f64; 3], f64)>) -> Result<(), OutputError> {
    let axes = widest_axes(lines);
    let project = |p: &[f64; 3]| [p[axes[0]], p[axes[1]]];
    let circle: Vec<_> = bound.map(|(center, radius)| circle(project(&center), radius)).unwrap_or_default();
    let flat: Vec<Vec<_>> = lines.iter().map(|line| line.points.iter().map(project).collect()).collect();
    let statuses = statuses(lines);
    let legend = legend(&statuses, bound.is_some());
    let (x, y) = equal_axes(axes, flat.iter().flatten().chain(&circle), &legend);
    save(path, &legend, |canvas, area| {
        let plot = frame(area, "", &x, &y)?;
        draw(canvas, &plot, &circle, Look::aside())?;
        for (points, line) in flat.iter().zip(lines) {
            let series = statuses.iter().position(|s| *s == line.status);
            draw(canvas, &plot, points, Look::of(series.unwrap_or(0)))?;
        }
        Ok(())
    })
}

/// The two coordinates in which the points spread most, in their usual order.
fn widest_axes(lines: &[PathLine]) -> [usize; 2] {
    let spread = |axis: usize| {
        let values = lines.iter().flat_map(|l| &l.points).map(|p| p[axis]);
        let (low, high) = values
            .filter(|v| v.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        high - low
    };
    let spreads = [0, 1, 2].map(spread);
    // Of equal spreads the later axis is left out.
    let least = (0..3).fold(2, |least, axis| if spreads[axis] < spreads[least] { axis } else { least });
    match least {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    }
}

/// The ways in which rays ended, each once, sorted.
fn statuses<'a>(lines: &[PathLine<'a>]) -> Vec<&'a str> {
    let mut statuses: Vec<_> = lines.iter().map(|line| line.status).collect();
    statuses.sort_unstable();
    statuses.dedup();
    statuses
}

fn legend(statuses: &[&str], has_bound: bool) -> Legend {
    let bound = has_bound.then(|| ("bound".to_owned(), Look::aside()));
    Legend {
        entries: statuses
            .iter()
            .enumerate()
            .map(|(i, status)| ((*status).to_owned(), Look::of(i)))
            .chain(bound)
            .collect(),
        notes: Vec::new(),
    }
}

fn circle([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    (0..=CIRCLE_CORNERS)
        .map(|i| TAU * f64::from(i) / f64::from(CIRCLE_CORNERS))
        .map(|angle| [x + radius * angle.cos(), y + radius * angle.sin()])
        .collect()
}

/// Axes around the points, on which a unit is equally long.
fn equal_axes<'a>(
    axes: [usize; 2],
    points: impl Iterator<Item = &'a [f64; 2]> + Clone,
    legend: &Legend,
) -> (Axis, Axis) {
    let finite = points.filter(|p| is_finite(p));
    let label = |i: usize| format!("{} (scene units)", AXIS_NAMES[axes[i]]);
    let mut x = Axis::around(&label(0), false, finite.clone().map(|p| p[0]));
    let mut y = Axis::around(&label(1), false, finite.map(|p| p[1]));
    let (width, height) = data_size(legend);
    let unit = (x.span() / width).max(y.span() / height);
    x.widen(unit * width);
    y.widen(unit * height);
    (x, y)
}

fn is_finite(point: &[f64; 2]) -> bool {
    point.iter().all(|v| v.is_finite())
}

/// Draws a path, with a marker at its end if it has one.
fn draw(canvas: &Area, plot: &Plot, points: &[[f64; 2]], look: Look) -> Drawn<()> {
    let place = |p: &[f64; 2]| plot.backend_coord(&(p[0], p[1]));
    for part in points.split(|p| !is_finite(p)) {
        look.stroke(canvas, part.iter().map(place).collect())?;
    }
    match points.iter().rev().find(|p| is_finite(p)) {
        Some(end) => look.mark(canvas, place(end)),
        None => Ok(()),
    }
}
