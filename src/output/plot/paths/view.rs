//! Which part of the plane is shown, and where it is on the canvas.

use glam::{DVec2, DVec3};

use super::clip::Window;
use super::{Frame, PathPlot};
use crate::output::plot::{Plot, axis::Axis, data_size, legend::Legend};
use crate::scene::{CutPlane, Outline};

/// By how much a frame about objects goes beyond them: by half of their size.
const ROOM: f64 = 1.5;

/// Surfaces that come nearer to the bound than this part of its radius go on for ever.
const WITHIN: f64 = 0.99;

/// Axes on which a unit is equally long, about what the frame asks for; the shorter side shows more.
pub(super) fn axes(plot: &PathPlot, legend: &Legend) -> (Axis, Axis) {
    let [right, up] = plot.plane.names().map(|name| format!("{name} (scene units)"));
    let (mut x, mut y) = if let Some(Window { low, high }) = asked(plot) {
        (Axis::over(&right, low.x..high.x), Axis::over(&up, low.y..high.y))
    } else {
        let points = everything(plot);
        let along = |k: usize| points.iter().map(move |p| p[k]);
        (Axis::around(&right, false, along(0)), Axis::around(&up, false, along(1)))
    };
    let (width, height) = data_size(legend);
    let unit = (x.span() / width).max(y.span() / height);
    x.widen(unit * width);
    y.widen(unit * height);
    (x, y)
}

/// The rectangle that the frame names; none for everything.
fn asked(plot: &PathPlot) -> Option<Window> {
    match plot.frame {
        Frame::All => None,
        Frame::Given([left, right, bottom, top]) => {
            Some(Window { low: DVec2::new(left, bottom), high: DVec2::new(right, top) })
        }
        Frame::Objects => {
            // A floor that goes on to the bound is no place to look at, unless there is nothing else.
            let is_whole = |outline: &&Outline| outline.points.iter().all(|p| is_well_within(*p, plot.bound));
            let outlines = || plot.surfaces.iter().flat_map(|surface| &surface.outlines);
            about(outlines().filter(is_whole), plot).or_else(|| about(outlines(), plot))
        }
    }
}

fn is_well_within(p: DVec3, bound: Option<(DVec3, f64)>) -> bool {
    bound.is_none_or(|(center, radius)| p.distance(center) < WITHIN * radius)
}

/// A box about outlines, with room, as far as rays come.
fn about<'o>(outlines: impl Iterator<Item = &'o Outline>, plot: &PathPlot) -> Option<Window> {
    let within = |p: DVec2| {
        plot.bound.map_or(p, |(center, radius)| {
            let middle = DVec2::from(plot.plane.flat(center));
            p.clamp(middle - radius, middle + radius)
        })
    };
    let (low, high) = outlines
        .flat_map(|outline| &outline.points)
        .map(|p| within(plot.plane.flat(*p).into()))
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    let half = (high - low) / 2.0 * ROOM;
    let middle = low.midpoint(high);
    (half.max_element() > 0.0 && half.is_finite()).then(|| Window { low: middle - half, high: middle + half })
}

/// All paths and the bound.
fn everything(plot: &PathPlot) -> Vec<DVec2> {
    let flat = |p| DVec2::from(plot.plane.flat(p));
    let arcs = plot.lines.iter().flat_map(|line| &line.curve.0);
    let mut points: Vec<_> = arcs.flatten().map(|p| flat(*p)).collect();
    if let Some((center, radius)) = plot.bound {
        points.extend([flat(center) - radius, flat(center) + radius]);
    }
    points
}

/// From the plane to fractions of pixels of the canvas.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    plane: CutPlane,
    /// What is shown, in the plane's units.
    pub window: Window,
    /// Where the window's low corner is, in pixels.
    corner: DVec2,
    /// Pixels a unit; downwards on the canvas is upwards in the plane.
    unit: DVec2,
}

impl View {
    pub fn new(plane: CutPlane, plot: &Plot, x: &Axis, y: &Axis) -> Self {
        let place = |x: f64, y: f64| {
            let (x, y) = plot.backend_coord(&(x, y));
            DVec2::new(x.into(), y.into())
        };
        let window =
            Window { low: DVec2::new(x.range.start, y.range.start), high: DVec2::new(x.range.end, y.range.end) };
        let [low, high] = [window.low, window.high].map(|p| place(p.x, p.y));
        Self { plane, window, corner: low, unit: (high - low) / (window.high - window.low) }
    }

    /// A point's place in the plane.
    pub fn flat(&self, p: DVec3) -> DVec2 {
        self.plane.flat(p).into()
    }

    /// Where a place of the plane is on the canvas.
    pub fn pixel(&self, p: DVec2) -> DVec2 {
        self.corner + (p - self.window.low) * self.unit
    }
}
