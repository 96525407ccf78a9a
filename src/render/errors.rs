//! The standard errors of a tile's pixels, from what the device has kept of their samples.

use super::adaptive::Moments;
use super::noise::LUMINANCE;
use super::readback::read_texture;
use super::{RenderError, Renderer};
use crate::gpu::Tile;
use crate::program::Role;

impl Renderer<'_> {
    /// The standard error of every pixel of a tile after so many samples, infinite where it has one; none where nothing of the kind was kept.
    pub(super) fn read_errors(
        &self,
        tile: &Tile,
        samples: u32,
        moments: Option<&[Moments]>,
    ) -> Result<Option<Vec<f32>>, RenderError> {
        if let Some(moments) = moments {
            return Ok(Some(moments.iter().map(Moments::error).collect()));
        }
        let Some(texture) = tile.texture(&Role::Kept("spread")) else { return Ok(None) };
        let n = samples as f32;
        let error =
            |bits: u32| if n > 1.0 { (f32::from_bits(bits) / (n * (n - 1.0))).max(0.0).sqrt() } else { f32::INFINITY };
        Ok(Some(read_texture(self.gpu, texture)?.into_iter().map(error).collect()))
    }
}

impl Moments {
    /// Of the mean of its own samples: no more than that of a pixel whose channels err together.
    fn error(&self) -> f32 {
        let n = self.rays.saturating_sub(1) as f32;
        if n < 2.0 {
            return f32::INFINITY;
        }
        let of_channel = |(squares, part): (&f32, f32)| part * (squares / (n * (n - 1.0))).sqrt();
        self.squares.iter().zip(LUMINANCE).map(of_channel).sum()
    }
}
