//! Which objects touch: whose surfaces lie on each other over an area.
//!
//! *Theory.* A surface is made of flat faces and round ones. Two of them have an area in common only if they lie in the same
//! plane, or are the same quadric; what meets in points or along lines, such as a ball on a table, does not count: almost no
//! ray comes there.
//!
//! *Practice.* For pairs of objects on the host. It may say so of two that only have faces in the same plane, nearby: that
//! costs time and changes nothing. Of a mesh it is asked whether triangles of it lie in a flat face of the other, which takes
//! a few products for each; two meshes are not compared.

use super::{Object, Shape};
use glam::{DAffine3, DMat3, DVec3};

/// What is nearer to each other than this part of the coordinates is together: twice what the shaders allow.
const TOGETHER: f64 = 4e-6;

/// The sine of an angle between planes from which on they cross.
const PARALLEL: f64 = 1e-3;

/// A part of a surface.
enum Face {
    /// In the plane through this point, across this unit vector.
    Flat { at: DVec3, normal: DVec3 },
    /// Where (x − middle)ᵀ form (x − middle) = 1.
    Round { form: DMat3, middle: DVec3 },
}

impl Object {
    /// The corners of a box that holds all of the object: lower and upper.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let map = self.transform.0;
        if let Shape::Mesh(mesh) = &self.shape {
            let corners = mesh.vertices.iter().map(|vertex| map.transform_point3(vertex.position.as_dvec3()));
            return corners.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
        }
        // A transformed cube's half extents; they bound what is in it.
        let m = map.matrix3;
        let half = m.x_axis.abs() + m.y_axis.abs() + m.z_axis.abs();
        (map.translation - half, map.translation + half)
    }

    /// May its surface lie on that of the other, over an area?
    #[must_use]
    pub fn may_touch(&self, other: &Self) -> bool {
        let ((lo, hi), (other_lo, other_hi)) = (self.bounds(), other.bounds());
        let farthest = [lo, hi, other_lo, other_hi].map(|x| x.abs().max_element()).into_iter().fold(0.0, f64::max);
        let near = TOGETHER * farthest;
        if lo.cmpgt(other_hi + near).any() || other_lo.cmpgt(hi + near).any() {
            return false;
        }
        let faces = other.faces();
        if let Shape::Mesh(mesh) = &self.shape {
            let corner = |i: u32| self.transform.0.transform_point3(mesh.vertices[i as usize].position.as_dvec3());
            return mesh.triangles.iter().any(|t| faces.iter().any(|face| face.holds(t.map(corner), near)));
        }
        self.faces().iter().any(|face| faces.iter().any(|other| face.may_touch(other, near)))
    }

    /// None for meshes.
    fn faces(&self) -> Vec<Face> {
        let map = self.transform.0;
        let flat = |axis: DVec3| Face::flat(map, axis);
        let ends = |axis: DVec3| [flat(axis), flat(-axis)];
        match &self.shape {
            Shape::Sphere => vec![Face::round(map, DVec3::ONE)],
            Shape::Box => DVec3::AXES.into_iter().flat_map(ends).collect(),
            Shape::Cylinder => {
                let mantle = Face::round(map, DVec3::new(1.0, 0.0, 1.0));
                ends(DVec3::Y).into_iter().chain([mantle]).collect()
            }
            Shape::Plane | Shape::Disk { .. } => {
                let Face::Flat { normal, .. } = flat(DVec3::Y) else { return Vec::new() };
                vec![Face::Flat { at: map.translation, normal }]
            }
            Shape::Mesh(_) => Vec::new(),
        }
    }
}

impl Face {
    /// Through the end of this axis of a shape's own space, across it.
    fn flat(map: DAffine3, axis: DVec3) -> Self {
        let normal = (map.matrix3.inverse().transpose() * axis).normalize_or_zero();
        Self::Flat { at: map.transform_point3(axis), normal }
    }

    /// The unit sphere of a shape's own space, or with a part of its axes the cylinder along the others.
    fn round(map: DAffine3, axes: DVec3) -> Self {
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
