//! The throat of a wormhole: rays that hit it continue from its other mouth. The law places it; scenes do not name it.

use glam::DVec3;

use super::{Surface, SurfaceProperties};

/// A surface that moves rays to the other mouth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Throat;

impl Surface for Throat {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties { deflects: false, ..SurfaceProperties::scattering("surface/scatter/throat") }
    }

    fn albedo(&self, _: DVec3) -> DVec3 {
        DVec3::ONE
    }
}
