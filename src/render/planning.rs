//! Which plan a renderer goes by: one for walks that no pass suspends, or few, until a walk did not end.

use std::cell::OnceCell;

use super::Renderer;
use super::plan::Plan;
use super::schedule::steps;
use crate::program::Work;

impl Renderer<'_> {
    pub(super) fn plan_steps(&mut self) {
        self.short = self.planned(&Work { passes_per_segment: 1, ..self.program.work });
        self.long = OnceCell::new();
    }

    fn planned(&self, work: &Work) -> Plan {
        let choice = &self.settings.choice;
        let steps = steps(&self.scene, choice, work, self.max_segments, self.settings.segments);
        Plan::new(steps, choice.rounds(&self.scene))
    }

    /// With passes for the longest walks that there could be, from now on.
    pub(super) fn longest_plan(&self) -> &Plan {
        self.is_long.set(true);
        self.plan()
    }

    /// What runs.
    pub(super) fn plan(&self) -> &Plan {
        if self.is_long.get() { self.long.get_or_init(|| self.planned(&self.program.work)) } else { &self.short }
    }
}
