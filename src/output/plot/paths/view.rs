//! The visible range of the plane, and its mapping to the canvas.

use glam::{DVec2, DVec3};
use kurbo::{CubicBez, ParamCurve, PathSeg, Point, Rect};

use super::contents::{PathPlot, PlotRange};
use crate::output::plot::axis::Axis;
use crate::output::plot::legend::Legend;
use crate::output::plot::sheet::Sheet;
use crate::scene::{CutPlane, Outline};

/// The factor by which a range around objects exceeds them.
const ROOM: f64 = 1.5;
/// The fraction of the bounding radius beyond which a surface counts as unlimited.
const WITHIN: f64 = 0.99;
/// The distance to the window's edge in pixels within which points count as visible.
const EDGE: f64 = 1e-6;
/// The error in pixels of clipping at the edge.
const FINE: f64 = 0.01;

/// Returns axes of equal scale around the requested range; the shorter side shows more.
pub(super) fn axes(plot: &PathPlot, legend: &Legend) -> (Axis, Axis) {
    let [right, up] = plot.plane.names().map(|name| format!("{name} (scene units)"));
    let (mut x, mut y) = if let Some([low, high]) = asked(plot) {
        (Axis::over(&right, low.x..high.x), Axis::over(&up, low.y..high.y))
    } else {
        let points = everything(plot);
        let along = |k: usize| points.iter().map(move |p| p[k]);
        (Axis::around(&right, false, along(0)), Axis::around(&up, false, along(1)))
    };
    let room = Sheet::room("", legend);
    let unit = (x.span() / room.width()).max(y.span() / room.height());
    x.widen(unit * room.width());
    y.widen(unit * room.height());
    (x, y)
}

/// Returns the corners of the requested range, or `None` for everything.
fn asked(plot: &PathPlot) -> Option<[DVec2; 2]> {
    match plot.range {
        PlotRange::All => None,
        PlotRange::Given([left, right, bottom, top]) => Some([DVec2::new(left, bottom), DVec2::new(right, top)]),
        PlotRange::Objects => {
            // A floor that extends to the bounding sphere is ignored, unless there is nothing else.
            let is_whole = |outline: &&Outline| outline.points.iter().all(|p| is_well_within(*p, plot.bound));
            let outlines = || plot.surfaces.iter().flat_map(|surface| &surface.outlines);
            about(outlines().filter(is_whole), plot).or_else(|| about(outlines(), plot))
        }
    }
}

fn is_well_within(p: DVec3, bound: Option<(DVec3, f64)>) -> bool {
    bound.is_none_or(|(center, radius)| p.distance(center) < WITHIN * radius)
}

/// Returns an enlarged box around outlines, limited to the extent of rays.
fn about<'o>(outlines: impl Iterator<Item = &'o Outline>, plot: &PathPlot) -> Option<[DVec2; 2]> {
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
    (half.max_element() > 0.0 && half.is_finite()).then(|| [middle - half, middle + half])
}

/// Returns points of all paths and of the bounding sphere.
fn everything(plot: &PathPlot) -> Vec<DVec2> {
    let flat = |p| DVec2::from(plot.plane.flat(p));
    let arcs = plot.lines.iter().flat_map(|line| &line.curve.0);
    let mut points: Vec<_> = arcs.flatten().map(|p| flat(*p)).collect();
    if let Some((center, radius)) = plot.bound {
        points.extend([flat(center) - radius, flat(center) + radius]);
    }
    points
}

/// The mapping of the scene to the canvas.
pub(super) struct View<'s> {
    plane: CutPlane,
    sheet: &'s Sheet<'s>,
    /// The visible range in pixels.
    pub window: Rect,
}

impl<'s> View<'s> {
    pub fn new(plane: CutPlane, sheet: &'s Sheet) -> Self {
        Self { plane, sheet, window: sheet.window() }
    }

    /// Returns the canvas position of a scene point's projection.
    pub fn at(&self, p: DVec3) -> Point {
        self.sheet.at(self.plane.flat(p))
    }

    /// Returns a length in pixels.
    pub fn length(&self, units: f64) -> f64 {
        units * self.window.width() / self.sheet.x.span()
    }

    pub fn shows(&self, at: Point) -> bool {
        self.window.inflate(EDGE, EDGE).contains(at)
    }

    /// Returns the parts of a segment in the window, in order, by bisection. The canvas clips as well; but a much larger segment has too
    /// many dashes to draw, and a label or an arrow belongs to a visible part.
    pub fn visible(&self, segment: PathSeg) -> Vec<PathSeg> {
        let window = self.window.inflate(EDGE, EDGE);
        let mut seen: Vec<[f64; 2]> = Vec::new();
        let mut left = vec![[0.0, 1.0]];
        while let Some([from, to]) = left.pop() {
            let CubicBez { p0, p1, p2, p3 } = segment.subsegment(from..to).to_cubic();
            let hull = Rect::from_points(p0, p3).union_pt(p1).union_pt(p2);
            if !hull.overlaps(window) {
                continue;
            }
            if window.contains_rect(hull) {
                match seen.last_mut() {
                    Some(last) if last[1] >= from => last[1] = to,
                    _ => seen.push([from, to]),
                }
            } else if hull.width().max(hull.height()) > FINE {
                let middle = f64::midpoint(from, to);
                left.extend([[middle, to], [from, middle]]);
            }
        }
        seen.into_iter().map(|[from, to]| segment.subsegment(from..to)).collect()
    }
}
