//! `[[objects]]`: what there is to meet: a shape, where it is, and what it is made of.
//!
//! *Theory.* An analytic shape is where a few functions of its own coordinates are below 0, one for each of its faces; the distance
//! from a face is, to first order, the function over the length of its gradient in the scene. A closed mesh is where its winding
//! number is not 0.

use std::sync::Arc;

use glam::DVec3;

use super::{Shape, Solid, Travel, ball};
use crate::assets::Transform;
use crate::model::cut::{CutPlane, Outline, OwnPlane};
use crate::model::medium::Interior;

/// A shape in its own space, where it is, and what it is made of.
#[derive(Debug, Clone)]
pub struct Object {
    /// The shape.
    pub shape: Arc<dyn Shape>,
    /// From the shape's own space to the scene's.
    pub transform: Transform,
    /// What it is made of.
    pub substance: Substance,
    /// How it moves, if it does.
    pub travel: Option<Travel>,
}

impl PartialEq for Object {
    fn eq(&self, other: &Self) -> bool {
        *self.shape == *other.shape
            && self.transform == other.transform
            && self.substance == other.substance
            && self.travel == other.travel
    }
}

/// What an object is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Substance {
    /// A surface: index into [`Scene::materials`](crate::scene::Scene::materials).
    Opaque(usize),
    /// A medium that light goes through.
    Clear(Interior),
}

impl Object {
    /// At rest.
    #[must_use]
    pub fn new(shape: Arc<dyn Shape>, transform: Transform, substance: Substance) -> Self {
        Self { shape, transform, substance, travel: None }
    }

    /// Returns the objects that stand for it if rays are on one of its sides: itself, unless it is a mesh that is not wound outward or
    /// overlaps itself.
    #[must_use]
    pub fn solids(self) -> Vec<Self> {
        let solids = self.shape.solids();
        if solids.is_empty() {
            return vec![self];
        }
        solids.into_iter().map(|shape| Self { shape, ..self.clone() }).collect()
    }

    /// The index of its material, if it has one.
    #[must_use]
    pub fn material(&self) -> Option<usize> {
        match self.substance {
            Substance::Opaque(material) => Some(material),
            Substance::Clear(_) => None,
        }
    }

    /// What it is filled with, if light goes through it.
    #[must_use]
    pub fn interior(&self) -> Option<&Interior> {
        match &self.substance {
            Substance::Opaque(_) => None,
            Substance::Clear(interior) => Some(interior),
        }
    }

    /// What the shaders test.
    #[must_use]
    pub fn solid(&self) -> &'static Solid {
        self.shape.solid(&self.transform)
    }

    /// A ball that holds all of it: centre and radius.
    #[must_use]
    pub fn ball(&self) -> (DVec3, f64) {
        ball(self.shape.radius(), &self.transform)
    }

    /// The corners of a box that holds all of it: lower and upper.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.shape.bounds(self.transform.0)
    }

    /// Is this point of the scene inside? Shapes without an inside contain nothing.
    #[must_use]
    pub fn contains(&self, x: DVec3) -> bool {
        self.shape.contains(self.transform.0.inverse().transform_point3(x))
    }

    /// Is this point of the scene no farther than `slack` from the surface, about?
    #[must_use]
    pub fn near_surface(&self, x: DVec3, slack: f64) -> bool {
        let inverse = self.transform.0.inverse();
        let m = inverse.matrix3;
        let most = [m.x_axis, m.y_axis, m.z_axis].map(DVec3::length).into_iter().fold(0.0, f64::max);
        self.shape.near_surface(inverse.transform_point3(x), slack * most)
    }

    /// The signed distance of this point of the scene from the surface, in scene units, to first order: negative inside. None where
    /// there is no inside, and for meshes. It is exact for spheres, inside boxes, and inside cylinders that are round.
    #[must_use]
    pub fn gap(&self, x: DVec3) -> Option<f64> {
        let inverse = self.transform.0.inverse();
        let to_scene = inverse.matrix3.transpose();
        let faces = self.shape.faces(inverse.transform_point3(x));
        faces.iter().map(|(value, gradient)| value / (to_scene * *gradient).length()).reduce(f64::max)
    }

    /// Where its surface crosses the plane: nothing if it does not. A surface that lies in the plane shows its edge.
    #[must_use]
    pub fn cut(&self, plane: &CutPlane) -> Vec<Outline> {
        let map = self.transform.0;
        let Some(own) = OwnPlane::of(plane, map.matrix3.transpose(), map.translation) else { return Vec::new() };
        let placed = |outline: Outline| Outline {
            points: outline.points.into_iter().map(|p| map.transform_point3(p)).collect(),
            closed: outline.closed,
        };
        self.shape.cut(own).into_iter().map(placed).collect()
    }
}
