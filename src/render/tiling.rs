//! In what tiles a picture is rendered.
//!
//! *Practice.* What does not grow with the tile (the scene's buffers and pictures, the lists' arguments) is taken off the budget
//! first; the rest buys pixels, each at what is kept for it and what of that is read back. A tile is at most as
//! wide as a texture may be, and as high as keeps a band of full rows within the pixels bought, because the host holds one.

use super::{Renderer, Window};
use crate::gpu::{GpuError, SceneBuffers, memory};

/// Pixels of a tile whose paths are followed in one dispatch: no more than drivers bear where paths are long.
const WHOLE: u64 = 1 << 20;
/// A tile of fewer pixels is not worth a dispatch.
const LEAST: u64 = 64;

impl Renderer<'_> {
    /// What is rendered: the settings' window, or all of the picture.
    #[must_use]
    pub fn window(&self) -> Window {
        self.prepared.settings.window.unwrap_or(Window::whole(self.prepared.scene.image.size))
    }

    /// Bytes on the device that are the same for every size of tile.
    fn fixed_memory(&self) -> u64 {
        SceneBuffers::bytes(self.prepared.all_buffers()) + self.prepared.plan.sections().bytes()
    }

    /// The largest tile that the budget and the device allow for the window.
    pub(super) fn tile_size(&self) -> Result<[u32; 2], GpuError> {
        let [width, height] = self.window().size;
        let memory = memory(&self.prepared.program);
        let (fixed, each) = (self.fixed_memory(), memory.bytes_per_pixel() + memory.read_back());
        let bought = self.prepared.settings.memory.saturating_sub(fixed) / each;
        if bought < LEAST {
            return Err(GpuError::Memory { allowed: self.prepared.settings.memory, needed: fixed + LEAST * each });
        }
        let side = self.prepared.gpu.limits.max_texture_dimension_2d.min(1 << 16);
        // Of buffers the device bounds the size.
        let buffer =
            self.prepared.gpu.limits.max_storage_buffer_binding_size.min(self.prepared.gpu.limits.max_buffer_size);
        let most = if self.prepared.is_whole() { WHOLE } else { u64::MAX };
        let pixels =
            bought.min(most).min(self.prepared.settings.tile_pixels).min(buffer / memory.largest_item()).max(LEAST);
        // Of a tile's corners a column and a row are beyond it.
        let margin = self.prepared.program.features.margin();
        let columns = u32::try_from(pixels / u64::from(1 + margin)).unwrap_or(u32::MAX);
        let tile_width = width.min(side - margin).min(columns - margin);
        let rows = pixels / u64::from(width + margin);
        let rows = rows.saturating_sub(margin.into()).clamp(1, u64::from((side - margin).min(height)));
        Ok([tile_width, rows as u32])
    }
}
