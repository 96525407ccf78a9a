//! Paths of rays and outlines of surfaces on the canvas.

use glam::DVec3;
use kurbo::{
    BezPath, Circle, CubicBez, Line, ParamCurve, ParamCurveArclen, ParamCurveDeriv, PathEl, PathSeg, Point, Shape, Vec2,
};

use super::contents::{CrossSection, SurfaceKind};
use super::view::View;
use crate::measure::Curve;
use crate::output::plot::canvas::Canvas;
use crate::output::plot::style::{Look, ring};

/// Arcs that differ from their chord by less than this many pixels are drawn as lines.
const FLAT: f64 = 0.02;
/// Points nearer than this to the last one, in pixels, are not drawn.
const NEAR: f64 = 0.4;
/// To how much of a pixel lengths and circles are right.
const ACCURACY: f64 = 0.01;
/// Paths that are visible for fewer pixels than this get no arrow.
const SHORT: f64 = 60.0;
/// Where on the visible path its arrow is.
const ARROW_AT: f64 = 0.4;
/// Length and half the width of an arrow's head in pixels.
const ARROW: [f64; 2] = [20.0, 7.0];

/// What is seen of the circle that bounds all rays.
pub(super) fn bound(view: &View, (center, radius): (DVec3, f64)) -> BezPath {
    let circle = Circle::new(view.at(center), view.length(radius)).to_path(ACCURACY);
    BezPath::from_path_segments(circle.segments().flat_map(|arc| view.visible(arc)))
}

/// Fills the inside of what has one: a hole of an outline stays empty.
pub(super) fn fill(canvas: &mut Canvas, view: &View, surface: &CrossSection) {
    let Some(opacity) = opacity(surface.kind) else { return };
    let closed = surface.outlines.iter().filter(|outline| outline.closed);
    let area: BezPath = closed.flat_map(|outline| polygon(view, &outline.points)).collect();
    canvas.draw(&area, Some(look(surface.kind).fill(opacity)), None);
}

/// Strokes where a surface crosses the plane.
pub(super) fn outline(canvas: &mut Canvas, view: &View, surface: &CrossSection) {
    let mut path = BezPath::new();
    for outline in &surface.outlines {
        if outline.closed && outline.points.iter().all(|p| view.shows(view.at(*p))) {
            path.extend(polygon(view, &outline.points));
            continue;
        }
        let first = outline.points.first().filter(|_| outline.closed);
        let places: Vec<_> = outline.points.iter().chain(first).map(|p| view.at(*p)).collect();
        let sides = places.windows(2).map(|ends| PathSeg::Line(Line::new(ends[0], ends[1])));
        path.extend(BezPath::from_path_segments(sides.flat_map(|side| view.visible(side))));
    }
    look(surface.kind).stroke(canvas, &path);
}

fn polygon(view: &View, corners: &[DVec3]) -> BezPath {
    ring(corners.iter().map(|p| view.at(*p)))
}

/// A curve as far as it is in view: its arcs there.
pub(super) fn line(canvas: &mut Canvas, view: &View, curve: &Curve, look: Look) -> Vec<PathSeg> {
    let seen: Vec<PathSeg> = curve.0.iter().flat_map(|arc| view.visible(segment(arc.map(|p| view.at(p))))).collect();
    look.stroke(canvas, &thinned(&seen));
    seen
}

/// Strokes a ray's path with an arrow on it, and says where it is last seen and in which direction it goes there.
pub(super) fn path(canvas: &mut Canvas, view: &View, curve: &Curve, look: Look) -> Option<[Point; 2]> {
    let seen = line(canvas, view, curve, look);
    if let Some(head) = arrow(&seen) {
        canvas.draw(&head, Some(look.fill(1.0)), None);
    }
    seen.last().map(|last| [last.end(), last.end() + direction(last, 1.0)])
}

/// A segment that is a curve only if it bends.
fn segment([a, b, c, d]: [Point; 4]) -> PathSeg {
    let chord = d - a;
    let off = |p: Point| if chord == Vec2::ZERO { p.distance(a) } else { chord.normalize().cross(p - a).abs() };
    if off(b).max(off(c)) < FLAT { PathSeg::Line(Line::new(a, d)) } else { PathSeg::Cubic(CubicBez::new(a, b, c, d)) }
}

/// Segments as one path, without those that are too short to be seen.
fn thinned(segments: &[PathSeg]) -> BezPath {
    let mut path = BezPath::new();
    let mut at: Option<Point> = None;
    for (i, segment) in segments.iter().enumerate() {
        let (start, end) = (segment.start(), segment.end());
        if i == 0 || start.distance(segments[i - 1].end()) > NEAR {
            path.move_to(start);
            at = Some(start);
        }
        let is_last = segments.get(i + 1).is_none_or(|next| next.start().distance(end) > NEAR);
        if !is_last && at.is_some_and(|at| at.distance(end) < NEAR) {
            continue;
        }
        path.push(if at == Some(start) { segment.as_path_el() } else { PathEl::LineTo(end) });
        at = Some(end);
    }
    path
}

/// The head of an arrow on a path, if there is room for one.
fn arrow(segments: &[PathSeg]) -> Option<BezPath> {
    let lengths: Vec<f64> = segments.iter().map(|segment| segment.arclen(ACCURACY)).collect();
    let whole: f64 = lengths.iter().sum();
    let mut left = whole * ARROW_AT;
    let (segment, _) = segments.iter().zip(lengths).filter(|_| whole > SHORT).find(|(_, length)| {
        left -= length;
        left < 0.0
    })?;
    let t = segment.inv_arclen(left + segment.arclen(ACCURACY), ACCURACY);
    let along = direction(segment, t);
    let [length, half] = ARROW;
    let tip = segment.eval(t) + along * (length / 2.0);
    let aside = Vec2::new(-along.y, along.x) * half;
    Some(ring([tip, tip - along * length + aside, tip - along * length - aside]))
}

/// The unit vector along a segment at a value of its parameter.
fn direction(segment: &PathSeg, t: f64) -> Vec2 {
    let along = segment.to_cubic().deriv().eval(t).to_vec2();
    let along = if along.hypot() > 0.0 { along } else { segment.end() - segment.start() };
    if along.hypot() > 0.0 { along.normalize() } else { Vec2::new(1.0, 0.0) }
}

/// How something that crosses the plane is drawn.
pub(super) fn look(kind: SurfaceKind) -> Look {
    match kind {
        SurfaceKind::Opaque => Look::SOLID,
        SurfaceKind::Medium => Look::GLASS,
        SurfaceKind::Capture(_) => Look::HOLE,
        SurfaceKind::Limit(_) => Look::LIMIT,
    }
}

/// How much of what is behind it the inside of a surface hides, if light comes or stays in it.
fn opacity(kind: SurfaceKind) -> Option<f64> {
    match kind {
        SurfaceKind::Medium => Some(0.2),
        SurfaceKind::Capture(_) => Some(0.6),
        SurfaceKind::Opaque | SurfaceKind::Limit(_) => None,
    }
}
