//! How a picture is rendered, whatever it shows.

use super::Window;
use crate::program::{Choice, Schedule};

/// How to render.
#[derive(Debug, Clone)]
pub struct RenderSettings {
    /// Schedule, masks, purpose and layers.
    pub choice: Choice,
    /// K: segments of one fused pass, at most; more where a sample has many rounds.
    pub segments: u32,
    /// Bytes on the device that a picture may take, with its scene.
    pub memory: u64,
    /// The largest tile, in pixels; the memory and the device's limits apply besides.
    pub tile_pixels: u64,
    /// The part of the picture that is rendered; none for all of it.
    pub window: Option<Window>,
    /// Are intersecting and scattering timed apart from advancing, where they have passes? That takes a pass of the encoder for each
    /// of them, which costs more than the round without active rays.
    pub apart: bool,
}

impl RenderSettings {
    /// Segments of one pass, at most.
    pub(super) fn segments_a_pass(&self) -> u32 {
        if self.choice.schedule == Schedule::Whole { u32::MAX } else { self.segments }
    }
}

impl Default for RenderSettings {
    fn default() -> Self {
        Self {
            choice: Choice::default(),
            segments: 64,
            memory: 1 << 30,
            // Enough to fill any device, and bands that the host holds with ease.
            tile_pixels: 1 << 22,
            window: None,
            apart: false,
        }
    }
}
