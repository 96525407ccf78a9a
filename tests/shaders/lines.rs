//! Intersections of lines with shapes in object space: the f64 forms of `shaders/shape/`.

use glam::DVec3;

use super::shapes::HOLE;

/// Returns pieces in object space: along y from outside and from inside, along the mantle, through the rims, and grazing.
pub(super) fn own_pieces() -> Vec<[DVec3; 2]> {
    let mut all = Vec::new();
    for k in 0..24 {
        let (sin, cos) = (f64::from(k) * 0.261).sin_cos();
        let across = |rho: f64, y: f64| DVec3::new(rho * cos, y, rho * sin);
        let tangent = 3.0 * DVec3::new(-sin, 0.0, cos);
        for rho in [0.0, 0.2, 0.3, 0.5, 0.99, 1.01, 1.5] {
            all.push([across(rho, 3.0), across(rho, -3.0)]);
            all.push([across(rho, 0.3), across(rho, 4.0)]);
        }
        for rho in [0.99, 1.01] {
            for y in [-1.01, -0.99, 0.3, 0.99, 1.01] {
                all.push([across(rho, y) - tangent, across(rho, y) + tangent]);
                all.push([across(-3.0, y), across(3.0, y)]);
            }
            // Slanted lines through a rim, just inside and just outside.
            let slant = DVec3::new(2.0 * cos - sin, -2.0, 2.0 * sin + cos);
            all.push([across(rho, 1.0) + slant, across(rho, 1.0) - slant]);
        }
    }
    all
}

const OVERLAP: f64 = 1e-5;

/// Returns the first of two crossings on the piece, with its ends extended by `eta`.
pub(super) fn first([enters, leaves]: [f64; 2], eta: f64) -> Option<f64> {
    let t = if enters >= -OVERLAP - eta { enters } else { leaves };
    (enters <= leaves && t >= -OVERLAP - eta && t <= 1.0 + OVERLAP + eta).then_some(t)
}

/// Returns the crossings of a line with a ball.
pub(super) fn ball(p: DVec3, d: DVec3, radius: f64) -> Option<[f64; 2]> {
    let (dd, pd) = (d.length_squared(), p.dot(d));
    let miss = p - pd / dd * d;
    let inside = radius * radius - miss.length_squared();
    let half = (inside.max(0.0) / dd).sqrt();
    (inside >= 0.0).then_some([-pd / dd - half, -pd / dd + half])
}

/// Returns the crossings of a line with the slabs |x| ≤ size of these axes.
pub(super) fn slabs(axes: &[usize], p: DVec3, d: DVec3, size: f64) -> Option<[f64; 2]> {
    let (mut enters, mut leaves) = (f64::NEG_INFINITY, f64::INFINITY);
    for &axis in axes {
        if d[axis] == 0.0 {
            if p[axis].abs() > size {
                return None;
            }
            continue;
        }
        let (t0, t1) = ((-size - p[axis]) / d[axis], (size - p[axis]) / d[axis]);
        (enters, leaves) = (enters.max(t0.min(t1)), leaves.min(t0.max(t1)));
    }
    (enters <= leaves).then_some([enters, leaves])
}

/// Returns the crossings with a cylinder: the roots of |p + t d|² = r² across the axis, limited by the height.
pub(super) fn cylinder(p: DVec3, d: DVec3, radius: f64, height: f64) -> Option<[f64; 2]> {
    let [enters, leaves] = slabs(&[1], p, d, height)?;
    let (a, b) = (d.x * d.x + d.z * d.z, p.x * d.x + p.z * d.z);
    let c = p.x * p.x + p.z * p.z - radius * radius;
    if a == 0.0 {
        return (c <= 0.0).then_some([enters, leaves]);
    }
    let root = (b * b - a * c).sqrt();
    // The root of a negative number is NaN, and every comparison with it is false.
    let ends = [enters.max((-b - root) / a), leaves.min((-b + root) / a)];
    (!root.is_nan() && ends[0] <= ends[1]).then_some(ends)
}

/// Returns the crossing with a square. Its size and its height may be wrong, and an error of the height moves the point along the square.
pub(super) fn square(p: DVec3, d: DVec3, lift: f64, grown: f64, eta: f64) -> Option<f64> {
    let t = -(p.y + lift) / d.y;
    let size = 1.0 + grown * (1.0 + d.x.hypot(d.z) / d.y.abs());
    let q = p + t * d;
    first([t, t], eta).filter(|_| d.y != 0.0 && q.x.abs().max(q.z.abs()) <= size)
}

pub(super) fn ring(p: DVec3, d: DVec3, lift: f64, grown: f64, eta: f64) -> Option<f64> {
    let t = -(p.y + lift) / d.y;
    let more = grown * (1.0 + d.x.hypot(d.z) / d.y.abs());
    let rho = (p.x + t * d.x).hypot(p.z + t * d.z);
    first([t, t], eta).filter(|_| d.y != 0.0 && rho <= 1.0 + more && rho >= HOLE - more)
}
