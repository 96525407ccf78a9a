//! Assigns the lists of pixels that a sample's steps number to buffers and sections.
//!
//! *Idea.* Two lists of a kind suffice, because each is read only by the steps that write the next one. The arguments of the dispatches
//! over them (counts of workgroups and pixels) need more: passes only add to them, so that they must begin at zero, and clearing them
//! between two dispatches requires a new encoder pass, which costs more than a dispatch over an empty list. Therefore the arguments of each
//! list of each round have a section in a buffer, which is cleared once for a batch of many rounds.

use super::step::{PixelList, Step};
use crate::gpu::{List, PixelListKind, SECTION, Selection};

/// The rounds of a sample whose lists have separate sections, so that these are cleared once for all of them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Batch {
    pub rounds: u64,
    /// The number of sections for the lists of active rays of one round.
    pub active: u64,
}

/// The location of a list of pixels, and of the arguments of dispatches over it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ListSection {
    pub list: List,
    /// The section of the arguments' buffer.
    pub section: u64,
}

impl ListSection {
    /// Returns the offset of the section, in bytes.
    pub(super) fn offset(self) -> u64 {
        self.section * SECTION
    }
}

impl Batch {
    /// Returns the batches of a sample that has `rounds` rounds of `steps`.
    pub(super) fn of(steps: &[Step], rounds: u32) -> Self {
        /// One megabyte of arguments.
        const SECTIONS: u64 = 4096;
        let active = |step: &Step| if let PixelList::Active(n) = step.written { n } else { 0 };
        let active = 1 + steps.iter().map(active).max().unwrap_or(0);
        Self { rounds: (SECTIONS / active).clamp(1, u64::from(rounds)), active }
    }

    /// Returns the number of sections for lists of open pixels, for two batches: one is read while the other is cleared and written.
    pub(super) fn open(&self) -> u64 {
        2 * self.rounds
    }

    /// Returns the location of a list in a round.
    pub(super) fn place(&self, list: PixelList, round: u32) -> ListSection {
        let round = u64::from(round);
        match list {
            PixelList::Active(n) => ListSection {
                list: List::nth(PixelListKind::Active, n),
                section: round % self.rounds * self.active + n,
            },
            PixelList::Open(n) => {
                let list = List::nth(PixelListKind::Open, round + n);
                ListSection { list, section: (round + n + self.open() - 1) % self.open() }
            }
            PixelList::Wanted(n) => ListSection { list: List::nth(PixelListKind::Wanted, n), section: 0 },
        }
    }

    /// Returns the resources that a step uses in a round.
    pub(super) fn selection(&self, step: &Step, round: u32) -> Selection {
        let [read, written] = [step.read, step.written].map(|list| self.place(list, round).list);
        Selection { slots: step.slots, read, written }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Schedule;
    use crate::render::schedule::tests::recorded;

    #[test]
    fn a_round_reads_what_the_one_before_left_open() {
        // Adaptive images list open pixels.
        let steps = recorded(Schedule::Fused, "", "adaptive = 0.05");
        let [Some(setup), Some(advance), Some(last)] = [steps.first(), steps.get(1), steps.last()] else {
            panic!("no steps")
        };
        let batch = Batch { rounds: 3, active: 5 };
        for round in 1..20 {
            let read = batch.place(setup.read, round);
            assert_eq!(read, batch.place(last.written, round - 1));
            assert_eq!(read, batch.place(last.read, round));
            assert_eq!(read, batch.place(advance.read, round));
            assert_ne!(read.list, batch.place(last.written, round).list, "a list is read and written");
            // Half of the sections are cleared before a batch; the list that is read must not be among them.
            assert_ne!(round % 3 == 0, read.section / 3 == u64::from(round) / 3 % 2);
            let active = ListSection {
                list: List { of: PixelListKind::Active, side: 1 },
                section: u64::from(round) % 3 * 5 + 1,
            };
            assert_eq!(batch.place(advance.written, round), active);
        }
    }
}
