//! The stars of a sky: points of light at infinity.

use std::sync::Arc;

use glam::DMat3;

use crate::assets::{Catalog, Star};

/// The illuminance of a star of magnitude 0 outside the atmosphere, in lux.
const ZERO_MAGNITUDE: f64 = 2.54e-6;

/// The table `[sky.stars]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Stars {
    /// The stars, in the axes of the catalog.
    pub catalog: Arc<Catalog>,
    /// The factor of their light; 1 gives radiance in cd/m².
    pub intensity: f64,
    /// The magnitude of the faintest stars.
    pub limit: f64,
    /// The rotation from the catalog to the scene.
    pub rotation: DMat3,
    /// The diameter of a star's disk, in radians.
    pub size: f64,
}

impl Stars {
    /// Returns `true` if other stars have the same places in the catalog and the same light. They may be turned, and their disks may have
    /// another size.
    #[must_use]
    pub fn are_those_of(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.catalog, &other.catalog) && (self.intensity, self.limit) == (other.intensity, other.limit)
    }

    /// Returns `true` if a star is not too faint to be shown.
    #[must_use]
    pub fn shows(&self, star: &Star) -> bool {
        f64::from(star.magnitude) <= self.limit
    }

    /// Returns the stars that are shown.
    pub fn shown(&self) -> impl Iterator<Item = &Star> {
        self.catalog.stars.iter().filter(|star| self.shows(star))
    }

    /// Returns the light of a star in the scene.
    #[must_use]
    pub fn flux(&self, star: &Star) -> f64 {
        self.intensity * flux(star.magnitude.into())
    }
}

/// Returns the illuminance of a star of this visual magnitude, in lux.
#[must_use]
pub fn flux(magnitude: f64) -> f64 {
    ZERO_MAGNITUDE * 10_f64.powf(-0.4 * magnitude)
}
