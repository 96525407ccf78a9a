//! The passes of a program.

use super::Features;
use crate::program::{Mode, Pass, Schedule};

impl Features {
    /// Returns the passes, in the order in which they first run.
    #[must_use]
    pub fn passes(&self) -> Vec<Pass> {
        if self.shades_ends() {
            return vec![Pass::Reshade];
        }
        let mut passes = match (self.mode, self.schedule) {
            (Mode::Bare, _) => return vec![Pass::Setup, Pass::Bare],
            (Mode::Lit, _) => return vec![Pass::Setup, Pass::Shots],
            (_, Schedule::Whole) => vec![Pass::Whole],
            (_, Schedule::Fused) => vec![Pass::Setup, Pass::Advance],
            (_, Schedule::Segment) => vec![Pass::Setup, Pass::Integrate],
            (_, Schedule::Paper) => vec![Pass::Setup, Pass::SingleStep],
        };
        if matches!(self.schedule, Schedule::Segment | Schedule::Paper) {
            passes.extend(self.has_objects.then_some(Pass::Intersect));
            passes.push(Pass::Terminate);
            passes.extend(self.scatters.then_some(Pass::Scatter));
        }
        if self.schedule != Schedule::Whole {
            passes.push(if self.is_picture() { Pass::Shade } else { Pass::Record });
        }
        passes.extend(self.adapts.then_some(Pass::Refine));
        passes.extend(self.grid_passes());
        passes
    }

    /// Returns the passes after each round of the grid.
    pub fn grid_passes(&self) -> impl Iterator<Item = Pass> {
        let measures = self.has_grid && (self.keeps_footprints || self.describes_bundles());
        let stars = self.has_stars.then_some([Pass::FindStars, Pass::LightStars, Pass::GatherStars]);
        measures.then_some(Pass::MeasureBundles).into_iter().chain(stars.into_iter().flatten())
    }
}
