//! Where the lists of pixels lie that a sample's steps name by number.
//!
//! *Idea.* Two lists of a kind are enough, for each is read by the steps that write the next, and not again. The arguments of the
//! dispatches over them (counts of workgroups and pixels) are another matter: passes only ever add to them, so that they must begin
//! at zero, and a clear between two dispatches takes a new pass of the encoder, which costs more than a dispatch over an empty
//! list. So the arguments of each list of each round have a section of their own in a buffer, which is cleared once for a batch of
//! many rounds.

use super::step::{PixelList, Step};
use crate::gpu::{List, Listed, SECTION, Selection};

/// Rounds of a sample whose lists have sections of their own, so that these are cleared once for all of them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Batch {
    pub rounds: u64,
    /// Sections for the lists of active rays of one round.
    pub active: u64,
}

/// Where a list of pixels lies, and where the arguments of dispatches over it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ListSection {
    pub list: List,
    /// The section of the arguments' buffer.
    pub section: u64,
}

impl ListSection {
    /// Of the section, in bytes.
    pub(super) fn offset(self) -> u64 {
        self.section * SECTION
    }
}

impl Batch {
    /// Of a sample that has `rounds` rounds of `steps`.
    pub(super) fn of(steps: &[Step], rounds: u32) -> Self {
        /// A megabyte of them.
        const SECTIONS: u64 = 4096;
        let active = |step: &Step| if let PixelList::Active(n) = step.written { n } else { 0 };
        let active = 1 + steps.iter().map(active).max().unwrap_or(0);
        Self { rounds: (SECTIONS / active).clamp(1, u64::from(rounds)), active }
    }

    /// Sections for lists of open pixels: a batch reads what the one before left, while its own are cleared and written.
    pub(super) fn open(&self) -> u64 {
        2 * self.rounds
    }

    /// Where a list lies in a round.
    pub(super) fn place(&self, list: PixelList, round: u32) -> ListSection {
        let round = u64::from(round);
        match list {
            PixelList::Active(n) => {
                ListSection { list: List::nth(Listed::Active, n), section: round % self.rounds * self.active + n }
            }
            PixelList::Open(n) => {
                let list = List::nth(Listed::Open, round + n);
                ListSection { list, section: (round + n + self.open() - 1) % self.open() }
            }
            PixelList::Wanted(n) => ListSection { list: List::nth(Listed::Wanted, n), section: 0 },
        }
    }

    /// What a step uses in a round.
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
        // Adaptive pictures list what is open.
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
            assert_ne!(read.list, batch.place(last.written, round).list, "what is read is not written");
            // Half of the sections are cleared before a batch, in which these must not lie.
            assert_ne!(round % 3 == 0, read.section / 3 == u64::from(round) / 3 % 2);
            let active =
                ListSection { list: List { of: Listed::Active, side: 1 }, section: u64::from(round) % 3 * 5 + 1 };
            assert_eq!(batch.place(advance.written, round), active);
        }
    }
}
