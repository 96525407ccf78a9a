//! One dispatch as data, before it is recorded.
//!
//! *Idea.* Rays end at very different times, and a pass over all of them would mostly find ended ones. So the active rays are
//! compacted: a pass adds the pixels whose rays go on to a list, and the next runs over no more than that list, by indirect
//! dispatch. All of a sample is recorded before any of it runs, so that a step names the lists that it reads and writes by number:
//! the n-th list of active rays in a round is written by the steps that read the one before.

use std::fmt;

use super::sample::Refines;
use crate::gpu::Slots;
use crate::program::{Masks, Pass};

/// What a pass runs over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dispatch {
    /// Every pixel of the tile.
    Grid,
    /// The pixels of the list that the step reads, by indirect dispatch.
    Listed,
    /// Every pixel in the first round of a sample, in later ones those of the list.
    ListedLater,
}

/// A list of pixels, by its number among those of its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PixelList {
    /// Of the active rays, counted in each round.
    Active(u64),
    /// Of the pixels that have a path left: 0 is what a round works on, and 1 what it leaves to the next.
    Open(u64),
    /// Of the pixels that want more samples, counted in each tile.
    Wanted(u64),
}

/// One dispatch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Which pass.
    pub pass: Pass,
    /// Which slots of the state it uses.
    pub slots: Slots,
    /// The list that it runs over, where it does not run over all pixels.
    pub read: PixelList,
    /// The list that it adds to, if its pass adds to any.
    pub written: PixelList,
    /// Over what.
    pub dispatch: Dispatch,
    /// The iteration of the loop over segments that it belongs to.
    pub iteration: u64,
    /// Does it go on with a walk that was suspended?
    pub again: bool,
    /// Is it of the first segments, which run over the same pixels as the setup?
    pub first: bool,
    /// Integration steps of one ray in it, at most: its weight when the work is split into submissions.
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
    /// The pass, what it runs over, and the slots and the list that it writes.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Slots { input, output, .. } = self.slots;
        let over = match self.dispatch {
            Dispatch::Grid => "all pixels".to_owned(),
            Dispatch::Listed => format!("list {}", self.read),
            Dispatch::ListedLater => format!("all pixels, in later rounds list {}", self.read),
        };
        let again = if self.again { ", goes on with suspended walks" } else { "" };
        write!(
            f,
            "{:<11} over {over}; state {input} -> {output}; adds to list {}{again}",
            self.pass.entry(),
            self.written
        )
    }
}

impl Step {
    /// What follows a sample of an adaptive picture.
    pub(super) fn refining(refines: Refines, masks: Masks) -> Self {
        let dispatch = if refines.listed && masks != Masks::Off { Dispatch::Listed } else { Dispatch::Grid };
        let (read, written) = (PixelList::Wanted(refines.list), PixelList::Wanted(refines.list + 1));
        let slots = Slots::only(0);
        Self { pass: Pass::Refine, slots, read, written, dispatch, iteration: 0, again: false, first: false, weight: 1 }
    }

    /// In a sample's round: over the pixels that take the sample, if these are listed.
    pub(super) fn in_round(mut self, round: u32, refines: Option<Refines>) -> Self {
        if let (0, Dispatch::ListedLater, Some(Refines { listed, list })) = (round, self.dispatch, refines) {
            self.read = PixelList::Wanted(list);
            self.dispatch = if listed { Dispatch::Listed } else { Dispatch::Grid };
        }
        self
    }
}
