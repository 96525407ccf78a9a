//! A wormhole's throat: what meets it goes on from its other mouth. Scenes do not name it; the law puts it there.

use glam::DVec3;

use super::Surface;

/// Sends rays on from the other mouth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Throat;

impl Surface for Throat {
    fn part(&self) -> &'static str {
        "surface/scatter/throat"
    }

    fn continues(&self) -> bool {
        true
    }

    fn deflects(&self) -> bool {
        false
    }

    fn albedo(&self, _: DVec3) -> DVec3 {
        DVec3::ONE
    }
}
