//! Divides an image into tiles.
//!
//! *Practice.* The memory that does not depend on the tile (the scene's buffers and textures, the lists' arguments) is subtracted from the
//! budget first. The rest is divided by the cost of a pixel: its values, and the copies of values that are read back. A tile is at most as
//! wide as a texture, and so high that a band of complete rows has at most this number of pixels, because the host holds one band.

use super::{Renderer, Window};
use crate::gpu::{GpuError, SceneBuffers, memory};

/// The minimum number of pixels of a tile that justifies a dispatch.
const LEAST: u64 = 64;

impl Renderer<'_> {
    /// Returns the rendered part of the image: the window of the settings, or the whole image.
    #[must_use]
    pub fn window(&self) -> Window {
        self.prepared.settings.window.unwrap_or(Window::whole(self.prepared.scene.image.size))
    }

    /// Returns the bytes on the device that do not depend on the size of the tile.
    fn fixed_memory(&self) -> u64 {
        SceneBuffers::bytes(self.prepared.all_buffers()) + self.prepared.sections().bytes()
    }

    /// Returns the size of the largest tile that the budget and the device allow for the window.
    pub(super) fn tile_size(&self) -> Result<[u32; 2], GpuError> {
        let [width, height] = self.window().size;
        let memory = memory(&self.prepared.program);
        let (fixed, each) = (self.fixed_memory(), memory.bytes_per_pixel() + memory.read_back());
        let bought = self.prepared.settings.memory.saturating_sub(fixed) / each;
        if bought < LEAST {
            return Err(GpuError::Memory { allowed: self.prepared.settings.memory, needed: fixed + LEAST * each });
        }
        let side = self.prepared.gpu.limits.max_texture_dimension_2d.min(1 << 16);
        // The device limits the size of buffers.
        let buffer =
            self.prepared.gpu.limits.max_storage_buffer_binding_size.min(self.prepared.gpu.limits.max_buffer_size);
        let whole = self.prepared.gpu.profile.whole_pixels;
        let most = if self.prepared.is_whole() { whole } else { u64::MAX };
        let pixels =
            bought.min(most).min(self.prepared.settings.tile_pixels).min(buffer / memory.largest_item()).max(LEAST);
        let margin = self.prepared.program.features.margin().total();
        let columns = u32::try_from(pixels / u64::from(1 + margin)).unwrap_or(u32::MAX);
        let tile_width = width.min(side - margin).min(columns - margin);
        let rows = pixels / u64::from(width + margin);
        let rows = rows.saturating_sub(margin.into()).clamp(1, u64::from((side - margin).min(height)));
        Ok([tile_width, rows as u32])
    }
}
