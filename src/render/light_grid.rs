//! Creates photon grids (G95 §6) before an image whose lights require them or whose paths they guide.
//!
//! *Theory.* Paths leave a light evenly in all directions, follow the scene's law through transparent objects until they end, and add their
//! light to the voxels that they cross. More paths then do so in the subvoxels of those voxels whose light differs from a neighbor's.
//!
//! *Practice.* The paths are ordinary rays of a program for this purpose; only the sums that they leave are read back, batch by batch. Sums
//! are integers, so that a grid is bit-identical in whatever order its paths run.
//!
//! *Length.* Over 300 lines, because a grid is created in one run: its volume, its paths, its bricks.

use std::borrow::Cow;
use std::cell::Cell;
use std::time::Instant;

use glam::Vec4;
use rayon::prelude::*;

use super::clock::Clock;
use super::grids::{GridSource, LightGrids, LightReport};
use super::prepared::Prepared;
use super::ray_tiles::{BATCH, ray_tile};
use super::readback::read_buffer;
use super::tile::TileEnd;
use super::{RenderError, RenderSettings, Totals};
use crate::gpu::{Aim, Emission, Gpu, LightGridData, LightVolume, Tile, light_bytes, pack};
use crate::program::{Mode, ProgramOptions, RaySkipping, Role, Schedule, constant};
use crate::progress::Stage;
use crate::scene::{LightGrid, Scene, Shadows};

/// The minimum and maximum number of pilot paths, which find the directions for the others; between them, half as many as other paths.
const PILOTS: [u32; 2] = [1 << 16, 1 << 18];
/// The factor by which refined voxels increase the number of paths.
const FOR_PARTS: u32 = 4;
/// The same factor for path guiding. A factor of 4 reduces the noise of the scenes in `scenes/paths/` by at most 1 %, and takes up to 1.8
/// times as long.
const FOR_GUIDING_PARTS: u32 = 2;
/// The isotropic fluence that path guiding adds for the uncertainty of directions, as a fraction of the fluence of one path.
const DOUBT: f64 = 0.03;
/// The divisor of the remaining device memory that gives the share of bricks.
const FOR_BRICKS: u64 = 2;
/// The maximum number of subvoxels of all guiding grids together.
const GUIDE_PARTS: u64 = 1 << 19;

/// Creates the grids that an image of the scene needs: for its lights, or for the emitters that guide its paths.
pub(super) fn grids_of(gpu: &Gpu, scene: &Scene, settings: &RenderSettings) -> Result<LightGrids, RenderError> {
    let made = if scene.has_shadows(Shadows::Grid) {
        light_grids(gpu, scene, settings)?
    } else {
        guide(gpu, scene, settings)?
    };
    let (fields, reports): (Vec<_>, _) = made.into_iter().unzip();
    Ok(LightGrids { fields: fields.into(), reports, is_outdated: false })
}

/// Creates the grids of a scene's lights that have one, in the order of the file.
///
/// # Errors
///
/// Returns [`RenderError::LightGrid`] if the grids exceed `settings.memory`, [`RenderError::LightLost`] if a voxel cannot count its paths,
/// and another error if a program cannot be compiled or the device fails.
pub fn light_grids(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
) -> Result<Vec<(LightGridData, LightReport)>, RenderError> {
    let lights = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows == Shadows::Grid);
    let wanted: Vec<_> = lights
        .map(|(i, light)| Wanted {
            of: GridSource::Light(i),
            emission: Emission::new(scene, light),
            grid: light.grid,
            narrows: true,
        })
        .collect();
    fields(gpu, scene.clone(), settings, (Mode::Light, &wanted))
}

/// Creates the grids of the light that guides a scene's paths.
fn guide(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
) -> Result<Vec<(LightGridData, LightReport)>, RenderError> {
    let beams = scene.beams();
    let bends = beams.iter().any(|beam| beam.through.is_none());
    let mode = if bends { Mode::Light } else { Mode::Caustics };
    let wanted: Vec<_> = beams
        .iter()
        .map(|beam| Wanted {
            of: GridSource::Beam(beam.emitter.object, beam.through),
            emission: Emission::of_lamp(scene, beam),
            grid: scene.guide_grid(),
            narrows: bends,
        })
        .collect();
    fields(gpu, scene.of_beams(), settings, (mode, &wanted))
}

/// A grid to create.
struct Wanted {
    of: GridSource,
    emission: Emission,
    grid: LightGrid,
    /// `true` if pilot paths first find the directions that lead from the light to the region of interest.
    narrows: bool,
}

impl Wanted {
    fn guides(&self) -> bool {
        matches!(self.of, GridSource::Beam(..))
    }
}

