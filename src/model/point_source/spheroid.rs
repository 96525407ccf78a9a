//! A rotating black hole: surfaces of constant Boyer–Lindquist r are oblate spheroids. Only capture regions use this kind.

use glam::DVec3;

use super::SourceKind;

/// The description of this anchor; `along` is the spin.
pub static KIND: SourceKind = SourceKind { name: "spheroid", keys: &[], along: |_| None, offset, is_point: false };

/// Returns the Boyer–Lindquist r at d from a black hole of spin a, and a vector along its gradient.
#[must_use]
pub fn of(d: DVec3, a: DVec3) -> (f64, DVec3) {
    let k = 0.5 * (d.length_squared() - a.length_squared());
    let along = a.dot(d);
    let root = k.hypot(along);
    let r = if k > 0.0 { (k + root).sqrt() } else { along.abs() / (root - k).sqrt() }.max(1e-15);
    (r, r * d + along / r * a)
}

/// Returns the offset from the black hole to a position: r long, and perpendicular to the spheroids of constant r.
fn offset(d: DVec3, a: DVec3) -> DVec3 {
    let (r, outwards) = of(d, a);
    r * outwards.normalize_or_zero()
}
