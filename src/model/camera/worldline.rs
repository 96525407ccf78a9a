//! The state of an observer after some proper time, along a given worldline or in free fall.
//!
//! *Theory.* The parameter s of a worldline x^μ(s) is the observer's proper time: g(u, u) = −1 with u = dx/ds. A freely falling observer
//! follows `dp_μ/ds = ½ ∂_μ g(u, u)`, with p = g u.
//!
//! *Practice.* The derivatives of the metric are six-point differences with errors of about 1e-12. Paths are integrated in 64 bits by
//! extrapolation (Gragg 1965, Bulirsch and Stoer 1966) to order 10, with the difference to order 8 as the error. This is done once per
//! image.

use glam::{DVec3, DVec4};

use crate::model::Law;

/// The error tolerance of one step, relative to the state.
const TOLERANCE: f64 = 1e-12;
/// The numbers of substeps of a step, whose results are extrapolated.
const SUBSTEPS: [f64; 5] = [2.0, 4.0, 6.0, 8.0, 10.0];
/// The largest number of steps along a path.
const STEPS: usize = 200_000;

/// An event on a worldline and the four-velocity there; vectors have spatial components followed by the time component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// The position.
    pub x: DVec3,
    /// The coordinate time, relative to the image's t.
    pub t: f64,
    /// The four-velocity.
    pub u: DVec4,
}

impl Event {
    /// Returns the velocity relative to the Eulerian observer, in spatial components and with the speed, as a fraction of the speed of
    /// light, as its length.
    #[must_use]
    pub fn velocity(&self, law: &dyn Law) -> Option<DVec3> {
        let metric = law.metric(self.x, self.t)?;
        let normal = -metric.inverse().w_axis;
        let normal = normal / (-normal.dot(metric * normal)).sqrt();
        let stretch = -self.u.dot(metric * normal);
        let along = self.u / stretch - normal;
        let speed = along.dot(metric * along).max(0.0).sqrt();
        Some(along.truncate().normalize_or_zero() * speed)
    }
}

/// Returns the event of a freely falling observer after the proper time `proper`, or the proper time at which the path left the domain of
/// the metric.
///
/// # Errors
///
/// Returns the proper time at which the path left the domain of the metric, or at which the steps became too short or too many.
pub fn fall(law: &dyn Law, start: Event, proper: f64) -> Result<Event, f64> {
    let lowered = law.metric(start.x, start.t).ok_or(0.0)? * start.u;
    let mut state = State { x: start.x.extend(start.t), p: lowered };
    let (mut s, mut h) = (0.0, 1e-3 * law.length_scale(start.x).min(proper));
    for _ in 0..STEPS {
        if s >= proper {
            let metric = law.metric(state.x.truncate(), state.x.w).ok_or(s)?;
            return Ok(Event { x: state.x.truncate(), t: state.x.w, u: metric.inverse() * state.p });
        }
        let size = h.min(proper - s);
        let Some((next, off)) = state.step(law, size) else {
            h *= 0.1;
            if s + h <= s {
                return Err(s);
            }
            continue;
        };
        if off <= 1.0 {
            (state, s) = (next, if size < h { proper } else { s + size });
        }
        h = size * (0.9 * off.max(1e-10).powf(-1.0 / 9.0)).clamp(0.2, 5.0);
        if s + h <= s {
            return Err(s);
        }
    }
    Err(s)
}

/// The position, the time and the lowered four-velocity.
#[derive(Debug, Clone, Copy)]
struct State {
    x: DVec4,
    p: DVec4,
}

impl State {
    fn plus(self, h: f64, rate: Self) -> Self {
        Self { x: self.x + h * rate.x, p: self.p + h * rate.p }
    }

    /// Returns the derivative by s, or `None` where there is no metric.
    fn rate(self, law: &dyn Law) -> Option<Self> {
        let u = law.metric(self.x.truncate(), self.x.w)?.inverse() * self.p;
        let h = 2e-3 * law.length_scale(self.x.truncate());
        let square = |x: DVec4| law.metric(x.truncate(), x.w).map_or(f64::NAN, |metric| u.dot(metric * u));
        let slope = |axis: DVec4| {
            let apart = |k: f64| square(self.x + k * h * axis) - square(self.x - k * h * axis);
            (45.0 * apart(1.0) - 9.0 * apart(2.0) + apart(3.0)) / (60.0 * h)
        };
        let rate = Self { x: u, p: 0.5 * DVec4::from_array(DVec4::AXES.map(slope)) };
        (rate.x.is_finite() && rate.p.is_finite()).then_some(rate)
    }

