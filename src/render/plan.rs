//! A schedule's steps, and what the device is told of each.

use super::schedule::{Batch, Step};
use crate::model::Value::{self, Uint};

/// What runs for each round of a sample.
#[derive(Debug, Default)]
pub(super) struct Plan {
    pub steps: Vec<Step>,
    /// What differs between steps.
    pub turns: Vec<Turn>,
    pub batch: Batch,
}

impl Plan {
    pub(super) fn new(steps: Vec<Step>, rounds: u32) -> Self {
        let mut turns: Vec<_> = steps.iter().map(Turn::of).collect();
        turns.sort_unstable();
        turns.dedup();
        let batch = Batch::of(&steps, rounds);
        Self { steps, turns, batch }
    }
}

/// What a pass is told of its step: `shaders/state/arguments.wgsl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Turn {
    start: usize,
    end: usize,
    again: bool,
    first: bool,
}

impl Turn {
    pub(super) fn of(step: &Step) -> Self {
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
