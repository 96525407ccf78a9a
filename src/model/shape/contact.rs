//! Which objects touch: whose surfaces lie on each other over an area.
//!
//! *Theory.* A surface is made of flat faces and round ones. Two of them have an area in common only if they lie in the same
//! plane, or are the same quadric; what meets in points or along lines, such as a ball on a table, does not count: almost no
//! ray comes there.
//!
//! *Practice.* For pairs of objects on the host. It may say so of two that only have faces in the same plane, nearby: that
//! costs time and changes nothing. Of a mesh it is asked whether triangles of it lie in a flat face of the other, which takes
//! a few products for each; two meshes are not compared.

use glam::{DAffine3, DMat3, DVec3};

use super::Object;
use crate::assets::Mesh;

/// What is nearer to each other than this part of the coordinates is together: twice what the shaders allow.
const TOGETHER: f64 = 4e-6;

/// The sine of an angle between planes from which on they cross.
const PARALLEL: f64 = 1e-3;

/// A part of a surface by which it may lie on others.
#[derive(Debug, Clone, Copy)]
pub enum Contact {
    /// In the plane through this point, across this unit vector.
    Flat {
        /// A point of the plane.
        at: DVec3,
        /// Its unit normal.
        normal: DVec3,
    },
    /// Where (x − middle)ᵀ form (x − middle) = 1.
    Round {
        /// The quadratic form.
        form: DMat3,
        /// Its centre.
        middle: DVec3,
    },
}

impl Object {
    /// May its surface lie on that of the other, over an area?
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
    /// Through the end of this axis of a shape's own space, across it.
    fn flat(map: DAffine3, axis: DVec3) -> Self {
        let normal = (map.matrix3.inverse().transpose() * axis).normalize_or_zero();
        Self::Flat { at: map.transform_point3(axis), normal }
    }

    /// Both faces across an axis of a shape's own space.
    pub(super) fn ends(map: DAffine3, axis: DVec3) -> [Self; 2] {
        [Self::flat(map, axis), Self::flat(map, -axis)]
    }

    /// y = 0 of a shape's own space.
    pub(super) fn level(map: DAffine3) -> Self {
        let normal = (map.matrix3.inverse().transpose() * DVec3::Y).normalize_or_zero();
        Self::Flat { at: map.translation, normal }
    }

    /// The unit sphere of a shape's own space, or with a part of its axes the cylinder along the others.
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
                // In parts of the smallest radius, whose inverse square is about the form's largest element.
                let part = near * largest(*form).sqrt();
                let shift = *middle - *other_middle;
                let shifted = shift.dot(*form * shift).max(0.0).sqrt();
                shifted <= 2.0 * part && largest(*form - *other_form) <= 4.0 * part * largest(*form)
            }
            _ => false,
        }
    }

    /// Do these three points lie in it, if it is flat?
    fn holds(&self, points: [DVec3; 3], near: f64) -> bool {
        match self {
            Self::Flat { at, normal } => points.iter().all(|x| normal.dot(*x - *at).abs() <= near),
            Self::Round { .. } => false,
        }
    }
}
