//! Paths as curves: cubic arcs between the ends of segments.
//!
//! *Theory.* Two ends with positions x and velocities v define the cubic Hermite arc with the derivatives v Δτ, which is of third order
//! like the segments. At a surface the velocity jumps, and the recorded velocity may be the one behind it.
//!
//! *Practice.* An arc is therefore straight if the velocity at its start leads to its end, and a parabola with that velocity if the
//! velocity at its end does not fit. An arc stores eight numbers per segment in addition to its ends.

use glam::DVec3;

use crate::render::PathPoint;

/// The distance from the end, relative to the segment's length, within which the initial velocity makes a segment straight.
const STRAIGHT: f64 = 1e-3;
/// The largest difference of the final velocity from a parabola's, relative to the chord, for which it belongs to the arc. For a circular
/// arc of angle φ the difference is φ²/6.
const FITS: f64 = 0.1;
/// The number of points per arc for distance measurements.
const SAMPLES: usize = 16;

/// A path as cubic Bézier arcs, each with four points in scene coordinates. At a break, an arc does not begin at the end of the last one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve(pub Vec<[DVec3; 4]>);

impl Curve {
    /// Returns the curve through the points of a path.
    #[must_use]
    pub fn of(path: &[PathPoint]) -> Self {
        let arcs = path.windows(2).map(|ends| arc(&ends[0], &ends[1]));
        Self(arcs.filter(|arc| arc.iter().all(|p| p.is_finite()) && arc[0] != arc[3]).collect())
    }

    /// Returns straight lines between points.
    #[must_use]
    pub fn through(points: &[DVec3]) -> Self {
        let lines = points.windows(2).map(|ends| line(ends[0], ends[1]));
        Self(lines.filter(|arc| arc.iter().all(|p| p.is_finite())).collect())
    }

    /// Returns the last point.
    #[must_use]
    pub fn end(&self) -> Option<DVec3> {
        self.0.last().map(|arc| arc[3])
    }

    /// Returns points along the curve, dense enough that lines between them represent it.
    #[must_use]
    pub fn flattened(&self) -> Vec<DVec3> {
        let first = self.0.first().map(|arc| arc[0]);
        let rest = self.0.iter().flat_map(|arc| {
            let pieces = if is_line(arc) { 1 } else { SAMPLES };
            (1..=pieces).map(move |i| point(arc, i as f64 / pieces as f64))
        });
        first.into_iter().chain(rest).collect()
    }
}

/// Returns the arc between two ends.
fn arc(start: &PathPoint, end: &PathPoint) -> [DVec3; 4] {
    let [a, b] = [start.x, end.x].map(DVec3::from);
    let [from, to] = [start.v, end.v].map(|v| DVec3::from(v) * (end.tau - start.tau));
    let chord = b - a;
    let off = (chord - from).length();
    if !(off > STRAIGHT * chord.length() && off < chord.length()) {
        return line(a, b);
    }
    // The final velocity of the parabola that leaves with `from` and ends at b.
    let arriving = 2.0 * chord - from;
    let to = if (to - arriving).length() < FITS * chord.length() { to } else { arriving };
    [a, a + from / 3.0, b - to / 3.0, b]
}

fn line(a: DVec3, b: DVec3) -> [DVec3; 4] {
    [a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b]
}

fn is_line(&[a, b, c, d]: &[DVec3; 4]) -> bool {
    let chord = (d - a).normalize_or_zero();
    let off = [b - a, c - a].map(|side| side.reject_from_normalized(chord).length());
    off[0].max(off[1]) <= 1e-9 * (d - a).length()
}

/// Returns the point at t in [0, 1] of a Bézier arc (de Casteljau).
fn point(arc: &[DVec3; 4], t: f64) -> DVec3 {
    let [a, b, c] = [0, 1, 2].map(|i| arc[i].lerp(arc[i + 1], t));
    a.lerp(b, t).lerp(b.lerp(c, t), t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: [f64; 3], v: [f64; 3], tau: f64) -> PathPoint {
        PathPoint { x, v, tau }
    }

    #[test]
    fn few_segments_of_a_circle_are_round() {
        // A quarter of a turn in three segments, at three units per unit of τ: the Hermite form has an error of (h⁴/384)·r.
        let angle = |i: u32| std::f64::consts::FRAC_PI_6 * f64::from(i);
        let point = |i| {
            let (sin, cos) = angle(i).sin_cos();
            at([2.0 * cos, 2.0 * sin, 1.0], [-6.0 * sin, 6.0 * cos, 0.0], angle(i) / 3.0)
        };
        let curve = Curve::of(&[0, 1, 2, 3].map(point));
        assert_eq!(curve.0.len(), 3);
        let bound = 2.0 * angle(1).powi(4) / 384.0;
        for p in curve.flattened() {
            assert!((p.truncate().length() - 2.0).abs() < bound * 1.05, "{p} is off by more than {bound:e}");
        }
        assert!(bound < 4e-4);
    }

    #[test]
    fn refraction_at_an_end_does_not_bend_what_comes_before() {
        // A straight line to a surface, with the recorded velocity behind that surface.
        let path = [
            at([0.0; 3], [1.0, 0.0, 0.0], 0.0),
            at([2.0, 0.0, 0.0], [0.8, 0.6, 0.0], 2.0),
            at([2.8, 0.6, 0.0], [0.8, 0.6, 0.0], 3.0),
        ];
        let flat = Curve::of(&path).flattened();
        assert_eq!(flat.len(), 3, "{flat:?}");
        // A parabola to a surface keeps its shape.
        let path = [at([0.0; 3], [1.0, 0.0, 0.0], 0.0), at([1.0, 0.5, 0.0], [-1.0, 1.0, 0.0], 1.0)];
        for p in Curve::of(&path).flattened() {
            assert!((p.y - 0.5 * p.x * p.x).abs() < 1e-15, "{p}");
        }
    }

    #[test]
    fn odd_paths_have_curves_too() {
        assert!(Curve::of(&[]).0.is_empty() && Curve::default().flattened().is_empty());
        let lost = [at([0.0; 3], [1.0, 0.0, 0.0], 0.0), at([f64::NAN; 3], [f64::NAN; 3], f64::INFINITY)];
        assert!(Curve::of(&lost).0.is_empty());
        let unmoved = [at([0.0; 3], [1.0, 0.0, 0.0], 0.0), at([0.0; 3], [1.0, 0.0, 0.0], 1.0)];
        assert!(Curve::of(&unmoved).0.is_empty());
        // A velocity unrelated to the path results in a line.
        let flow = [at([0.0; 3], [0.0, 90.0, 0.0], 0.0), at([1.0, 0.0, 0.0], [0.0; 3], 1.0)];
        assert_eq!(Curve::of(&flow).flattened().len(), 2);
    }
}
