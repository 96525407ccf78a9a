//! Describes one dispatch as data, before it is recorded.
//!
//! *Idea.* Rays end at very different times, and a pass over all of them would mostly find terminated rays. Therefore active rays are
//! compacted: a pass appends the pixels whose rays continue to a list, and the next pass runs only over this list, by indirect dispatch. A
//! whole sample is recorded before any of it runs, so a step names the lists that it reads and writes by number: the steps that read one
//! list of active rays write the next list of the round.

use std::fmt;

use super::sample::Refines;
use crate::gpu::Slots;
use crate::program::{Pass, RaySkipping};

/// The pixels that a pass processes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dispatch {
    /// Every pixel of the tile.
    Grid,
    /// The pixels of the list that the step reads, by indirect dispatch.
    PixelListKind,
    /// Every pixel in the first round of a sample, and the pixels of the list in later rounds.
    ListedLater,
    /// The cells with starlight.
    Stars,
}

/// A list of pixels, by its number among the lists of its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PixelList {
    /// The pixels with active rays, numbered in each round.
    Active(u64),
    /// The pixels with an unfinished path: 0 is the list of the round, and 1 the list for the next round.
    Open(u64),
    /// The pixels that need more samples, numbered in each tile.
    Wanted(u64),
}

/// One dispatch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// The pass.
    pub pass: Pass,
    /// The slots of the state that it uses.
    pub slots: Slots,
    /// The list that it processes, unless it processes all pixels.
    pub read: PixelList,
    /// The list that it appends to, if its pass does.
    pub written: PixelList,
    /// The pixels that it processes.
    pub dispatch: Dispatch,
    /// The iteration of the loop over segments that it belongs to.
    pub iteration: u64,
    /// `true` if it continues a suspended traversal.
    pub again: bool,
    /// `true` if it belongs to the first segments, which run over the same pixels as the setup.
    pub first: bool,
    /// The maximum number of integration steps of one ray: its weight when the work is divided into submissions.
    pub weight: u64,
}

impl fmt::Display for PixelList {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Active(n) => write!(f, "active {n}"),
            Self::Open(n) => write!(f, "open {n}"),
            Self::Wanted(n) => write!(f, "wanted {n}"),
        }
    }
}

impl fmt::Display for Step {
    /// Writes the pass, the pixels that it processes, and the slots and the list that it writes.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Slots { input, output, .. } = self.slots;
        let over = match self.dispatch {
            Dispatch::Grid => "all pixels".to_owned(),
            Dispatch::Stars => "cells with starlight".to_owned(),
            Dispatch::PixelListKind => format!("list {}", self.read),
            Dispatch::ListedLater => format!("all pixels, in later rounds list {}", self.read),
        };
        let again = if self.again { ", continues suspended traversals" } else { "" };
        write!(
            f,
            "{:<11} over {over}; state {input} -> {output}; appends to list {}{again}",
            self.pass.entry(),
            self.written
        )
    }
}

impl Step {
    /// Returns the step that follows a sample of an adaptive image.
    pub(super) fn refining(refines: Refines, masks: RaySkipping) -> Self {
        let dispatch =
            if refines.listed && masks != RaySkipping::Off { Dispatch::PixelListKind } else { Dispatch::Grid };
        let (read, written) = (PixelList::Wanted(refines.list), PixelList::Wanted(refines.list + 1));
        let slots = Slots::only(0);
        Self { pass: Pass::Refine, slots, read, written, dispatch, iteration: 0, again: false, first: false, weight: 1 }
    }

    /// Returns a step for bundles or starlight, which uses neither the state of rays nor lists of pixels.
    pub(super) fn of_grid(pass: Pass) -> Self {
        let list = PixelList::Active(0);
        let dispatch = if pass == Pass::LightStars { Dispatch::Stars } else { Dispatch::Grid };
        let slots = Slots::only(0);
        Self { pass, slots, read: list, written: list, dispatch, iteration: 0, again: false, first: false, weight: 1 }
    }

    /// Returns the step for a round of a sample: it processes the pixels that take the sample, if these are listed.
    pub(super) fn in_round(mut self, round: u32, refines: Option<Refines>) -> Self {
        if let (0, Dispatch::ListedLater, Some(Refines { listed, list })) = (round, self.dispatch, refines) {
            self.read = PixelList::Wanted(list);
            self.dispatch = if listed { Dispatch::PixelListKind } else { Dispatch::Grid };
        }
        self
    }
}
