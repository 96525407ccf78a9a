//! Selects the resources that a dispatch uses: slots of the state, and lists of pixels.
//!
//! *Idea.* A pass cannot read the resource that it writes. Therefore the state has two or three slots, and every list of pixels has two
//! copies: one dispatch reads the first and writes the second, and the next dispatch swaps them.

use crate::program::{Access, Slot};

/// The slots of the state that a dispatch uses, one for each role in the shaders.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Slots {
    /// The slot that it reads.
    pub input: usize,
    /// The slot that it writes.
    pub output: usize,
    /// The slot with the start of the segment.
    pub start: usize,
    /// The slot with the end of the segment.
    pub end: usize,
}

impl Slots {
    /// Returns one slot in every role, for passes that do not move rays.
    #[must_use]
    pub fn only(slot: usize) -> Self {
        Self::segment(slot, slot)
    }

    /// Returns the slots of a whole segment, from its start to its end.
    #[must_use]
    pub fn segment(start: usize, end: usize) -> Self {
        Self { input: start, output: end, start, end }
    }

    /// Returns the slots of one step of a segment that began in `start`.
    #[must_use]
    pub fn step(start: usize, input: usize, output: usize) -> Self {
        Self { input, output, start, end: output }
    }

    /// Returns the number of the slot in this role.
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

/// The property that the pixels of a list share.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PixelListKind {
    /// Their rays are active: they are traveling, or about to scatter.
    Active,
    /// They have an unfinished path, if surfaces split rays.
    Open,
    /// They need more samples, in images with adaptive sampling.
    Wanted,
}

/// One of the two lists of a kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct List {
    /// The kind of its pixels.
    pub of: PixelListKind,
    /// The index of the list: 0 or 1.
    pub side: usize,
}

impl List {
    /// Returns the `n`-th list, if the two alternate.
    #[must_use]
    pub fn nth(of: PixelListKind, n: u64) -> Self {
        Self { of, side: (n % 2) as usize }
    }

    /// Returns both lists of a kind.
    #[must_use]
    pub fn both(of: PixelListKind) -> [Self; 2] {
        [0, 1].map(|side| Self { of, side })
    }

    /// Returns the index of the list among all lists.
    pub(super) fn number(self) -> usize {
        2 * self.of as usize + self.side
    }
}

/// The selection that, together with a pass, determines a bind group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Selection {
    /// The slots of the state.
    pub slots: Slots,
    /// The list that the dispatch processes.
    pub read: List,
    /// The list that the dispatch appends to.
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

/// The distance between sections of a buffer, in bytes; it meets the alignment of any device.
pub const SECTION: u64 = 256;
/// The number of sections for the frames of samples in flight.
pub const FRAMES: u64 = 64;

/// The size of the arguments of a dispatch before its list, in bytes.
pub const WORK_HEAD: u64 = 16;

/// The numbers of sections of the buffers of which each dispatch sees one section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sections {
    /// The number of dispatch parameters.
    pub parameters: u64,
    /// The number of arguments for each list of active rays.
    pub active: u64,
    /// The number of arguments for each list of open pixels.
    pub open: u64,
    /// The size of the list of images of stars, in bytes.
    pub star_images: u64,
}

impl Sections {
    /// Returns the number of arguments for a list.
    #[must_use]
    pub fn of(&self, list: PixelListKind) -> u64 {
        match list {
            PixelListKind::Active => self.active,
            PixelListKind::Open => self.open,
            PixelListKind::Wanted => 1,
        }
    }

    /// Returns the size of all buffers together, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let lists = [PixelListKind::Active, PixelListKind::Open, PixelListKind::Wanted].map(|list| 2 * self.of(list));
        SECTION * (FRAMES + self.parameters + lists.iter().sum::<u64>()) + self.star_images
    }
}
