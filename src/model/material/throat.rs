//! The throat of a wormhole: rays that hit it continue from its other mouth. The law places it; scenes do not name it.

use glam::DVec3;

use super::{Facts, Surface};

/// A surface that moves rays to the other mouth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Throat;

impl Surface for Throat {
    fn facts(&self) -> Facts<'_> {
        Facts { deflects: false, ..Facts::scattering("surface/scatter/throat") }
    }

    fn albedo(&self, _: DVec3) -> DVec3 {
        DVec3::ONE
    }
}
