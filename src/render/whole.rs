//! Where a path outlives the pass that was to follow all of it.
//!
//! *Practice.* A pass ends a ray's loops before the device would. Which rays that meets is known of none before it is followed, and of
//! hardly any scene is it true at all: so `whole` keeps no state, and where its count of rays says that one lived on, the picture
//! is gone on with by `fused` from the rows at hand, and so are all pictures that come after.

use super::{RenderError, RenderSettings, Renderer};
use crate::program::{Choice, Schedule};

impl Renderer<'_> {
    /// What renders now: the same by the schedule `fused` once a path outlived the pass that was to follow all of it.
    pub(super) fn current(&self) -> &Self {
        self.fused.get().map_or(self, Box::as_ref)
    }

    /// Goes over to `fused`.
    pub(super) fn go_over(&self) -> Result<&Self, RenderError> {
        if self.fused.get().is_none() {
            let choice = Choice { schedule: Schedule::Fused, ..self.settings.choice.clone() };
            let settings = RenderSettings { choice, ..self.settings.clone() };
            let mut fused = Self::of(self.gpu, self.scene.clone(), settings, self.grids.clone())?;
            fused.take_moments(&self.moments)?;
            // Nothing else fills it: a renderer is not shared by threads.
            let _ = self.fused.set(Box::new(fused));
        }
        Ok(self.current())
    }

    /// Are paths followed in one pass?
    pub(super) fn is_whole(&self) -> bool {
        self.settings.choice.schedule == Schedule::Whole
    }
}