/// Follows light through a scene.
fn fields(
    gpu: &Gpu,
    mut followed: Scene,
    settings: &RenderSettings,
    (mode, wanted): (Mode, &[Wanted]),
) -> Result<Vec<(LightGridData, LightReport)>, RenderError> {
    if wanted.is_empty() {
        return Ok(Vec::new());
    }
    let volumes: Vec<_> = wanted.iter().map(|light| LightVolume::new(&followed, light.grid.voxels)).collect();
    let all: u64 = volumes.iter().map(|volume| light_bytes(volume.voxels() as u64)).sum();
    let guides = wanted.iter().any(Wanted::guides);
    if all > settings.memory && !guides {
        let voxels = volumes.iter().map(LightVolume::voxels).sum();
        return Err(RenderError::LightGrid { voxels, needed: all, allowed: settings.memory });
    }
    let options =
        ProgramOptions { mode, schedule: Schedule::Fused, masks: RaySkipping::List, ..ProgramOptions::default() };
    // A leap does not record the voxels that it passes.
    if std::mem::take(&mut followed.rays.leaps) && !guides {
        followed.rays.max_segments = followed.rays.max_segments.max(ARCS);
    }
    let own = RenderSettings { options, window: None, ..settings.clone() };
    let prepared = Prepared::new(gpu, Cow::Borrowed(&followed), own, LightGrids::default())?;
    let mut maker = Maker { prepared };
    // Each light gets an equal share of the memory for bricks, and of a buffer.
    let limit = gpu.limits.max_storage_buffer_binding_size.min(gpu.limits.max_buffer_size);
    let coarse: u64 = volumes.iter().map(|volume| volume.voxels() as u64).sum();
    let part = size_of::<Vec4>() as u64;
    // Guiding grids do not depend on the available memory, so that an image does not change with it.
    let room = if guides { GUIDE_PARTS } else { (settings.memory - all) / FOR_BRICKS / light_bytes(1) };
    let room = room.min((limit / part).saturating_sub(coarse)) / wanted.len() as u64;
    let stage = gpu.progress.counted(if guides { "path guiding grid" } else { "photon grid" }, wanted.len());
    let make = |(i, (light, volume))| {
        let made = maker.make(light, volume, room);
        stage.reach((i + 1) as f64);
        made
    };
    wanted.iter().zip(volumes).enumerate().map(make).collect()
}

/// The maximum number of arcs of one path, if the camera's paths take leaps.
const ARCS: u32 = 1 << 12;

struct Maker<'a> {
    prepared: Prepared<'a>,
}

