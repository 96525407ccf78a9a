//! Tests whether two triangles intersect, touch or are separate.
//!
//! *Theory.* Two convex sets are separate if their projections on some axis are. For triangles it suffices to test their normals, the cross
//! products of their sides, and for coplanar triangles the normals of their sides within the plane (Gottschalk, Lin and Manocha 1996).

use glam::DVec3;

/// The contact of two triangles, or of two shells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Contact {
    /// They touch, within the tolerance.
    Touch,
    /// They intersect.
    Cross,
}

/// Returns the contact of two triangles, if any; `tolerance` is the distance by which they may be moved apart, or together.
pub(super) fn contact(a: [DVec3; 3], b: [DVec3; 3], tolerance: f64) -> Option<Contact> {
    let sides = |[p, q, r]: [DVec3; 3]| [q - p, r - q, p - r];
    let (of_a, of_b) = (sides(a), sides(b));
    let normals = [of_a[0].cross(of_a[1]), of_b[0].cross(of_b[1])];
    let crossed = of_a.into_iter().flat_map(|side| of_b.map(|other| side.cross(other)));
    let in_plane = of_a.map(|side| side.cross(normals[0])).into_iter().chain(of_b.map(|side| side.cross(normals[1])));
    let mut least = f64::INFINITY;
    for axis in normals.into_iter().chain(crossed).chain(in_plane).filter_map(DVec3::try_normalize) {
        least = least.min(depth(a, b, axis));
        if least < -tolerance {
            return None;
        }
    }
    Some(if least > tolerance { Contact::Cross } else { Contact::Touch })
}

/// Returns the distance by which one triangle must be moved along a unit axis to separate the two; below 0 if they are separate.
fn depth(a: [DVec3; 3], b: [DVec3; 3], axis: DVec3) -> f64 {
    let range = |corners: [DVec3; 3]| {
        let along = corners.map(|corner| (corner - a[0]).dot(axis));
        (along[0].min(along[1]).min(along[2]), along[0].max(along[1]).max(along[2]))
    };
    let ((a_lo, a_hi), (b_lo, b_hi)) = (range(a), range(b));
    (a_hi - b_lo).min(b_hi - a_lo)
}
