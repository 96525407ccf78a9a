//! Creates tiles of a program's state, writes their samples and reads their tallies.

use std::time::Instant;

use wgpu::ErrorFilter;

use super::clock::Clock;
use super::prepared::Prepared;
use super::records::Records;
use super::sample::Sample;
use super::{RenderError, Totals, Window};
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
        let sections = self.sections();
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

    /// Returns the sections of a tile.
    pub(super) fn sections(&self) -> Sections {
        Sections { star_images: self.star_room() * self.star_image_bytes(), ..self.plan.sections() }
    }

    /// Returns the number of images of stars for which a tile has room: as many as there are stars, up to a few in each pixel, and the lights
    /// at edges of the sky. If there are more, the tile is rendered again.
    fn star_room(&self) -> u64 {
        if !self.program.features.has_stars {
            return 0;
        }
        let stars = self.scene.stars.iter().flatten().map(|stars| stars.catalog.stars.len() as u64).max().unwrap_or(0);
        let size = self.settings.window.unwrap_or(Window::whole(self.scene.image.size)).size;
        let pixels: u64 = size.map(u64::from).iter().product();
        self.star_images.max((stars + stars / 2).min(2 * pixels) + pixels / 16)
    }

    fn star_image_bytes(&self) -> u64 {
        self.program.layout(&Role::StarImages).map_or(0, |layout| layout.span.into())
    }

    /// Makes room for this number of images of stars. If the device does not allow such a list, tiles become smaller.
    fn make_star_room(&mut self, tile: &Tile, images: u64) {
        let limits = &self.gpu.limits;
        let allowed = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size) / self.star_image_bytes();
        let wanted = images.max(self.star_room()) / 4 * 5;
        if wanted > allowed {
            self.settings.tile_pixels = tile.pixels() / 2;
        }
        self.star_images = wanted.min(allowed);
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
                self.make_star_room(tile, counts.uint("listed").into());
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
