//! The surfaces of a law that a diagram shows, such as horizons, edges and capture regions.

use std::sync::Arc;

use glam::DVec3;

use crate::model::cross_section::{CutPlane, Outline, sphere_in_plane, star_in_plane};

/// A closed surface of a law that is not an object.
#[derive(Clone)]
pub struct CharacteristicSurface {
    /// The name in a legend.
    pub name: &'static str,
    /// The center.
    pub center: DVec3,
    /// The radius, or the radius of a bounding sphere; 0 for no surface.
    pub radius: f64,
    /// Is `true` if rays end at the surface.
    pub captures: bool,
    /// The test for points inside, if the surface is not a sphere; the region must be star-shaped around the center.
    pub inside: Option<Arc<dyn Fn(DVec3) -> bool>>,
}

impl CharacteristicSurface {
    /// Creates a sphere.
    #[must_use]
    pub fn sphere(name: &'static str, center: DVec3, radius: f64, captures: bool) -> Self {
        Self { name, center, radius, captures, inside: None }
    }

    /// Returns the outline in which the surface crosses a plane, if it does.
    #[must_use]
    pub fn cut(&self, plane: &CutPlane) -> Option<Outline> {
        match &self.inside {
            Some(inside) => star_in_plane(self.center, self.radius, &**inside, plane),
            None => sphere_in_plane(self.center, self.radius, plane),
        }
    }
}
