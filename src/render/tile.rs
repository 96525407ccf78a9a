//! Creates tiles of a program's state, writes their samples and reads their tallies.

use std::time::Instant;

use wgpu::ErrorFilter;

use super::clock::Clock;
use super::prepared::Prepared;
use super::records::Records;
use super::sample::Sample;
use super::{RenderError, Totals};
use crate::gpu::{GpuError, SECTION, Sections, Tile, pack};
use crate::program::Role;

/// The outcome of a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TileEnd {
    Done,
    /// Rays were still active after the last pass. There are more passes now, and the tile must be rendered again.
    Again,
}

impl Prepared<'_> {
    /// Creates a tile of this program's state.
    pub(super) fn tile(&self, size: [u32; 2]) -> Result<Tile, GpuError> {
        self.tile_after(None, size)
    }

    /// Returns a tile of this program's state: an earlier one of the same program, if it is like it, or a new one.
    pub(super) fn tile_after(&self, earlier: Option<Tile>, size: [u32; 2]) -> Result<Tile, GpuError> {
        let sections = Sections { star_cells: self.star_cells, ..self.plan.sections() };
        let tile = match earlier.filter(|earlier| earlier.is_like(size, &sections)) {
            Some(tile) => tile,
            None => self.new_tile(size, &sections)?,
        };
        if let Some(layout) = self.program.layout(&Role::Parameters) {
            for (i, parameters) in self.plan.parameters.iter().enumerate() {
                let bytes = pack("dispatch parameters", layout, [parameters.row()])?;
                tile.write(self.gpu, &Role::Parameters, i as u64 * SECTION, &bytes);
            }
        }
        Ok(tile)
    }

    fn new_tile(&self, size: [u32; 2], sections: &Sections) -> Result<Tile, GpuError> {
        let scope = self.gpu.device.push_error_scope(ErrorFilter::OutOfMemory);
        let tile = Tile::new(self.gpu, &self.program, size, sections)?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            let what = format!("a tile of {}×{} pixels", size[0], size[1]);
            return Err(GpuError::Full { what, reason: error.to_string() });
        }
        Ok(tile)
    }

    /// Writes a sample's frame into a section of the tile's buffer.
    pub(super) fn write_sample(&self, tile: &Tile, sample: Sample, round: u32, section: u64) -> Result<(), GpuError> {
        let Some(layout) = self.program.layout(&Role::Frame) else { return Ok(()) };
        let bytes = pack("frame", layout, [sample.row(tile.size, round)])?;
        tile.write(self.gpu, &Role::Frame, section * SECTION, &bytes);
        Ok(())
    }

    /// Adds the tile's tally to `totals`, and clears it. Returns `true` if rays are still active.
    ///
    /// `rays` is the number of rays, if known beforehand. A device that stops an invocation because of its loop limit does not report it,
    /// and the rays that a pass of whole paths then omitted are only missing from the count.
    pub(super) fn add_tally(&self, tile: &Tile, totals: &mut Totals, rays: Option<u64>) -> Result<bool, GpuError> {
        let records = Records::take(self.gpu, &self.program, tile, &Role::Tally)?;
        let Some(tally) = records.rows().next() else { return Ok(false) };
        totals.add_tally(&tally);
        let missing = self.is_whole() && rays.is_some_and(|rays| Totals::counted(&tally) < rays);
        Ok(missing || Totals::unfinished(&tally) > 0)
    }

    /// Adds the tally like [`add_tally`](Self::add_tally), unless rays are still active and more passes are possible.
    pub(super) fn read_tally(
        &mut self,
        tile: &Tile,
        totals: &mut Totals,
        rays: Option<u64>,
    ) -> Result<TileEnd, RenderError> {
        let before = totals.clone();
        if self.program.features.has_stars {
            let records = Records::take(self.gpu, &self.program, tile, &Role::StarCounts)?;
            let Some(counts) = records.rows().next() else { return Ok(TileEnd::Done) };
            if counts.uint("lost") > 0 {
                self.star_cells = 1;
                Records::take(self.gpu, &self.program, tile, &Role::Tally)?;
                return Ok(TileEnd::Again);
            }
            totals.stars.get_or_insert_default().add(&counts);
        }
        if self.add_tally(tile, totals, rays)? && self.make_room()? {
            *totals = before;
            return Ok(TileEnd::Again);
        }
        Ok(TileEnd::Done)
    }

    /// Adds the time of the device and the host.
    pub(super) fn finish_totals(&self, totals: &mut Totals, clock: &Clock, started: Instant) -> Result<(), GpuError> {
        totals.device = clock.read(self.gpu)?;
        totals.wall = started.elapsed();
        Ok(())
    }
}
