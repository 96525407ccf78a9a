//! Steps and nothing else, for measurements.

use std::time::{Duration, Instant};

use super::clock::Clock;
use super::sample::Sample;
use super::{RenderError, Renderer, Totals};
use crate::gpu::GpuError;
use crate::program::Role;

impl Renderer<'_> {
    /// Moves the ray of every pixel, row by row, by so many steps, in one pass; the program's purpose is that. The time that the
    /// pass takes on the device, or the whole time where devices do not say.
    pub fn bare(&self, steps: &[u32]) -> Result<Duration, RenderError> {
        let size = self.scene.image.size;
        let mut tile = self.tile(size)?;
        if steps.len() as u64 != u64::from(size[0]) * u64::from(size[1]) {
            let problem = format!("{} steps for {}×{} pixels", steps.len(), size[0], size[1]);
            return Err(GpuError::Layout { binding: Role::WantedSteps.to_string(), problem }.into());
        }
        tile.add_input(self.gpu, &Role::WantedSteps, bytemuck::cast_slice(steps))?;
        let (mut totals, mut clock) = (Totals::default(), Clock::new(self.gpu, false));
        let started = Instant::now();
        self.run_sample(&tile, Sample::first(size), &mut clock, &|_| {})?;
        self.finish_totals(&mut totals, &clock, started)?;
        Ok(totals.advance())
    }
}
