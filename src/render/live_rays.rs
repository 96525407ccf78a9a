//! Reads, without waiting, how many rays a submission leaves active, so that the host neither records passes without work nor divides the
//! work that is left into needlessly small submissions.
//!
//! The counts arrive a few submissions late, and how late depends on the machine. They only decide where submissions end and which empty
//! dispatches are omitted, so that the image does not depend on them.

use std::sync::mpsc::{Receiver, channel};

use bytemuck::pod_read_unaligned;
use wgpu::{Buffer, BufferAsyncError, BufferDescriptor, BufferUsages, CommandEncoder, MapMode};

use super::batch::ListSection;
use super::step::PixelList;
use crate::gpu::{Gpu, Tile};
use crate::program::constant;

/// The number of steps after which the first submission of a sample ends; each following one may have twice as many.
const FIRST_STEPS: usize = 64;
/// The largest number of steps of a submission.
const MOST_STEPS: usize = 4096;

/// The state of a sample, as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct LiveRays {
    /// An upper bound of the number of pixels with a path left.
    open: u64,
    /// A round, and an upper bound of the number of its active rays.
    active: (u32, u64),
    /// The number of steps after which a submission ends.
    steps: usize,
}

impl LiveRays {
    /// Returns the state of a sample of this many pixels before its first round.
    pub(super) fn all(pixels: u64) -> Self {
        Self { open: pixels, active: (0, pixels), steps: FIRST_STEPS }
    }

    /// Returns an upper bound of the number of rays that are active in a round.
    pub(super) fn in_round(self, round: u32) -> u64 {
        if self.active.0 == round { self.active.1.min(self.open) } else { self.open }
    }

    /// Returns `true` if no pixel has a path left.
    pub(super) fn is_done(self) -> bool {
        self.open == 0
    }

    /// Returns `true` if a submission should end after this many steps.
    pub(super) fn is_full(self, steps: usize) -> bool {
        steps >= self.steps
    }

    /// Lets the next submission be longer.
    pub(super) fn submitted(&mut self) {
        self.steps = (2 * self.steps).min(MOST_STEPS);
    }

    /// Takes a count into account.
    pub(super) fn know(&mut self, list: PixelList, round: u32, count: u64) {
        match list {
            PixelList::Open(_) => self.open = count,
            PixelList::Active(_) if self.active.0 <= round => self.active = (round, count),
            PixelList::Active(_) | PixelList::Wanted(_) => {}
        }
    }
}

/// The number of rays of a list at the end of a submission, on its way to the host.
#[derive(Debug)]
pub(super) struct Count {
    pub list: PixelList,
    pub round: u32,
    buffer: Buffer,
    arrived: Option<Receiver<Result<(), BufferAsyncError>>>,
}

impl Count {
    /// Records the copy of a list's groups, two words at `offset` of its section. Returns `None` if the program does not have the list.
    pub(super) fn record(
        gpu: &Gpu,
        tile: &Tile,
        (list, round): (PixelList, u32),
        (section, offset): (ListSection, u64),
        encoder: &mut CommandEncoder,
    ) -> Option<Self> {
        let arguments = tile.arguments(section.list)?;
        let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
        let descriptor = BufferDescriptor { label: Some("live rays"), size: 8, usage, mapped_at_creation: false };
        let buffer = gpu.device.create_buffer(&descriptor);
        encoder.copy_buffer_to_buffer(arguments, section.offset() + offset, &buffer, 0, 8);
        Some(Self { list, round, buffer, arrived: None })
    }

    /// Requests the groups; call this after the submission.
    pub(super) fn request(&mut self) {
        let (sender, receiver) = channel();
        self.buffer.map_async(MapMode::Read, .., move |result| {
            // The receiver is only gone if the sample has ended.
            let _ = sender.send(result);
        });
        self.arrived = Some(receiver);
    }

    /// Returns an upper bound of the number of rays, which is 0 only if there are none, if it has arrived.
    pub(super) fn take(&self) -> Option<u64> {
        self.arrived.as_ref()?.try_recv().ok()?.ok()?;
        let bytes = self.buffer.get_mapped_range(..).ok()?;
        let [across, down]: [u32; 2] = pod_read_unaligned(&bytes);
        Some(u64::from(across) * u64::from(down) * u64::from(group_pixels()))
    }
}

/// Returns the number of pixels of a group, so that groups can be counted instead of rays: without compaction, rays are not counted.
fn group_pixels() -> u32 {
    constant("state/active", "GROUP") as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn late_counts_of_earlier_rounds_do_not_hide_rays() {
        let mut live = LiveRays::all(100);
        live.know(PixelList::Active(3), 1, 0);
        assert_eq!((live.in_round(1), live.in_round(2)), (0, 100));
        live.know(PixelList::Open(1), 1, 7);
        live.know(PixelList::Active(2), 2, 5);
        live.know(PixelList::Active(9), 1, 0);
        assert_eq!((live.in_round(2), live.in_round(3)), (5, 7));
        assert!(!live.is_done());
        live.know(PixelList::Open(1), 2, 0);
        assert!(live.is_done() && live.in_round(2) == 0);
    }
}
