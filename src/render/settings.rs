//! Configures how an image is rendered, whatever the scene.

use super::Window;
use crate::program::{ProgramOptions, Schedule};

/// The settings of a render.
#[derive(Debug, Clone)]
pub struct RenderSettings {
    /// The schedule, masks, purpose and layers.
    pub options: ProgramOptions,
    /// K, the maximum number of segments of one fused pass; it grows if a sample has many rounds.
    pub segments: u32,
    /// The bytes on the device that an image may use, including its scene.
    pub memory: u64,
    /// The maximum number of pixels in a tile; the memory and the device's limits apply too.
    pub tile_pixels: u64,
    /// The part of the image to render; `None` for all of it.
    pub window: Option<Window>,
    /// `true` to time intersecting and scattering separately from advancing, if they have passes. Each then needs an encoder pass, which
    /// costs more than a round without active rays.
    pub apart: bool,
}

impl RenderSettings {
    /// Returns the maximum number of segments of one pass.
    pub(super) fn segments_a_pass(&self) -> u32 {
        if self.options.schedule == Schedule::Whole { u32::MAX } else { self.segments }
    }
}

impl Default for RenderSettings {
    fn default() -> Self {
        Self {
            options: ProgramOptions::default(),
            segments: 64,
            memory: 1 << 30,
            // Enough to fill any device, while the host can still hold the bands.
            tile_pixels: 1 << 22,
            window: None,
            apart: false,
        }
    }
}
