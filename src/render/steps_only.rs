//! Runs integration steps alone, for measurements.

use std::time::{Duration, Instant};

use super::clock::Clock;
use super::sample::Sample;
use super::trace::Tracer;
use super::{RenderError, Totals};
use crate::gpu::GpuError;
use crate::program::Role;

impl Tracer<'_> {
    /// Advances the ray of every pixel, row by row, by the given numbers of steps in one pass, for a tracer made for `Bare`. Returns the
    /// time of the pass on the device, or the total time if the device has no timestamps.
    ///
    /// # Errors
    ///
    /// Returns [`GpuError::Layout`] if the number of steps is not that of the pixels, or another error if the device fails.
    pub fn bare(&self, steps: &[u32]) -> Result<Duration, RenderError> {
        let prepared = &self.prepared;
        let size = prepared.scene.image.size;
        let mut tile = prepared.tile(size)?;
        if steps.len() as u64 != u64::from(size[0]) * u64::from(size[1]) {
            let problem = format!("{} steps for {}×{} pixels", steps.len(), size[0], size[1]);
            return Err(GpuError::Layout { binding: Role::WantedSteps.to_string(), problem }.into());
        }
        tile.add_input(prepared.gpu, &Role::WantedSteps, bytemuck::cast_slice(steps))?;
        let (mut totals, mut clock) = (Totals::default(), Clock::new(prepared.gpu, false));
        let started = Instant::now();
        prepared.run_sample(&tile, Sample::first(size), &mut clock, &|_| {})?;
        prepared.finish_totals(&mut totals, &clock, started)?;
        Ok(totals.advance())
    }
}
