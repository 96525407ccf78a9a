//! Steps and nothing else, for measurements.

use std::time::{Duration, Instant};

use wgpu::BufferUsages;

use super::clock::Clock;
use super::renderer::Frame;
use super::{RenderError, Renderer, Totals};
use crate::gpu::GpuError;

impl Renderer<'_> {
    /// Moves the ray of every pixel, row by row, by so many steps, in one pass; the program's purpose is that. The time that the
    /// pass takes on the device, or the whole time where devices do not say.
    pub fn bare(&self, steps: &[u32]) -> Result<Duration, RenderError> {
        let size = self.scene.image.size;
        let mut tile = self.tile(size)?;
        let bytes: &[u8] = bytemuck::cast_slice(steps);
        let name = "wanted_steps";
        tile.add_buffer(self.gpu, name, bytes.len() as u64, BufferUsages::STORAGE)?;
        let Some(buffer) = tile.buffer(name).filter(|_| steps.len() as u64 == u64::from(size[0]) * u64::from(size[1]))
        else {
            let problem = format!("{} steps for {}×{} pixels", steps.len(), size[0], size[1]);
            return Err(GpuError::Layout { binding: name.to_owned(), problem }.into());
        };
        self.gpu.queue.write_buffer(buffer, 0, bytes);
        let (mut totals, mut clock) = (Totals::default(), Clock::new(self.gpu, false));
        let started = Instant::now();
        self.run_sample(&tile, Frame { origin: [0, 0], image: size, sample: 0, refines: None }, &mut clock, &|_| {})?;
        self.finish_totals(&mut totals, &clock, started)?;
        Ok(totals.advance())
    }
}
