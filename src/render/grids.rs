//! Stores the photon grids of a scene's lights, with reports on their creation.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use super::Totals;
use crate::gpu::LightGridData;

/// The grids in the order of the scene's lights that have one, or of the beams that guide its paths.
#[derive(Debug, Clone, Default)]
pub(super) struct LightGrids {
    pub fields: Arc<[LightGridData]>,
    pub reports: Vec<LightReport>,
    /// `true` once the renderer has another step control than the paths of the grids.
    pub is_outdated: bool,
}

/// The source of the light in a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GridSource {
    /// A light, by its index in the scene file.
    Light(usize),
    /// An emitter that guides paths, by its object, and the mirror or transparent object that it shines on (`None` for all directions).
    Beam(usize, Option<usize>),
}

impl fmt::Display for GridSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Light(light) => write!(f, "lights[{light}]"),
            Self::Beam(lamp, None) => write!(f, "path guiding from objects[{lamp}]"),
            Self::Beam(lamp, Some(object)) => write!(f, "path guiding from objects[{lamp}] via objects[{object}]"),
        }
    }
}

/// A report on the creation of a photon grid.
#[derive(Debug, Clone, PartialEq)]
pub struct LightReport {
    /// The source of its light.
    pub of: GridSource,
    /// The number of voxels along each axis.
    pub count: [u32; 3],
    /// The number of voxels that were refined, and the number that were to be.
    pub refined: [usize; 2],
    /// The bytes on the device during a render.
    pub bytes: u64,
    /// The totals of the paths.
    pub totals: Totals,
    /// The time that the grid took, without the compilation of its passes.
    pub wall: Duration,
}

impl LightReport {
    /// Returns the number of paths whose light is missing; 0 for path guiding, which does not affect the result.
    #[must_use]
    pub fn unfollowed(&self) -> u64 {
        if matches!(self.of, GridSource::Light(_)) { self.totals.unfollowed() } else { 0 }
    }
}

impl fmt::Display for LightReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([x, y, z], [refined, wanted]) = (self.count, self.refined);
        let mebibytes = self.bytes as f64 / f64::from(1 << 20);
        write!(f, "{}: {x}×{y}×{z} voxels, {refined} refined", self.of)?;
        if refined < wanted {
            write!(f, " (of {wanted}, limited by memory)")?;
        }
        write!(f, ", {} paths, {mebibytes:.1} MiB, {:.3} s", self.totals.rays, self.wall.as_secs_f64())?;
        match self.unfollowed() {
            0 => Ok(()),
            lost => write!(f, "; {lost} paths could not be traced to their ends"),
        }
    }
}
