//! The drawing of rays' paths and surfaces' outlines.

use glam::DVec3;
use kurbo::{
    BezPath, Circle, CubicBez, Line, ParamCurve, ParamCurveArclen, ParamCurveDeriv, PathSeg, Point, Shape, Vec2,
};

use super::contents::{CrossSection, SurfaceKind};
use super::view::View;
use crate::measure::Curve;
use crate::output::plot::canvas::Canvas;
use crate::output::plot::style::{Style, ring};

/// The distance from the chord in pixels below which an arc is drawn as a line.
const FLAT: f64 = 0.02;
/// The distance in pixels below which a point is skipped.
const NEAR: f64 = 0.4;
/// The error of lengths and circles in pixels.
const ACCURACY: f64 = 0.01;
/// The visible length in pixels below which a path has no arrow.
const SHORT: f64 = 60.0;
/// The position of the arrow along the visible path.
const ARROW_AT: f64 = 0.4;
/// The length and half width of an arrow's head in pixels.
const ARROW: [f64; 2] = [20.0, 7.0];

/// Returns the visible part of the bounding circle.
pub(super) fn bound(view: &View, (center, radius): (DVec3, f64)) -> BezPath {
    let circle = Circle::new(view.at(center), view.length(radius)).to_path(ACCURACY);
    BezPath::from_path_segments(circle.segments().flat_map(|arc| view.visible(arc)))
}

/// Fills the inside of a closed surface; a hole of an outline stays empty.
pub(super) fn fill(canvas: &mut Canvas, view: &View, surface: &CrossSection) {
    let Some(opacity) = opacity(surface.kind) else { return };
    let closed = surface.outlines.iter().filter(|outline| outline.closed);
    let area: BezPath = closed.flat_map(|outline| polygon(view, &outline.points)).collect();
    canvas.draw(&area, Some(look(surface.kind).fill(opacity)), None);
}

/// Strokes the outline of a surface.
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

/// Draws the visible part of a curve, and returns its arcs.
pub(super) fn line(canvas: &mut Canvas, view: &View, curve: &Curve, look: Style) -> Vec<PathSeg> {
    let seen: Vec<PathSeg> = curve.0.iter().flat_map(|arc| view.visible(segment(arc.map(|p| view.at(p))))).collect();
    look.stroke(canvas, &thinned(&seen));
    seen
}

/// Strokes a ray's path with an arrow, and returns its last visible position and its direction there.
pub(super) fn path(canvas: &mut Canvas, view: &View, curve: &Curve, look: Style) -> Option<[Point; 2]> {
    let seen = line(canvas, view, curve, look);
    if let Some(head) = arrow(&seen) {
        canvas.draw(&head, Some(look.fill(1.0)), None);
    }
    seen.last().map(|last| [last.end(), last.end() + direction(last, 1.0)])
}

/// Returns a segment, which is a line if it does not bend.
fn segment([a, b, c, d]: [Point; 4]) -> PathSeg {
    let chord = d - a;
    let off = |p: Point| if chord == Vec2::ZERO { p.distance(a) } else { chord.normalize().cross(p - a).abs() };
    if off(b).max(off(c)) < FLAT { PathSeg::Line(Line::new(a, d)) } else { PathSeg::Cubic(CubicBez::new(a, b, c, d)) }
}

/// Joins segments to one path, without those that are too short to be visible.
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
        // Where segments were left out, the path ends near the start of this one.
        path.push(segment.as_path_el());
        at = Some(end);
    }
    path
}

/// Returns the head of an arrow on a path, if there is room for one.
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

/// Returns the unit tangent of a segment at a parameter.
fn direction(segment: &PathSeg, t: f64) -> Vec2 {
    let along = segment.to_cubic().deriv().eval(t).to_vec2();
    let along = if along.hypot() > 0.0 { along } else { segment.end() - segment.start() };
    if along.hypot() > 0.0 { along.normalize() } else { Vec2::new(1.0, 0.0) }
}

/// Returns the style of a surface.
pub(super) fn look(kind: SurfaceKind) -> Style {
    match kind {
        SurfaceKind::Opaque => Style::SOLID,
        SurfaceKind::Medium => Style::GLASS,
        SurfaceKind::Capture(_) => Style::HOLE,
        SurfaceKind::Limit(_) => Style::LIMIT,
    }
}

/// Returns the opacity of a surface's fill, if light enters or ends in it.
fn opacity(kind: SurfaceKind) -> Option<f64> {
    match kind {
        SurfaceKind::Medium => Some(0.2),
        SurfaceKind::Capture(_) => Some(0.6),
        SurfaceKind::Opaque | SurfaceKind::Limit(_) => None,
    }
}
