//! Finds the next intersection of a ray with a surface.
//!
//! *Theory.* Lines meet shapes in closed form. Along other paths the level of a shape changes its sign, or dips to the other
//! side and back between two points. The path is cut so finely that it is nearly straight between them, and the level of a
//! convex shape has one minimum there; bisection then refines the result until the numbers end.
//!
//! The side of a surface on which a ray is follows from its path, because a point on the surface does not determine it.

use glam::DVec3;

use super::path::{Path, Point};
use super::solid::Body;

/// Points of one path before it is given up: it goes round for ever, or almost.
const LONGEST: u32 = 2_000_000;

/// A body, and how the ray stands to it.
#[derive(Debug, Clone, Copy)]
pub struct Standing {
    /// The body.
    pub body: Body,
    /// Is the ray inside, or under it if it is open?
    pub inside: bool,
    /// Does it start on the surface?
    pub on: bool,
}

/// What a ray comes to next.
#[derive(Debug, Clone, PartialEq)]
pub enum Next {
    /// Surfaces, all at one point: which bodies', and the point.
    Surfaces(Vec<usize>, Point),
    /// It leaves.
    Nothing,
    /// It never comes anywhere.
    Lost,
}

/// Surfaces nearer to each other than this part of the reach are one.
const TOGETHER: f64 = 1e-10;

/// Along a line; surfaces are met only where `within` holds.
pub fn on_line(x: DVec3, d: DVec3, reach: f64, bodies: &[Standing], within: impl Fn(DVec3) -> bool) -> Next {
    let meets = |standing: &Standing| {
        let [enters, leaves] = standing.body.span(x, d)?;
        let t = match (standing.body.is_open(), standing.on, standing.inside) {
            // No line meets a square twice, nor comes back to a convex shape.
            (true, true, _) | (false, true, false) => return None,
            (true, false, _) | (false, _, false) => enters,
            (false, _, true) => leaves,
        };
        // A shape that begins where the ray does may seem to lie behind it by a rounding.
        let ahead = if standing.body.is_open() { t > 0.0 } else { leaves > 0.0 };
        (ahead && within(x + t * d)).then_some(t.max(0.0))
    };
    let times: Vec<Option<f64>> = bodies.iter().map(meets).collect();
    match first(&times, TOGETHER * reach) {
        Some((t, surfaces)) => Next::Surfaces(surfaces, (x + t * d, d)),
        None => Next::Nothing,
    }
}

/// Along a path that bends, in a place that it does not leave but through a surface.
pub fn on_path(path: &mut Path, reach: f64, bodies: &[Standing]) -> Next {
    let stride = path.stride(reach);
    let mut inside: Vec<bool> = bodies.iter().map(|standing| standing.inside).collect();
    let mut last = path.at(0.0).0;
    for i in 0..LONGEST {
        let ends = [f64::from(i) * stride, f64::from(i + 1) * stride];
        let next = path.at(ends[1]).0;
        let middle = path.at(f64::midpoint(ends[0], ends[1])).0;
        let length = last.distance(middle) + middle.distance(next);
        let mut times = vec![None; bodies.len()];
        for (k, standing) in bodies.iter().enumerate() {
            let points = [last, next].map(|x| standing.body.own(x));
            let own_length = points[0].distance(points[1]).max(standing.body.own(middle).distance(points[0]));
            let crossing = Crossing { body: standing.body, inside: inside[k], fresh: i == 0 && standing.on };
            times[k] = crossing.find(path, ends, 2.0 * own_length);
            if standing.body.is_open()
                && times[k].is_some_and(|s| !standing.body.reaches(standing.body.own(path.at(s).0)))
            {
                // Past its edge.
                times[k] = None;
                inside[k] = standing.body.level(points[1]) < 0.0;
            }
        }
        // The parameter in which a length as short as that is passed.
        if let Some((s, surfaces)) = first(&times, TOGETHER * reach * stride / length) {
            return Next::Surfaces(surfaces, path.at(s));
        }
        if path.has_ended(next) {
            return Next::Lost;
        }
        last = next;
    }
    Next::Lost
}

/// The least of the times, and whose are no further from it than `together`.
fn first(times: &[Option<f64>], together: f64) -> Option<(f64, Vec<usize>)> {
    let least = times.iter().flatten().copied().reduce(f64::min)?;
    let near = |i: &usize| times[*i].is_some_and(|t| t <= least + together);
    Some((least, (0..times.len()).filter(near).collect()))
}

/// The search for one body's surface.
struct Crossing {
    body: Body,
    inside: bool,
    /// Has the ray just come from the surface?
    fresh: bool,
}

impl Crossing {
    /// How deep the path is on the side where the ray is not: above 0 once it has crossed.
    fn beyond(&self, path: &mut Path, s: f64) -> f64 {
        let level = self.body.level(self.body.own(path.at(s).0));
        if self.inside { level } else { -level }
    }

    /// The parameter at which the path crosses between `ends`, if it does; a piece of it is no longer than `length` in the
    /// body's own space.
    fn find(&self, path: &mut Path, ends: [f64; 2], length: f64) -> Option<f64> {
        let values = [if self.fresh { 0.0 } else { self.beyond(path, ends[0]) }, self.beyond(path, ends[1])];
        if values[1] > 0.0 {
            return Some(self.bisect(path, ends));
        }
        // Can it have been there and back? A ray that has just come from the surface goes away from it.
        if self.fresh || values[0] + values[1] + length <= 0.0 {
            return None;
        }
        let deepest = self.deepest(path, ends);
        (self.beyond(path, deepest) > 0.0).then(|| self.bisect(path, [ends[0], deepest]))
    }

    fn bisect(&self, path: &mut Path, [mut low, mut high]: [f64; 2]) -> f64 {
        loop {
            let middle = f64::midpoint(low, high);
            if middle <= low || middle >= high {
                return high;
            }
            if self.beyond(path, middle) > 0.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
    }

    fn deepest(&self, path: &mut Path, [mut low, mut high]: [f64; 2]) -> f64 {
        for _ in 0..80 {
            let thirds = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if self.beyond(path, thirds[0]) < self.beyond(path, thirds[1]) {
                low = thirds[0];
            } else {
                high = thirds[1];
            }
        }
        f64::midpoint(low, high)
    }
}
