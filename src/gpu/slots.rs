//! Which of several alike resources a dispatch uses: slots of the state, and lists of pixels.
//!
//! *Idea.* A pass cannot read what it writes, so the state lies in two slots or three, and every list of pixels twice: one
//! dispatch reads the one and writes the other, and the next swaps them.

use crate::program::{Access, Slot};

/// The slots of the state that a dispatch uses, each for one of the roles that shaders know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Slots {
    /// What it reads.
    pub input: usize,
    /// What it writes.
    pub output: usize,
    /// Where the segment began.
    pub start: usize,
    /// Where it ends.
    pub end: usize,
}

impl Slots {
    /// One slot in every role, for passes that stay where they are.
    #[must_use]
    pub fn only(slot: usize) -> Self {
        Self::segment(slot, slot)
    }

    /// A whole segment, from its start to its end.
    #[must_use]
    pub fn segment(start: usize, end: usize) -> Self {
        Self { input: start, output: end, start, end }
    }

    /// One step of a segment that began in `start`.
    #[must_use]
    pub fn step(start: usize, input: usize, output: usize) -> Self {
        Self { input, output, start, end: output }
    }

    /// The number of the slot in this role.
    pub(super) fn number(self, slot: Slot) -> usize {
        match slot {
            Slot::Input => self.input,
            Slot::Output => self.output,
            Slot::Start => self.start,
            Slot::End => self.end,
            Slot::Fixed(number) => number,
        }
    }
}

/// What the pixels of a list have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Listed {
    /// Their rays are active: under way, or about to scatter.
    Active,
    /// They have a path left to follow, where surfaces split rays.
    Open,
    /// They want more samples, in adaptive pictures.
    Wanted,
}

/// One of the two lists of a kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct List {
    /// Of which pixels.
    pub of: Listed,
    /// Which of the two.
    pub side: usize,
}

impl List {
    /// The list that is `n`-th when the two take turns.
    #[must_use]
    pub fn nth(of: Listed, n: u64) -> Self {
        Self { of, side: (n % 2) as usize }
    }

    /// Both of a kind.
    #[must_use]
    pub fn both(of: Listed) -> [Self; 2] {
        [0, 1].map(|side| Self { of, side })
    }

    /// Its place among all lists.
    pub(super) fn number(self) -> usize {
        2 * self.of as usize + self.side
    }
}

/// What a dispatch's bind group is made for, besides its pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Selection {
    /// Of the state.
    pub slots: Slots,
    /// The list that it runs over.
    pub read: List,
    /// The list that it adds to.
    pub written: List,
}

impl Selection {
    pub(super) fn list(self, access: Access) -> List {
        match access {
            Access::Read => self.read,
            Access::Write => self.written,
        }
    }
}

/// Bytes from one section of a buffer to the next: any device's alignment.
pub const SECTION: u64 = 256;

/// How many sections the buffers have of which each dispatch sees one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sections {
    /// Dispatch parameters.
    pub parameters: u64,
    /// The arguments over each list of active rays.
    pub active: u64,
    /// The arguments over each list of open pixels.
    pub open: u64,
}

impl Sections {
    /// Of the arguments over a list.
    #[must_use]
    pub fn of(&self, list: Listed) -> u64 {
        match list {
            Listed::Active => self.active,
            Listed::Open => self.open,
            Listed::Wanted => 1,
        }
    }

    /// Of all buffers together, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let lists = [Listed::Active, Listed::Open, Listed::Wanted].map(|list| 2 * self.of(list));
        SECTION * (self.parameters + lists.iter().sum::<u64>())
    }
}
