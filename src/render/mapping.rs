//! Traces the paths of an image once, and shades it again without following them.
//!
//! *Idea.* Shading a path needs its end, and nothing else of it: position, velocity, the surface, and the fraction of light that arrives.
//! A map has these for every path, so that images with other skies, colors or exposures take the time of shading alone, and have the
//! bits of a new render.

use rayon::prelude::*;

use super::band::{Band, Bands};
use super::clock::Clock;
use super::lens_map::{END_VALUES, LensMap, MapRound};
use super::records::Records;
use super::sample::Sample;
use super::tile::TileEnd;
use super::watch::Round;
use super::{RenderError, Renderer, Totals, Window};
use crate::gpu::Tile;
use crate::program::{Features, Role};

impl Renderer<'_> {
    /// Follows the paths of the whole image, and returns their ends, the layers of the settings, and the totals. The settings must have
    /// [`PathEnds::Stored`](crate::program::PathEnds::Stored).
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::Gpu`] if the device fails, or if `memory` of the settings is too small for any tile.
    pub fn map(&mut self) -> Result<(LensMap, Band, Totals), RenderError> {
        let started = std::time::Instant::now();
        let size = self.prepared.scene.image.size;
        let mut map = LensMap { size, rounds: Vec::new() };
        let mut clock = Clock::new(self.prepared.gpu, self.prepared.settings.apart);
        let (mut totals, mut layers) = (Totals::default(), Bands::default());
        let stage = self.prepared.gpu.progress.measured("tracing the map", f64::from(size[1]));
        let [width, height] = self.tile_size()?;
        let margin = self.prepared.program.features.margin().total();
        for top in (0..size[1]).step_by(height as usize) {
            let rows = height.min(size[1] - top);
            let mut band = self.band(top, rows);
            for left in (0..size[0]).step_by(width as usize) {
                let part = Window { origin: [left, top], size: [width.min(size[0] - left), rows] };
                let mut ended = TileEnd::Again;
                while ended == TileEnd::Again {
                    let tile = self.prepared.tile_after(self.tile.take(), part.size.map(|side| side + margin))?;
                    self.map_tile(&tile, part, &mut clock, &mut map)?;
                    ended = self.prepared.read_tally(&tile, &mut totals, None)?;
                    let wanted = &self.prepared.settings.options.layers;
                    self.read_values(&tile)?.put(left, &Round::new(None, 1, true, wanted), &mut band, None);
                    self.tile = Some(tile);
                }
            }
            (layers.sink())(band)?;
            stage.reach(f64::from(top + rows));
        }
        map.shorten();
        self.prepared.finish_totals(&mut totals, &clock, started)?;
        Ok((map, layers.whole.unwrap_or_else(|| self.band(0, 0)), totals))
    }

    fn map_tile(&self, tile: &Tile, part: Window, clock: &mut Clock, map: &mut LensMap) -> Result<(), RenderError> {
        let prepared = &self.prepared;
        let image = prepared.scene.image.size;
        let before = prepared.program.features.margin().before;
        let first = Sample { origin: part.origin, ..Sample::first(image) }.before(before);
        prepared.run_sample(tile, first.grid(), clock, &|_| {})?;
        for number in 0..prepared.scene.image.samples {
            let sample = Sample { number, ..first };
            for round in 0..prepared.program.features.rounds {
                prepared.run_round(tile, sample, round, clock)?;
                let records = Records::take(prepared.gpu, &prepared.program, tile, &Role::PathEnds)?;
                let ends: &[u32] = bytemuck::cast_slice(records.bytes());
                if !has_ends(ends, tile.pixels()) {
                    break;
                }
                put_ends(ends, (tile.size, before), part, image[0], map.round(number, round));
            }
        }
        Ok(())
    }

    /// Shades a tile from the ends of a map.
    pub(super) fn shade_tile(
        &self,
        tile: &Tile,
        part: Window,
        clock: &mut Clock,
        map: &LensMap,
    ) -> Result<(), RenderError> {
        let prepared = &self.prepared;
        let image = prepared.scene.image.size;
        let [width, height] = part.size.map(|side| side as usize);
        let [left, top] = part.origin.map(|at| at as usize);
        let stride = image[0] as usize;
        let mut cut: Vec<u32> = Vec::new();
        // A new buffer contains zeros, and other values are written in every round.
        let is_stored = |value: usize| map.rounds.iter().any(|round| !round.planes[value].is_empty());
        let is_needed =
            |value: &usize| is_stored(*value) && is_read(END_VALUES[*value].channel, &prepared.program.features);
        let needed: Vec<usize> = (0..END_VALUES.len()).filter(is_needed).collect();
        for round in &map.rounds {
            for &value in &needed {
                let plane = &round.planes[value];
                cut.clear();
                let bits = match plane.get(top * stride..(top + height) * stride) {
                    Some(bits) if width == stride => bits,
                    Some(bits) => {
                        bits.chunks_exact(stride).for_each(|row| cut.extend(&row[left..left + width]));
                        &cut
                    }
                    // The values are 0.
                    None => {
                        cut.resize(width * height, 0);
                        &cut
                    }
                };
                let offset = size_of::<u32>() * value * width * height;
                tile.write(prepared.gpu, &Role::PathEnds, offset as u64, bytemuck::cast_slice(bits));
            }
            let sample = Sample {
                origin: part.origin,
                image,
                number: round.sample,
                is_grid: false,
                ends_only: false,
                refines: None,
            };
            prepared.run_round(tile, sample, round.branch, clock)?;
        }
        Ok(())
    }
}

/// Returns `true` if shading may read a value.
fn is_read(channel: &str, features: &Features) -> bool {
    match channel.split('.').next() {
        Some("across" | "down") => features.keeps_footprints,
        Some("stretch") => features.follows_shift,
        Some("uv") => false,
        _ => channel != "id.shared_end" || features.keeps_footprints,
    }
}

/// Copies the ends of a tile, with its size and the margin before its pixels, into the planes of an image of this width.
fn put_ends(ends: &[u32], (tile, before): ([u32; 2], u32), part: Window, image_width: u32, round: &mut MapRound) {
    let [left, top] = part.origin.map(|at| at as usize);
    let [width, height] = part.size.map(|side| side as usize);
    let ([stride, tile_rows], before) = (tile.map(|side| side as usize), before as usize);
    round.planes.par_iter_mut().zip(ends.par_chunks_exact(stride * tile_rows)).for_each(|(plane, own)| {
        let rows = plane.chunks_exact_mut(image_width as usize).skip(top).take(height);
        rows.zip(own.chunks_exact(stride).skip(before))
            .for_each(|(row, own)| row[left..left + width].copy_from_slice(&own[before..before + width]));
    });
}

/// Returns `true` if any pixel has a path.
fn has_ends(ends: &[u32], pixels: u64) -> bool {
    ends[..pixels as usize].iter().any(|status| *status != 0)
}
