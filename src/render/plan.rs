//! Stores the steps of a schedule, and the parameters of each for the device.

use super::batch::Batch;
use super::step::Step;
use crate::gpu::Sections;
use crate::model::Value::{self, Uint};

/// The steps of each round of a sample.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub steps: Vec<Step>,
    /// All distinct parameters, in order.
    pub parameters: Vec<DispatchParameters>,
    pub batch: Batch,
}

impl Plan {
    pub(super) fn new(steps: Vec<Step>, rounds: u32) -> Self {
        let mut parameters: Vec<_> = steps.iter().map(DispatchParameters::of).collect();
        parameters.sort_unstable();
        parameters.dedup();
        let batch = Batch::of(&steps, rounds);
        Self { steps, parameters, batch }
    }

    /// Returns the numbers of sections that the divided buffers need.
    pub(super) fn sections(&self) -> Sections {
        let Batch { rounds, active } = self.batch;
        Sections {
            parameters: self.parameters.len() as u64,
            active: rounds * active,
            open: self.batch.open(),
            star_images: 0,
        }
    }

    /// Returns the section with a step's parameters.
    pub(super) fn parameters_of(&self, step: &Step) -> u64 {
        self.parameters.binary_search(&DispatchParameters::of(step)).unwrap_or(0) as u64
    }
}

/// The parameters of a step for its pass, as in `shaders/state/arguments.wgsl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct DispatchParameters {
    start: usize,
    end: usize,
    again: bool,
    first: bool,
}

impl DispatchParameters {
    fn of(step: &Step) -> Self {
        Self { start: step.slots.start, end: step.slots.end, again: step.again, first: step.first }
    }

    pub(super) fn row(self) -> [(&'static str, Value); 4] {
        [
            ("start", Uint(self.start as u32)),
            ("end", Uint(self.end as u32)),
            ("again", Uint(self.again.into())),
            ("first", Uint(self.first.into())),
        ]
    }
}
