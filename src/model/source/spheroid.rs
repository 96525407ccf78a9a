//! A hole that spins: what is as near to it as Kerr's r says lies on a flattened spheroid. No source of force is one.

use glam::DVec3;

use super::Kind;

/// What is known of it; `along` is the spin.
pub static KIND: Kind = Kind { name: "spheroid", keys: &[], along: |_| None, offset, is_point: false };

/// Kerr's r at d from a hole of spin a, and the vector along which it grows.
#[must_use]
pub fn of(d: DVec3, a: DVec3) -> (f64, DVec3) {
    let k = 0.5 * (d.length_squared() - a.length_squared());
    let along = a.dot(d);
    let root = k.hypot(along);
    let r = if k > 0.0 { (k + root).sqrt() } else { along.abs() / (root - k).sqrt() }.max(1e-15);
    (r, r * d + along / r * a)
}

/// The way from the hole to a place: r long, and square to the spheroids of equal r.
fn offset(d: DVec3, a: DVec3) -> DVec3 {
    let (r, outwards) = of(d, a);
    r * outwards.normalize_or_zero()
}
