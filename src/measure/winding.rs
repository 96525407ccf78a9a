//! The winding number of a path around a point.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::Curve;
use crate::scene::CutPlane;

/// Returns the angle, in turns, that a path sweeps around a point in a plane; counterclockwise on paper is positive. A ray through the
/// point turns by half a turn there, in a direction that depends on rounding.
#[must_use]
pub fn windings(curve: &Curve, about: DVec3, plane: &CutPlane) -> f64 {
    let flat = |p: &DVec3| DVec2::from(plane.flat(*p)) - DVec2::from(plane.flat(about));
    let around: Vec<DVec2> = curve.flattened().iter().map(flat).collect();
    let angle = |ends: &[DVec2]| ends[0].perp_dot(ends[1]).atan2(ends[0].dot(ends[1]));
    around.windows(2).map(angle).sum::<f64>() / TAU
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spiral_winds_as_often_as_it_does() {
        let plane = CutPlane { point: DVec3::ZERO, right: DVec3::X, up: DVec3::Y };
        let about = DVec3::new(1.0, -2.0, 5.0);
        let point = |i: i32| {
            let angle = f64::from(i) * 0.3;
            about + (0.02 * angle).exp() * DVec3::new(angle.cos(), angle.sin(), 1.0)
        };
        let path: Vec<DVec3> = (0..400).map(point).collect();
        let turns = windings(&Curve::through(&path), about, &plane);
        assert!((turns - 399.0 * 0.3 / TAU).abs() < 1e-12, "{turns}");
        let back: Vec<DVec3> = path.into_iter().rev().collect();
        assert!((windings(&Curve::through(&back), about, &plane) + turns).abs() < 1e-12);
        // A straight line turns by at most half a turn.
        let line = Curve::through(&[about - DVec3::new(1e9, 1.0, 0.0), about + DVec3::new(1e9, -1.0, 0.0)]);
        assert!((windings(&line, about, &plane) - 0.5).abs() < 1e-8);
    }
}
