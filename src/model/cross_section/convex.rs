//! Cross sections of shapes with straight edges, by polygon clipping.

use std::f64::consts::TAU;

use glam::DVec3;

use super::{CORNERS, LocalPlane, Outline};

/// Half the side of a square that covers the cross section of the unit cube with any plane.
const COVER: f64 = 4.0;
/// The threshold below which two planes count as parallel.
pub(in crate::model) const PARALLEL: f64 = 1e-12;
/// The distance within which an outline counts as part of a surface.
pub(in crate::model) const ON: f64 = 1e-9;

/// Returns the cross section of the cube |x|, |y|, |z| ≤ 1 with a plane: a square in the plane, clipped by the six half-spaces of the cube.
/// Unlike the intersection with the cube's edges, this also works if the plane contains an edge or a face.
pub(in crate::model) fn cuboid(plane: LocalPlane) -> Option<Outline> {
    cut_by(plane, &[DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z])
}

/// Returns the cross section of the cylinder |y| ≤ 1, x² + z² ≤ 1 with a plane by clipping; the mantle is approximated by as many flat
/// strips as an ellipse has corners.
pub(in crate::model) fn cylinder(plane: LocalPlane) -> Option<Outline> {
    let strips = (0..CORNERS).map(|i| {
        let (sin, cos) = (TAU * f64::from(i) / f64::from(CORNERS)).sin_cos();
        DVec3::new(cos, 0.0, sin)
    });
    let faces: Vec<DVec3> = strips.chain([DVec3::Y, DVec3::NEG_Y]).collect();
    cut_by(plane, &faces)
}

/// Returns the part of a plane within distance 1 of the origin along each of these normals.
fn cut_by(plane: LocalPlane, normals: &[DVec3]) -> Option<Outline> {
    let foot = plane.normal * plane.offset;
    if foot.length() > COVER / 2.0 {
        return None;
    }
    let (a, b) = plane.normal.any_orthonormal_pair();
    let mut polygon =
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[s, t]| foot + COVER * (s * a + t * b)).to_vec();
    for normal in normals {
        polygon = clipped(&polygon, |p| 1.0 + ON - normal.dot(p));
    }
    polygon.dedup_by(|p, q| p.distance(*q) < ON);
    (polygon.len() >= 3).then_some(Outline { points: polygon, closed: true })
}

/// Returns the part of a closed polygon where the linear function `inside` is not negative (Sutherland and Hodgman 1974).
fn clipped(polygon: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, &to) in polygon.iter().enumerate() {
        let from = polygon[(i + polygon.len() - 1) % polygon.len()];
        let (a, b) = (inside(from), inside(to));
        if (a < 0.0) != (b < 0.0) {
            kept.push(from.lerp(to, a / (a - b)));
        }
        if b >= 0.0 {
            kept.push(to);
        }
    }
    kept
}

/// Returns the line in which the square |x|, |z| ≤ 1, y = 0 crosses a plane, or the edge of the square if it is in the plane.
pub(in crate::model) fn square(plane: LocalPlane) -> Option<Outline> {
    let slope = DVec3::new(plane.normal.x, 0.0, plane.normal.z);
    if slope.length() <= PARALLEL {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
        return (plane.offset.abs() <= ON).then(|| Outline { points: corners.to_vec(), closed: true });
    }
    let foot = slope * (plane.offset / slope.length_squared());
    let along = slope.cross(DVec3::Y).normalize();
    // The interval of the line between each pair of edges, and the intersection of these intervals.
    let mut stretch = [f64::NEG_INFINITY, f64::INFINITY];
    for axis in [0, 2] {
        if along[axis].abs() <= PARALLEL {
            if foot[axis].abs() > 1.0 {
                return None;
            }
            continue;
        }
        let ends = [-1.0, 1.0].map(|side| (side - foot[axis]) / along[axis]);
        stretch = [stretch[0].max(ends[0].min(ends[1])), stretch[1].min(ends[0].max(ends[1]))];
    }
    let points = stretch.map(|t| foot + t * along).to_vec();
    (stretch[0] < stretch[1]).then_some(Outline { points, closed: false })
}
