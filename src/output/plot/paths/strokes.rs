//! Lines, areas and curves on the canvas, cut off at the frame.

use glam::DVec2;
use tiny_skia::{Path, PathBuilder};

use super::clip::Arc;
use super::view::View;
use super::{Surface, SurfaceKind};
use crate::measure::Curve;
use crate::output::plot::figure::Figure;
use crate::output::plot::style::{Look, Place};
use crate::output::plot::{Area, Drawn, words};

/// Arcs that differ from their chord by less than this many pixels are drawn as lines.
const FLAT: f64 = 0.02;
/// Points nearer than this to the last one, in pixels, are not drawn.
const NEAR: f64 = 0.4;
/// Paths that are visible for fewer pixels than this get no arrow.
const SHORT: f64 = 60.0;
/// Where on the visible path its arrow is.
const ARROW_AT: f64 = 0.4;
/// Length and half the width of an arrow's head in pixels.
const ARROW: [f64; 2] = [20.0, 7.0];

/// The whole pixel of a place.
pub(super) fn place(p: DVec2) -> Place {
    (p.x.round() as i32, p.y.round() as i32)
}

/// Draws a line through places of the plane, which are all in the frame.
pub(super) fn line(canvas: &Area, view: &View, points: &[DVec2], look: Look) -> Drawn<()> {
    let mut path = PathBuilder::new();
    trace(&mut path, view, points);
    figure(canvas, path.finish(), None, Some(look))
}

/// Fills the inside of what has one: a hole of an outline stays empty.
pub(super) fn fill(canvas: &Area, view: &View, surface: &Surface) -> Drawn<()> {
    let Some(color) = Look::inside(surface.kind) else { return Ok(()) };
    let mut path = PathBuilder::new();
    for outline in surface.outlines.iter().filter(|outline| outline.closed) {
        let corners: Vec<_> = outline.points.iter().map(|p| view.flat(*p)).collect();
        let corners = view.window.area(&corners);
        if corners.len() > 2 {
            trace(&mut path, view, &corners);
            path.close();
        }
    }
    let Some(path) = path.finish() else { return Ok(()) };
    canvas.draw(&Figure { path, fill: Some(color), stroke: None }).map_err(words)
}

/// Strokes where a surface crosses the plane.
pub(super) fn outline(canvas: &Area, view: &View, surface: &Surface) -> Drawn<()> {
    let mut path = PathBuilder::new();
    for outline in &surface.outlines {
        let mut points: Vec<_> = outline.points.iter().map(|p| view.flat(*p)).collect();
        if outline.closed {
            points.extend(points.first().copied());
        }
        let whole = points.iter().all(|p| view.window.contains(*p));
        for part in view.window.line(&points) {
            trace(&mut path, view, &part);
            if whole && outline.closed {
                path.close();
            }
        }
    }
    figure(canvas, path.finish(), None, Some(Look::surface(surface.kind)))
}

/// Strokes a ray's path with an arrow on it, and says where it is last seen and in which direction it goes there, in pixels.
pub(super) fn path(canvas: &Area, view: &View, curve: &Curve, look: Look) -> Drawn<Option<[DVec2; 2]>> {
    let flat = curve.0.iter().map(|arc| arc.map(|p| view.flat(p)));
    let arcs: Vec<Arc> = flat.flat_map(|arc| view.window.arc(&arc)).map(|arc| arc.map(|p| view.pixel(p))).collect();
    let mut path = PathBuilder::new();
    let mut at: Option<DVec2> = None;
    for (i, arc) in arcs.iter().enumerate() {
        let [a, b, c, d] = *arc;
        if i == 0 || a.distance(arcs[i - 1][3]) > NEAR {
            path.move_to(a.x as f32, a.y as f32);
            at = Some(a);
        }
        let last = arcs.get(i + 1).is_none_or(|next| next[0].distance(d) > NEAR);
        if !last && at.is_some_and(|at| at.distance(d) < NEAR) {
            continue;
        }
        if bend(arc) < FLAT || at != Some(a) {
            path.line_to(d.x as f32, d.y as f32);
        } else {
            path.cubic_to(b.x as f32, b.y as f32, c.x as f32, c.y as f32, d.x as f32, d.y as f32);
        }
        at = Some(d);
    }
    figure(canvas, path.finish(), None, Some(look))?;
    if let Some(head) = arrow(&arcs) {
        let mut path = PathBuilder::new();
        for (i, p) in head.into_iter().enumerate() {
            let go = if i == 0 { PathBuilder::move_to } else { PathBuilder::line_to };
            go(&mut path, p.x as f32, p.y as f32);
        }
        path.close();
        figure(canvas, path.finish(), Some(look), None)?;
    }
    Ok(arcs.last().map(|&[a, _, c, d]| [d, (d - c).try_normalize().or((d - a).try_normalize()).unwrap_or(DVec2::X)]))
}

/// How far an arc's control points are from its chord.
fn bend(&[a, b, c, d]: &Arc) -> f64 {
    let chord = (d - a).normalize_or_zero();
    let off = |p: DVec2| if chord == DVec2::ZERO { p.distance(a) } else { chord.perp_dot(p - a).abs() };
    off(b).max(off(c))
}

/// The corners of an arrow's head on a path, if there is room for one.
fn arrow(arcs: &[Arc]) -> Option<[DVec2; 3]> {
    let length = |arc: &Arc| arc[0].distance(arc[3]);
    let whole: f64 = arcs.iter().map(length).sum();
    let mut left = whole * ARROW_AT;
    for arc in arcs.iter().filter(|_| whole > SHORT) {
        if length(arc) < left {
            left -= length(arc);
            continue;
        }
        let part = left / length(arc);
        let thirds = [0, 1, 2].map(|i| arc[i].lerp(arc[i + 1], part));
        let [from, to] = [0, 1].map(|i| thirds[i].lerp(thirds[i + 1], part));
        let along = (to - from).try_normalize()?;
        let (tip, back) = (from.lerp(to, part) + along * (ARROW[0] / 2.0), along * ARROW[0]);
        let aside = along.perp() * ARROW[1];
        return Some([tip, tip - back + aside, tip - back - aside]);
    }
    None
}

fn trace(path: &mut PathBuilder, view: &View, points: &[DVec2]) {
    for (i, p) in points.iter().map(|p| view.pixel(*p)).enumerate() {
        let go = if i == 0 { PathBuilder::move_to } else { PathBuilder::line_to };
        go(path, p.x as f32, p.y as f32);
    }
}

/// A path filled in one look's colour and stroked in another's.
fn figure(canvas: &Area, path: Option<Path>, fill: Option<Look>, stroke: Option<Look>) -> Drawn<()> {
    let Some(path) = path else { return Ok(()) };
    canvas.draw(&Figure { path, fill: fill.map(|look| look.pen().color), stroke: stroke.map(Look::pen) }).map_err(words)
}

impl Look {
    /// How something that crosses the plane is drawn.
    pub(super) fn surface(kind: SurfaceKind) -> Self {
        match kind {
            SurfaceKind::Opaque => Self::solid(),
            SurfaceKind::Medium => Self::glass(),
            SurfaceKind::Landmark("horizon" | "capture") => Self::hole(),
            SurfaceKind::Landmark(_) => Self::limit(),
        }
    }
}
