//! Contacts: pairs of objects whose surfaces coincide over an area.
//!
//! *Theory.* A surface consists of flat and curved faces. Two faces can share an area only if they are in one plane or on one quadric.
//! Contacts in points or along lines, such as a ball on a table, do not count, because almost no ray hits them.
//!
//! *Practice.* The host tests pairs of objects. The test may also report two objects that only have faces close together in one plane,
//! which costs time but does not change the image. For a mesh, it tests whether a triangle is in a flat face of the other object, which
//! takes a few products per face; two meshes are not compared.

use glam::{DAffine3, DMat3, DVec3};

use super::Object;
use crate::assets::Mesh;

/// The distance, relative to the coordinates, below which surfaces coincide: twice the tolerance of the shaders.
const TOGETHER: f64 = 4e-6;

/// The sine of the angle above which two planes cross.
const PARALLEL: f64 = 1e-3;

/// A face of a surface that may coincide with another.
#[derive(Debug, Clone, Copy)]
pub enum Contact {
    /// A flat face.
    Flat {
        /// A point of the plane.
        at: DVec3,
        /// The unit normal.
        normal: DVec3,
    },
    /// A quadric: (x − middle)ᵀ form (x − middle) = 1.
    Round {
        /// The quadratic form.
        form: DMat3,
        /// The center.
        middle: DVec3,
    },
}

impl Object {
    /// Returns `true` if this face may coincide with the other over an area.
    #[must_use]
    pub fn may_touch(&self, other: &Self) -> bool {
        let ((lo, hi), (other_lo, other_hi)) = (self.bounds(), other.bounds());
        let farthest = [lo, hi, other_lo, other_hi].map(|x| x.abs().max_element()).into_iter().fold(0.0, f64::max);
        let near = TOGETHER * farthest;
        if lo.cmpgt(other_hi + near).any() || other_lo.cmpgt(hi + near).any() {
            return false;
        }
        let contacts = other.shape.contacts(other.transform.0);
        if let Some(mesh) = self.shape.mesh() {
            let corner = |mesh: &Mesh, i: u32| mesh.vertices[i as usize].position.as_dvec3();
            let placed = |i: u32| self.transform.0.transform_point3(corner(mesh, i));
            return mesh.triangles.iter().any(|t| contacts.iter().any(|contact| contact.holds(t.map(placed), near)));
        }
        let own = self.shape.contacts(self.transform.0);
        own.iter().any(|contact| contacts.iter().any(|other| contact.may_touch(other, near)))
    }
}

impl Contact {
    /// Returns the flat face perpendicular to an axis of object space, through the end of this axis.
    fn flat(map: DAffine3, axis: DVec3) -> Self {
        let normal = (map.matrix3.inverse().transpose() * axis).normalize_or_zero();
        Self::Flat { at: map.transform_point3(axis), normal }
    }

    /// Returns both faces perpendicular to an axis of object space.
    pub(super) fn ends(map: DAffine3, axis: DVec3) -> [Self; 2] {
        [Self::flat(map, axis), Self::flat(map, -axis)]
    }

    /// Returns the plane y = 0 of object space.
    pub(super) fn level(map: DAffine3) -> Self {
        let normal = (map.matrix3.inverse().transpose() * DVec3::Y).normalize_or_zero();
        Self::Flat { at: map.translation, normal }
    }

    /// Returns the unit sphere of object space, or with some of its axes the cylinder along the others.
    pub(super) fn round(map: DAffine3, axes: DVec3) -> Self {
        let inverse = map.matrix3.inverse();
        Self::Round { form: inverse.transpose() * DMat3::from_diagonal(axes) * inverse, middle: map.translation }
    }

    fn may_touch(&self, other: &Self, near: f64) -> bool {
        match (self, other) {
            (Self::Flat { at, normal }, Self::Flat { at: other_at, normal: other_normal }) => {
                let between = *at - *other_at;
                let apart = normal.dot(between).abs().min(other_normal.dot(between).abs());
                apart <= near && normal.cross(*other_normal).length() <= PARALLEL
            }
            (Self::Round { form, middle }, Self::Round { form: other_form, middle: other_middle }) => {
                let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0, |most: f64, a| most.max(a.abs()));
                // Relative to the smallest radius, whose inverse square is about the largest element of the form.
                let part = near * largest(*form).sqrt();
                let shift = *middle - *other_middle;
                let shifted = shift.dot(*form * shift).max(0.0).sqrt();
                shifted <= 2.0 * part && largest(*form - *other_form) <= 4.0 * part * largest(*form)
            }
            _ => false,
        }
    }

    /// Returns `true` if the face is flat and contains these three points.
    fn holds(&self, points: [DVec3; 3], near: f64) -> bool {
        match self {
            Self::Flat { at, normal } => points.iter().all(|x| normal.dot(*x - *at).abs() <= near),
            Self::Round { .. } => false,
        }
    }
}
