//! What a drawing shows of a law: horizons, edges, what captures.

use std::sync::Arc;

use glam::DVec3;

use crate::model::cut::{CutPlane, Outline, sphere_in_plane, star_in_plane};

/// A closed surface that a law has without an object.
#[derive(Clone)]
pub struct Landmark {
    /// Its name in a legend.
    pub name: &'static str,
    /// Its center.
    pub center: DVec3,
    /// Its radius, or that of a ball that holds it; 0 for none.
    pub radius: f64,
    /// Do rays end there?
    pub captures: bool,
    /// What is inside, if it is no sphere: of each line from the center a stretch from there.
    pub inside: Option<Arc<dyn Fn(DVec3) -> bool>>,
}

impl Landmark {
    /// A sphere.
    #[must_use]
    pub fn sphere(name: &'static str, center: DVec3, radius: f64, captures: bool) -> Self {
        Self { name, center, radius, captures, inside: None }
    }

    /// Where it crosses a plane, if it does.
    #[must_use]
    pub fn cut(&self, plane: &CutPlane) -> Option<Outline> {
        match &self.inside {
            Some(inside) => star_in_plane(self.center, self.radius, &**inside, plane),
            None => sphere_in_plane(self.center, self.radius, plane),
        }
    }
}