    /// Returns the state after a step and its error relative to the tolerance.
    fn step(self, law: &dyn Law, h: f64) -> Option<(Self, f64)> {
        let first = self.rate(law)?;
        let mut row: Vec<Self> = Vec::new();
        for (k, count) in SUBSTEPS.into_iter().enumerate() {
            // The midpoint rule, whose error has only even powers of the substep.
            let each = h / count;
            let (mut before, mut now) = (self, self.plus(each, first));
            for _ in 1..count as u32 {
                (before, now) = (now, before.plus(2.0 * each, now.rate(law)?));
            }
            // Extrapolation to a substep of 0 removes one power after the other (Aitken and Neville).
            let mut next = vec![now];
            for (older, less) in row.iter().zip(SUBSTEPS[..k].iter().rev()) {
                let ratio = (count / less).powi(2);
                now = now.plus(1.0 / (ratio - 1.0), now.plus(-1.0, *older));
                next.push(now);
            }
            row = next;
        }
        let [.., before, next] = row[..] else { return None };
        let off = next.plus(-1.0, before);
        let part = off.x.length() / law.length_scale(self.x.truncate()) + off.p.length() / self.p.length();
        Some((next, part / TOLERANCE))
    }
}

/// A smooth path through points in the order of their times. It is a cubic whose velocity at a point is the slope between the points before
/// and after it (Catmull–Rom).
#[derive(Debug, Clone, PartialEq)]
pub struct Path(Vec<DVec4>);

/// The reason why a path is not a valid worldline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WorldlineError {
    /// The time does not increase to the point of this index.
    NotLater(usize),
    /// The path reaches the speed of light before the point of this index.
    TooFast(usize),
    /// The path ends after this proper time.
    Ends(f64),
}

impl Path {
    /// Creates the path through at least two points of x, y, z and t.
    ///
    /// # Errors
    ///
    /// Returns [`WorldlineError::NotLater`] if the time of a point is not after the time of the previous point.
    pub fn through(points: Vec<DVec4>) -> Result<Self, WorldlineError> {
        match points.windows(2).position(|pair| pair[1].w <= pair[0].w) {
            Some(i) => Err(WorldlineError::NotLater(i + 1)),
            None => Ok(Self(points)),
        }
    }

    /// Returns the position and the velocity dx/dt at a time between the points i and i + 1.
    #[allow(clippy::many_single_char_names)] // the formulas' own letters
    fn at(&self, i: usize, t: f64) -> (DVec3, DVec3) {
        let points = &self.0;
        let [from, to] = [i, i + 1].map(|k| points[k]);
        let velocity = |k: usize| {
            let (before, after) = (points[k.saturating_sub(1)], points[(k + 1).min(points.len() - 1)]);
            (after - before).truncate() / (after.w - before.w)
        };
        let h = to.w - from.w;
        let (z, c) = ((t - from.w) / h, (to - from).truncate());
        let (a, b) = (h * velocity(i) - c, c - h * velocity(i + 1));
        let x = from.truncate() + z * (c + (1.0 - z) * ((1.0 - z) * a + z * b));
        let slope = c + (1.0 - z) * (1.0 - 3.0 * z) * a + z * (2.0 - 3.0 * z) * b;
        (x, slope / h)
    }

    /// Returns ds/dt at a time between two points, or `None` if the path is not timelike.
    fn pace(&self, law: &dyn Law, i: usize, t: f64) -> Option<f64> {
        let (place, velocity) = self.at(i, t);
        let way = velocity.extend(1.0);
        let square = -way.dot(law.metric(place, t)? * way);
        (square > 0.0).then(|| square.sqrt())
    }

    /// Returns the event after the proper time `proper`.
    ///
    /// # Errors
    ///
    /// Returns [`WorldlineError::TooFast`] if the path is not timelike somewhere before this event, and [`WorldlineError::Ends`] if the
    /// path is shorter.
    pub fn after(&self, law: &dyn Law, proper: f64) -> Result<Event, WorldlineError> {
        /// The number of intervals per segment, each integrated with three-point Gauss quadrature.
        const PARTS: usize = 64;
        let mut s = 0.0;
        for i in 0..self.0.len() - 1 {
            let [from, to] = [i, i + 1].map(|k| self.0[k].w);
            let h = (to - from) / PARTS as f64;
            for k in 0..PARTS {
                let start = from + h * k as f64;
                let spent = |until: f64| {
                    let (middle, half) = (start.midpoint(until), 0.5 * (until - start));
                    let pace = |z: f64| self.pace(law, i, middle + z * half).ok_or(WorldlineError::TooFast(i + 1));
                    let out = 0.6_f64.sqrt();
                    Ok(half * (5.0 * (pace(-out)? + pace(out)?) + 8.0 * pace(0.0)?) / 9.0)
                };
                let part = spent(start + h)?;
                if s + part >= proper {
                    let (mut early, mut late) = (start, start + h);
                    for _ in 0..60 {
                        let middle = early.midpoint(late);
                        *(if s + spent(middle)? < proper { &mut early } else { &mut late }) = middle;
                    }
                    let (x, v) = self.at(i, late);
                    let pace = self.pace(law, i, late).ok_or(WorldlineError::TooFast(i + 1))?;
                    return Ok(Event { x, t: late, u: v.extend(1.0) / pace });
                }
                s += part;
            }
        }
        Err(WorldlineError::Ends(s))
    }
}
