//! Runs samples of a tile, or single steps.

use super::clock::Clock;
use super::prepared::Prepared;
use super::runner::{Reached, Runner};
use super::sample::Sample;
use super::step::Step;
use super::submission_size::part;
use crate::gpu::{GpuError, Tile};

impl Prepared<'_> {
    /// Runs one sample of a tile with all its rounds. `progress` receives the completed fraction of the work whenever a submission ends; the
    /// last call receives 1.
    pub(super) fn run_sample(
        &self,
        tile: &Tile,
        sample: Sample,
        clock: &mut Clock,
        progress: &dyn Fn(f64),
    ) -> Result<(), GpuError> {
        self.run_samples(tile, std::iter::once(sample), clock, progress)
    }

    /// Runs samples of a tile like [`run_sample`](Self::run_sample), without a wait between them, in submissions short enough for any
    /// driver.
    pub(super) fn run_samples(
        &self,
        tile: &Tile,
        samples: impl ExactSizeIterator<Item = Sample>,
        clock: &mut Clock,
        progress: &dyn Fn(f64),
    ) -> Result<(), GpuError> {
        let rounds = self.program.features.rounds;
        let all = u64::from(rounds) * self.plan.steps.iter().map(|step| step.weight).sum::<u64>();
        self.submission.begin_tile();
        // The size may change meanwhile, and the fraction must not fall.
        let each = self.submission.get() / tile.pixels();
        let count = samples.len() as f64;
        let told = |ended: Reached| progress((ended.sample as f64 + part(ended.weight, all, each)) / count);
        let mut runner = Runner::new(self, tile, &told);
        samples.enumerate().try_for_each(|(k, sample)| runner.record(k, sample, clock))?;
        runner.submit(clock)?;
        runner.wait(0)?;
        progress(1.0);
        Ok(())
    }

    /// Runs one round of a sample of a tile.
    pub(super) fn run_round(&self, tile: &Tile, sample: Sample, round: u32, clock: &mut Clock) -> Result<(), GpuError> {
        let mut runner = Runner::new(self, tile, &|_| {});
        runner.begin_round(sample, round, clock)?;
        runner.record_round(sample, round, clock)?;
        runner.submit(clock)?;
        runner.wait(0)
    }

    /// Runs some steps at once, outside the loop over a whole sample.
    pub(super) fn run_steps(&self, tile: &Tile, sample: Sample, steps: &[Step]) -> Result<(), GpuError> {
        let mut clock = Clock::new(self.gpu, false);
        let mut runner = Runner::new(self, tile, &|_| {});
        runner.begin_round(sample, 0, &mut clock)?;
        for step in steps {
            runner.push(0, *step);
        }
        runner.submit(&mut clock)?;
        runner.wait(0)
    }
}
