//! Objects in `[[objects]]`: a shape with its placement and its substance.
//!
//! *Theory.* An analytic shape is the region where a few functions of object coordinates are negative, one for each face. To first order,
//! the distance from a face is its function divided by the length of its gradient in the scene. A closed mesh is the region where its
//! winding number is not 0.

use std::sync::Arc;

use glam::DVec3;

use super::{Primitive, RigidMotion, Shape, ball};
use crate::assets::Transform;
use crate::model::cross_section::{CutPlane, LocalPlane, Outline};
use crate::model::law::Spherical;
use crate::model::medium::Interior;

/// A shape in object space with its placement and its substance.
#[derive(Debug, Clone)]
pub struct Object {
    /// The shape.
    pub shape: Arc<dyn Shape>,
    /// The map from object space to the scene.
    pub transform: Transform,
    /// The substance.
    pub substance: Substance,
    /// The motion; `None` for a static object.
    pub travel: Option<RigidMotion>,
}

impl PartialEq for Object {
    fn eq(&self, other: &Self) -> bool {
        *self.shape == *other.shape
            && self.transform == other.transform
            && self.substance == other.substance
            && self.travel == other.travel
    }
}

/// The substance of an object.
#[derive(Debug, Clone, PartialEq)]
pub enum Substance {
    /// A surface material: the index into [`Scene::materials`](crate::scene::Scene::materials).
    Opaque(usize),
    /// A transparent medium.
    TransparentShadows(Interior),
}

impl Object {
    /// Creates a static object.
    #[must_use]
    pub fn new(shape: Arc<dyn Shape>, transform: Transform, substance: Substance) -> Self {
        Self { shape, transform, substance, travel: None }
    }

    /// Returns the objects that replace it if rays track their side: the object itself, unless it is a mesh that is not wound outward or
    /// overlaps itself.
    #[must_use]
    pub fn solids(self) -> Vec<Self> {
        let solids = self.shape.solids();
        if solids.is_empty() {
            return vec![self];
        }
        solids.into_iter().map(|shape| Self { shape, ..self.clone() }).collect()
    }

    /// Returns the index of the material, if the object has one.
    #[must_use]
    pub fn material(&self) -> Option<usize> {
        match self.substance {
            Substance::Opaque(material) => Some(material),
            Substance::TransparentShadows(_) => None,
        }
    }

    /// Returns the interior of a transparent object.
    #[must_use]
    pub fn interior(&self) -> Option<&Interior> {
        match &self.substance {
            Substance::Opaque(_) => None,
            Substance::TransparentShadows(interior) => Some(interior),
        }
    }

    /// Returns the solid that shaders test.
    #[must_use]
    pub fn solid(&self) -> &'static Primitive {
        self.shape.solid(&self.transform)
    }

    /// Returns the center and radius of a bounding sphere.
    #[must_use]
    pub fn ball(&self) -> (DVec3, f64) {
        ball(self.shape.radius(), &self.transform)
    }

    /// Returns a position in coordinates about the object's center and its y axis, which is the normal of a disk.
    #[must_use]
    pub fn spherical(&self, x: DVec3) -> Spherical {
        let map = self.transform.0;
        let axis = (map.matrix3.inverse().transpose() * DVec3::Y).normalize_or(DVec3::Y);
        Spherical::about(axis, x - map.translation)
    }

    /// Returns the lower and upper corner of a bounding box.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.shape.bounds(self.transform.0)
    }

    /// Returns `true` if a point of the scene is inside; shapes without an inside contain no points.
    #[must_use]
    pub fn contains(&self, x: DVec3) -> bool {
        self.shape.contains(self.transform.0.inverse().transform_point3(x))
    }

    /// Returns `true` if a point of the scene is approximately within `slack` of the surface.
    #[must_use]
    pub fn near_surface(&self, x: DVec3, slack: f64) -> bool {
        let inverse = self.transform.0.inverse();
        let m = inverse.matrix3;
        let most = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length).into_iter().fold(0.0, f64::max);
        self.shape.near_surface(inverse.transform_point3(x), slack * most)
    }

    /// Returns the signed distance of a point of the scene from the surface to first order, in scene units and negative inside, or `None`
    /// for meshes and shapes without an inside. It is exact for spheres, inside boxes, and inside circular cylinders.
    #[must_use]
    pub fn signed_distance(&self, x: DVec3) -> Option<f64> {
        let inverse = self.transform.0.inverse();
        let to_scene = inverse.matrix3.transpose();
        let faces = self.shape.faces(inverse.transform_point3(x));
        faces.iter().map(|(value, gradient)| value / (to_scene * *gradient).length()).reduce(f64::max)
    }

    /// Returns the lines in which the surface crosses a plane, if any, or its edge if it is in the plane.
    #[must_use]
    pub fn cut(&self, plane: &CutPlane) -> Vec<Outline> {
        let map = self.transform.0;
        let Some(own) = LocalPlane::of(plane, map.matrix3.transpose(), map.translation) else { return Vec::new() };
        let placed = |outline: Outline| Outline {
            points: outline.points.into_iter().map(|p| map.transform_point3(p)).collect(),
            closed: outline.closed,
        };
        self.shape.cut(own).into_iter().map(placed).collect()
    }
}