impl Maker<'_> {
    /// Creates the grid of a light, with at most `room` subvoxels in bricks.
    fn make(
        &mut self,
        wanted: &Wanted,
        volume: LightVolume,
        room: u64,
    ) -> Result<(LightGridData, LightReport), RenderError> {
        let (started, mut totals, mut clock) =
            (Instant::now(), Totals::default(), Clock::new(self.prepared.gpu, false));
        let guides = wanted.guides();
        let Wanted { of, emission, grid: LightGrid { refine, paths, .. }, narrows } = *wanted;
        let for_parts = if guides { FOR_GUIDING_PARTS } else { FOR_PARTS };
        let unit = constant("segment/leave_light", "LIGHT_UNIT");
        let pilots = (paths / 2).clamp(PILOTS[0], PILOTS[1]);
        let all = f64::from(paths) * f64::from(if refine > 1 { 1 + for_parts } else { 1 });
        let pilots_in_all = f64::from(u32::from(narrows) * pilots) * if refine > 1 { 2.0 } else { 1.0 };
        let stage = self.prepared.gpu.progress.part("", all + pilots_in_all, 1.0);
        let mut shine = |aim: &Aim, refine: u32, bricks: &[u32], count: usize| {
            self.shine(&emission, aim, (&volume, refine, bricks), count, (&mut totals, &mut clock, &stage))
        };
        let mut bricks = vec![0; volume.voxels()];
        let mut aim = Aim::everywhere(if narrows { pilots } else { paths });
        if narrows {
            aim = aim.narrowed(shine(&aim, 1, &bricks, volume.voxels())?.reaches.into_iter(), paths);
        }
        let flux = emission.flux() * aim.share();
        let sums = shine(&aim, 1, &bricks, volume.voxels())?.sums;
        let mut made = LightGridData::new(volume, refine, &LightGridData::values(&sums, flux, volume.h, unit));
        let parts = refine.pow(3) as usize;
        let mut cut = if refine > 1 { made.worth_cutting(flux / f64::from(FOR_PARTS)) } else { Vec::new() };
        let worth = cut.len();
        cut.truncate((room / parts as u64) as usize);
        if !cut.is_empty() {
            for (number, voxel) in (1..).zip(&cut) {
                bricks[*voxel as usize] = number;
            }
            let count = cut.len() * parts;
            let paths = paths.saturating_mul(for_parts);
            let mut aim = aim.again(if narrows { pilots } else { paths });
            if narrows {
                aim = aim.narrowed(shine(&aim, refine, &bricks, count)?.reaches.into_iter(), paths);
            }
            let sums = shine(&aim, refine, &bricks, count)?.sums;
            let flux = emission.flux() * aim.share();
            made.cut(bricks, &LightGridData::values(&sums, flux, volume.h / f64::from(refine), unit));
        }
        if guides {
            let part = made.volume.h / f64::from(refine);
            let [voxel, part] =
                [(flux, made.volume.h), (flux / f64::from(FOR_PARTS), part)].map(|(f, h)| DOUBT * f / (h * h));
            made = made.guiding(voxel as f32, part as f32);
        }
        self.prepared.finish_totals(&mut totals, &clock, started)?;
        if let (GridSource::Light(light), true) = (of, totals.lost > 0) {
            return Err(RenderError::LightLost { light });
        }
        let (count, bytes, wall) = (volume.count, made.bytes(), started.elapsed());
        let refined = [cut.len(), worth];
        Ok((made, LightReport { of, count, refined, bytes, totals, wall }))
    }

    /// Returns the light that all paths together leave in `count` voxels or subvoxels.
    fn shine(
        &mut self,
        emission: &Emission,
        aim: &Aim,
        (volume, refine, bricks): (&LightVolume, u32, &[u32]),
        count: usize,
        (totals, clock, stage): (&mut Totals, &mut Clock, &Stage),
    ) -> Result<Shone, RenderError> {
        let gpu = self.prepared.gpu;
        let mut shone = Shone { sums: vec![[0.0; 4]; count], reaches: Vec::with_capacity(aim.paths() as usize) };
        let layout = self.prepared.layout(&Role::LightVolume)?;
        let row = pack("light_volume", layout, [volume.row(refine)])?;
        let mut first = 0;
        while first < aim.paths() {
            let batch = first..aim.paths().min(first + BATCH as u32);
            let rays: Vec<[f64; 6]> = batch.clone().into_par_iter().map(|k| emission.path(k, aim.point(k))).collect();
            let (mut tile, mut sample) = ray_tile(&self.prepared, None, &rays)?;
            // The random numbers of a path depend on its index in its batch, and on this number.
            sample.number = first / BATCH as u32;
            tile.add_input(gpu, &Role::LightVolume, &row)?;
            tile.add_input(gpu, &Role::VolumeBricks, bytemuck::cast_slice(bricks))?;
            tile.add_storage(gpu, &Role::LightSums, (count * 4 * size_of::<u32>()) as u64)?;
            tile.add_storage(gpu, &Role::LightReaches, tile.size.map(u64::from).iter().product::<u64>() * 4)?;
            let paths = rays.len() as f64;
            let told = Cell::new(0.0);
            let progress = |done: f64| stage.advance((done - told.replace(done)) * paths);
            self.prepared.run_sample(&tile, sample, clock, &progress)?;
            if self.prepared.read_tally(&tile, totals, None)? == TileEnd::Again {
                stage.advance(-paths);
                continue;
            }
            shone.add(read_words(gpu, &tile, &Role::LightSums)?);
            let reaches: Vec<u32> = read_words(gpu, &tile, &Role::LightReaches)?;
            shone.reaches.extend(reaches[..rays.len()].iter().map(|reaches| *reaches == 1));
            first = batch.end;
        }
        Ok(shone)
    }
}

/// The light that paths left.
struct Shone {
    /// The sums of each voxel or subvoxel.
    sums: Vec<[f64; 4]>,
    /// For each path, `true` if it left any light.
    reaches: Vec<bool>,
}

impl Shone {
    fn add(&mut self, words: Vec<[u32; 4]>) {
        self.sums.par_iter_mut().zip(words).for_each(|(sum, [x, y, z, all])| {
            let signed = |word: u32| f64::from(word.cast_signed());
            let new = [signed(x), signed(y), signed(z), f64::from(all)];
            sum.iter_mut().zip(new).for_each(|(sum, new)| *sum += new);
        });
    }
}

fn read_words<T: bytemuck::Pod>(gpu: &Gpu, tile: &Tile, role: &Role) -> Result<Vec<T>, RenderError> {
    let Some(buffer) = tile.buffer(role) else { return Ok(Vec::new()) };
    Ok(bytemuck::pod_collect_to_vec(&read_buffer(gpu, buffer, |_| {})?))
}
