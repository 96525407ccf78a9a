//! The grids of a scene's lights, and what making them came to.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use super::Totals;
use crate::gpu::LightField;

/// In the order of the scene's lights that have one, or of the beams that guide its paths.
#[derive(Debug, Clone, Default)]
pub(super) struct LightGrids {
    pub fields: Arc<[LightField]>,
    pub reports: Vec<LightReport>,
}

/// Whose light is in a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gridded {
    /// A light's, by its place in the scene file.
    Light(usize),
    /// That of a lamp which guides paths, sent to a mirror or a clear object or everywhere; by the objects' places.
    Beam(usize, Option<usize>),
}

impl fmt::Display for Gridded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Light(light) => write!(f, "light {light}"),
            Self::Beam(lamp, None) => write!(f, "guide from object {lamp}"),
            Self::Beam(lamp, Some(object)) => write!(f, "guide from object {lamp} by object {object}"),
        }
    }
}

/// What making a grid of light came to.
#[derive(Debug, Clone, PartialEq)]
pub struct LightReport {
    /// Whose.
    pub of: Gridded,
    /// Voxels along each axis.
    pub count: [u32; 3],
    /// Voxels that were cut into parts, and those that were to be.
    pub refined: [usize; 2],
    /// Bytes on the device while a picture is made.
    pub bytes: u64,
    /// What became of the paths.
    pub totals: Totals,
    /// The time that it took, without the compilation of its passes.
    pub wall: Duration,
}

impl LightReport {
    /// Paths whose light is missing: what guides others is missed nowhere.
    #[must_use]
    pub fn unfollowed(&self) -> u64 {
        if matches!(self.of, Gridded::Light(_)) { self.totals.unfollowed() } else { 0 }
    }
}

impl fmt::Display for LightReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([x, y, z], [refined, wanted]) = (self.count, self.refined);
        let mebibytes = self.bytes as f64 / f64::from(1 << 20);
        write!(f, "{}: {x}×{y}×{z} voxels, {refined} in parts", self.of)?;
        if refined < wanted {
            write!(f, " of {wanted} for want of memory")?;
        }
        write!(f, ", {} paths, {mebibytes:.1} MiB, {:.3} s", self.totals.rays, self.wall.as_secs_f64())?;
        match self.unfollowed() {
            0 => Ok(()),
            lost => write!(f, "; {lost} of them could not be followed to their ends"),
        }
    }
}
