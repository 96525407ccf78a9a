//! Finds the next intersection of a ray with a surface.
//!
//! *Theory.* Lines meet shapes in closed form. Along other paths the level of a shape changes its sign, or dips to the other
//! side and back between two points. The path is cut so finely that it is nearly straight between them, and the level of a
//! convex shape has one minimum there; bisection then refines the result until the numbers end.
//!
//! The path of a ray determines on which side of a surface it is, because a point on the surface does not.

use glam::DVec3;

use super::path::{Path, Point};
use super::solid::Body;

/// The number of points of one path after which it counts as endless.
const LONGEST: u32 = 2_000_000;

/// A body, and the position of the ray relative to it.
#[derive(Debug, Clone, Copy)]
pub struct Standing {
    /// The body.
    pub body: Body,
    /// Whether the ray is inside, or under the body if it is open.
    pub inside: bool,
    /// Whether it starts on the surface.
    pub on: bool,
}

/// The next event of a ray.
#[derive(Debug, Clone, PartialEq)]
pub enum Next {
    /// Surfaces, all at one point: the indices of their bodies, and the point.
    Surfaces(Vec<usize>, Point),
    /// The ray leaves.
    Nothing,
    /// The ray never arrives anywhere.
    Lost,
}

/// Surfaces within this fraction of the reach are one surface.
const TOGETHER: f64 = 1e-10;

/// Follows a line; surfaces count only at points where `within` returns `true`.
pub fn on_line(x: DVec3, d: DVec3, reach: f64, bodies: &[Standing], within: impl Fn(DVec3) -> bool) -> Next {
    let meets = |standing: &Standing| {
        let [enters, leaves] = standing.body.span(x, d)?;
        let t = match (standing.body.is_open(), standing.on, standing.inside) {
            // No line meets a square twice, or returns to a convex shape.
            (true, true, _) | (false, true, false) => return None,
            (true, false, _) | (false, _, false) => enters,
            (false, _, true) => leaves,
        };
        // By rounding, a shape that begins at the start of the ray may seem to be behind it.
        let ahead = if standing.body.is_open() { t > 0.0 } else { leaves > 0.0 };
        (ahead && within(x + t * d)).then_some(t.max(0.0))
    };
    let times: Vec<Option<f64>> = bodies.iter().map(meets).collect();
    match first(&times, TOGETHER * reach) {
        Some((t, surfaces)) => Next::Surfaces(surfaces, (x + t * d, d)),
        None => Next::Nothing,
    }
}

/// Follows a curved path inside an object that it can only leave through a surface.
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
                // The crossing is beyond its edge.
                times[k] = None;
                inside[k] = standing.body.level(points[1]) < 0.0;
            }
        }
        // The change of the parameter over such a short length.
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

/// Returns the least of the times, and the indices of all that are at most `together` later.
fn first(times: &[Option<f64>], together: f64) -> Option<(f64, Vec<usize>)> {
    let least = times.iter().flatten().copied().reduce(f64::min)?;
    let near = |i: &usize| times[*i].is_some_and(|t| t <= least + together);
    Some((least, (0..times.len()).filter(near).collect()))
}

/// The search for the surface of one body.
struct Crossing {
    body: Body,
    inside: bool,
    /// Whether the ray has just come from the surface.
    fresh: bool,
}

impl Crossing {
    /// Returns the depth of the path on the other side of the surface: above 0 once it has crossed.
    fn beyond(&self, path: &mut Path, s: f64) -> f64 {
        let level = self.body.level(self.body.own(path.at(s).0));
        if self.inside { level } else { -level }
    }

    /// Returns the parameter at which the path crosses between `ends`, if it does; a piece of it is at most `length` long in object space.
    fn find(&self, path: &mut Path, ends: [f64; 2], length: f64) -> Option<f64> {
        let values = [if self.fresh { 0.0 } else { self.beyond(path, ends[0]) }, self.beyond(path, ends[1])];
        if values[1] > 0.0 {
            return Some(self.bisect(path, ends));
        }
        // The path may have crossed twice, unless the ray has just come from the surface and moves away from it.
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
