//! The grids of a scene's lights, and what making them came to.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use super::Totals;
use crate::gpu::LightField;

/// In the order of the scene's lights that have one.
#[derive(Debug, Clone, Default)]
pub(super) struct LightGrids {
    pub fields: Arc<[LightField]>,
    pub reports: Vec<LightReport>,
}

/// What making a light's grid came to.
#[derive(Debug, Clone, PartialEq)]
pub struct LightReport {
    /// The light's place in the scene file.
    pub light: usize,
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

impl fmt::Display for LightReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([x, y, z], [refined, wanted]) = (self.count, self.refined);
        let mebibytes = self.bytes as f64 / f64::from(1 << 20);
        write!(f, "light {}: {x}×{y}×{z} voxels, {refined} in parts", self.light)?;
        if refined < wanted {
            write!(f, " of {wanted} for want of memory")?;
        }
        write!(f, ", {} paths, {mebibytes:.1} MiB, {:.3} s", self.totals.rays, self.wall.as_secs_f64())?;
        match self.totals.unfollowed() {
            0 => Ok(()),
            lost => write!(f, "; {lost} of them could not be followed to their ends"),
        }
    }
}
