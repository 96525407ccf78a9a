//! A wormhole's throat: what meets it goes on from its other mouth. Scenes do not name it; the law puts it there.

use glam::DVec3;

use super::{Facts, Surface};

/// Sends rays on from the other mouth.
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
