//! Which plan a renderer goes by: one for walks that no pass suspends, or few, until a walk did not end; then for longer ones.

use super::Renderer;
use super::plan::{Plan, Plans};
use super::schedule::steps;
use crate::program::Work;

/// How many times as long a plan's walks may be as those of the one before.
const LONGER: u64 = 8;

impl Renderer<'_> {
    /// What runs.
    pub(super) fn plan(&self) -> &Plan {
        self.plans.current(|| self.planned(self.passes_per_segment()))
    }

    /// Begins anew with the shortest.
    pub(super) fn plan_steps(&mut self) {
        self.plans = Plans::default();
    }

    /// Goes over to a plan for longer walks, after one did not end. False where they were as long as any could be, or as long as is
    /// borne.
    pub(super) fn plan_longer(&self) -> bool {
        self.program.work.resumed && self.passes_per_segment() < self.most_passes() && self.plans.advance()
    }

    /// Passes over which a walk may be spread by the plan that runs.
    fn passes_per_segment(&self) -> u64 {
        LONGER.pow(self.plans.longer()).min(self.most_passes())
    }

    /// Passes that the longest walk that there could be needs, where those side by side use up each other's turns.
    fn most_passes(&self) -> u64 {
        self.program.work.passes_per_segment * u64::from(self.gpu.lanes.max(1))
    }

    fn planned(&self, passes_per_segment: u64) -> Plan {
        let choice = &self.settings.choice;
        let work = Work { passes_per_segment, ..self.program.work };
        let steps = steps(&self.scene, choice, &work, self.max_segments, self.settings.segments);
        Plan::new(steps, choice.rounds(&self.scene))
    }
}
