//! Follows given rays, one by one, through the same passes.

use std::borrow::Cow;

use rayon::prelude::*;

use super::crossings::{Crossings, crossings};
use super::grids::LightGrids;
use super::prepared::Prepared;
use super::ray_tiles::{BATCH, ROW, captured_at, is_swallowed, pixel_tile, ray_tile, read_records};
use super::records::{Records, Row};
use super::tile::TileEnd;
use super::{RenderError, RenderSettings, Status, Totals, Traced};
use crate::gpu::{Gpu, GpuError, Tile};
use crate::model::Control;
use crate::model::volume::MOST_FREQUENCIES;
use crate::program::{Mode, Role};
use crate::scene::Scene;

/// The rays to follow.
#[derive(Debug, Clone, Copy)]
pub enum Starts<'s> {
    /// Positions and velocities.
    Given(&'s [[f64; 6]]),
    /// The camera's rays of these pixels, laid out in rows of this length: neighbors in the list run side by side.
    Pixels(&'s [[u32; 2]], u32),
}

impl Starts<'_> {
    /// Returns the purpose of a program that follows these rays.
    #[must_use]
    pub fn mode(&self) -> Mode {
        match self {
            Self::Given(_) => Mode::Trace,
            Self::Pixels(..) => Mode::Pixels,
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::Given(rays) => rays.len(),
            Self::Pixels(pixels, _) => pixels.len(),
        }
    }
}

/// Follows `rays` to their ends under the law of `scene`, and returns the ends in the same order with the totals. No camera is needed.
///
/// A ray is `[x, y, z, vx, vy, vz]`: a position in scene units, and a velocity dx/dτ that is not 0. The rays of a camera start with the
/// speed 1. Numbers are rounded to 32 bits, unless the scene has the precision of 64 bits.
///
/// # Errors
///
/// Returns [`RenderError::Program`] if WGSL of the scene is invalid or the scene has too many primitives, [`RenderError::Window`] if the
/// window of the settings is not inside the image, and [`RenderError::Gpu`] if the device lacks a feature or memory, or fails.
///
/// # Examples
///
/// ```no_run
/// use bentray::glam::DVec3;
/// use bentray::{gpu::Gpu, model::law::RoundHole, render::{RenderSettings, Status, trace}, scene::Scene};
///
/// let scene = Scene::new(RoundHole::new(1.0, DVec3::ZERO), 50.0);
/// let rays = [[-40.0, 4.0, 0.0, 1.0, 0.0, 0.0], [-40.0, 8.0, 0.0, 1.0, 0.0, 0.0]];
/// let (ends, _) = trace(&Gpu::open(None)?, &scene, &RenderSettings::default(), &rays)?;
/// // The critical impact parameter is √27 M, about 5.2.
/// assert_eq!([ends[0].status, ends[1].status], [Status::Captured, Status::Escaped]);
/// # Ok::<(), bentray::render::RenderError>(())
/// ```
pub fn trace(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<(Vec<Traced>, Totals), RenderError> {
    Tracer::new(gpu, scene, settings.clone(), Mode::Trace)?.follow(Starts::Given(rays))
}

/// Follows the camera's rays of some pixels to their ends, and returns the ends in the same order with the totals.
///
/// A pixel is its column and row, counted from 0 at the top left. The ray is that of the first sample of the pixel. Its status is
/// [`Status::Outside`] if the camera has no ray there.
///
/// # Errors
///
/// Returns [`RenderError::NoCamera`] if the scene has no camera, and the errors of [`trace`].
///
/// # Examples
///
/// ```no_run
/// use bentray::{gpu::Gpu, render::{RenderSettings, trace_pixels}, scene::Scene};
///
/// let scene = Scene::load("scenes/black_hole.toml".as_ref(), &[])?;
/// let center = scene.image.size.map(|side| side / 2);
/// let (ends, totals) = trace_pixels(&Gpu::open(None)?, &scene, &RenderSettings::default(), &[center])?;
/// println!("{}: object {:?} after {} steps", ends[0].status.name(), ends[0].object, totals.steps);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn trace_pixels(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pixels: &[[u32; 2]],
) -> Result<(Vec<Traced>, Totals), RenderError> {
    Tracer::new(gpu, scene, settings.clone(), Mode::Pixels)?.follow(Starts::Pixels(pixels, ROW))
}

/// A tracer that follows single rays of a scene and returns their ends.
#[derive(Debug)]
pub struct Tracer<'a> {
    pub(super) prepared: Prepared<'a>,
    /// The tile of the previous rays, for the next ones.
    tile: Option<Tile>,
    crossings: Vec<Crossings>,
    spectra: Vec<Vec<Transferred>>,
}

/// The light of a ray at one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transferred {
    /// The intensity at the start of the ray, in the units of the layer `intensity_K`.
    pub intensity: f64,
    /// The optical depth of volumes on the path.
    pub optical_depth: f64,
}

impl<'a> Tracer<'a> {
    /// Creates a tracer for this purpose: [`Mode::Trace`] for given rays, [`Mode::Pixels`] for the camera's rays, or
    /// [`Mode::Bare`].
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::NoCamera`] for the camera's rays of a scene without a camera, and the errors of [`trace`].
    ///
    /// # Examples
    ///
    /// ```no_run
    /// use bentray::render::{RenderSettings, Starts, Tracer};
    /// use bentray::{gpu::Gpu, model::law::Straight, program::Mode, scene::Scene};
    ///
    /// let (gpu, scene) = (Gpu::open(None)?, Scene::new(Straight, 10.0));
    /// let mut tracer = Tracer::new(&gpu, &scene, RenderSettings::default(), Mode::Trace)?;
    /// for y in [0.0, 1.0, 2.0] {
    ///     let (ends, _) = tracer.follow(Starts::Given(&[[0.0, y, 0.0, 1.0, 0.0, 0.0]]))?;
    ///     println!("{:?}", ends[0].x);
    /// }
    /// # Ok::<(), bentray::render::RenderError>(())
    /// ```
    pub fn new(gpu: &'a Gpu, scene: &'a Scene, settings: RenderSettings, mode: Mode) -> Result<Self, RenderError> {
        Self::of(gpu, Cow::Borrowed(scene), settings, mode)
    }

    /// Creates a tracer like [`new`](Self::new), which owns its scene.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`new`](Self::new).
    pub fn keeping(gpu: &'a Gpu, scene: Scene, settings: RenderSettings, mode: Mode) -> Result<Self, RenderError> {
        Self::of(gpu, Cow::Owned(scene), settings, mode)
    }

    fn of(gpu: &'a Gpu, scene: Cow<'a, Scene>, mut settings: RenderSettings, mode: Mode) -> Result<Self, RenderError> {
        settings.options.mode = mode;
        settings.options.layers.retain(|layer| layer.is_of_crossings());
        let prepared = Prepared::new(gpu, scene, settings, LightGrids::default())?;
        Ok(Self { prepared, tile: None, crossings: Vec::new(), spectra: Vec::new() })
    }

    /// Changes the parameters of the step control and the maximum number of segments of a path. The kind of control stays, and no pass is
    /// recompiled.
    ///
    /// # Errors
    ///
    /// Returns [`GpuError::Layout`] if `control` has other parameters than the control of the scene.
    pub fn retune(&mut self, control: Control, max_segments: u32) -> Result<(), GpuError> {
        self.prepared.retune(control, max_segments)
    }

    /// Follows rays to their ends, and returns the ends in the same order with the totals. `starts` must match the purpose of the tracer:
    /// [`Starts::mode`].
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::Gpu`] if the device fails or has too little memory, or if `starts` is of another purpose.
    pub fn follow(&mut self, starts: Starts) -> Result<(Vec<Traced>, Totals), RenderError> {
        let prepared = &mut self.prepared;
        self.crossings.clear();
        self.spectra.clear();
        let mut totals = Totals::default();
        let mut clock = super::clock::Clock::new(prepared.gpu, true);
        let started = std::time::Instant::now();
        let count = starts.len();
        let mut traced = Vec::with_capacity(count);
        let stage = prepared.gpu.progress.measured("tracing rays", count as f64);
        while traced.len() < count {
            let part = traced.len()..count.min(traced.len() + BATCH);
            let (tile, sample) = match starts {
                Starts::Given(rays) => ray_tile(prepared, self.tile.take(), &rays[part.clone()])?,
                Starts::Pixels(pixels, row) => pixel_tile(prepared, self.tile.take(), &pixels[part.clone()], row)?,
            };
            let told = |done: f64| stage.reach(part.start as f64 + done * part.len() as f64);
            prepared.run_sample(&tile, sample, &mut clock, &told)?;
            if prepared.read_tally(&tile, &mut totals, None)? != TileEnd::Done {
                continue;
            }
            read_records(prepared, &tile, part.len(), &mut traced)?;
            if prepared.program.features.keeps_crossings {
                let pixels = Records::read(prepared.gpu, &prepared.program, &tile, &Role::Pixels)?;
                self.crossings.extend(crossings(&pixels, &prepared.scene).into_iter().take(part.len()));
            }
            if prepared.program.features.volumes.is_spectral {
                let pixels = Records::read(prepared.gpu, &prepared.program, &tile, &Role::Pixels)?;
                self.spectra.extend(spectra(&pixels, &prepared.scene).into_iter().take(part.len()));
            }
            let law = prepared.scene.law.facts();
            if let Starts::Given(rays) = starts
                && law.swallows.is_some()
            {
                let ends = traced[part.start..].iter_mut().zip(&rays[part.start..]);
                ends.filter(|(_, ray)| is_swallowed(&law, ray)).for_each(|(end, ray)| *end = captured_at(ray));
            }
            self.tile = Some(tile);
        }
        prepared.finish_totals(&mut totals, &clock, started)?;
        // The last row of the state is padded with pixels that have no ray.
        totals.rays = count as u64;
        totals.by_status = count_by_status(&traced);
        Ok((traced, totals))
    }

    /// Returns the light of the rays of the last call of [`follow`](Self::follow) at each frequency of the scene, in the same order; empty
    /// without `[radiation]`. The frequencies are those of a static observer at the start of a given ray, or of the camera.
    #[must_use]
    pub fn spectra(&self) -> &[Vec<Transferred>] {
        &self.spectra
    }

    /// Returns where the rays of the last call of [`follow`](Self::follow) crossed translucent surfaces and ended on surfaces, in the same
    /// order; empty unless the layers of the settings include one of crossings, which selects all their values.
    #[must_use]
    pub fn crossings(&self) -> &[Crossings] {
        &self.crossings
    }
}

/// Returns the light of the rays of a tile at each frequency.
fn spectra(pixels: &Records, scene: &Scene) -> Vec<Vec<Transferred>> {
    let (field, unit) = (pixels.field("transfer"), scene.intensity_unit().unwrap_or(1.0));
    let frequencies = scene.frequencies();
    let of = |row: Row| {
        let numbers = row.numbers::<{ 2 * MOST_FREQUENCIES }>(field);
        let (pairs, _) = numbers.as_chunks();
        let pairs = pairs[..frequencies].iter();
        pairs.map(|&[light, optical_depth]| Transferred { intensity: unit * light, optical_depth }).collect()
    };
    pixels.par_rows().map(of).collect()
}

fn count_by_status(traced: &[Traced]) -> Vec<(Status, u64)> {
    let all = std::iter::once(Status::Alive).chain(Status::ENDS);
    let mut counts: Vec<(Status, u64)> = all.map(|status| (status, 0)).collect();
    for ray in traced {
        if let Some((_, count)) = counts.iter_mut().find(|(status, _)| *status == ray.status) {
            *count += 1;
        }
    }
    counts.retain(|(_, count)| *count > 0);
    counts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{ProgramOptions, Schedule};

    /// A tracer keeps its tile, whose old contents must not show.
    #[test]
    fn later_rays_end_as_in_a_new_tracer() {
        let gpu = Gpu::open(None).unwrap();
        let text = "[law]\nkind = \"schwarzschild\"\n[rays]\nmethod = \"rk4\"\nbounding_sphere = { radius = 30 }\n\
                    [materials.m]\nkind = \"mirror\"\n[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\ncenter = [9, 0, 0]\n\
                    [[objects]]\nshape = \"sphere\"\ninterior = 1.5\ncenter = [-9, 0, 0]\nradius = 3\n";
        let scene = Scene::parse(text, std::path::Path::new("test.toml"), &[]).unwrap();
        let rays = |angle: f64| -> Vec<[f64; 6]> {
            let ray = |i: i32| [-20.0, f64::from(i) / 8.0, angle, 1.0, angle * f64::from(i), 0.0];
            (-100..100).map(ray).collect()
        };
        for schedule in Schedule::ALL {
            let options = ProgramOptions { schedule, ..ProgramOptions::default() };
            let settings = RenderSettings { options, ..RenderSettings::default() };
            let mut kept = Tracer::new(&gpu, &scene, settings.clone(), Mode::Trace).unwrap();
            for angle in [0.0, 0.01, 0.002, 0.0] {
                let rays = rays(angle);
                let (ends, _) = kept.follow(Starts::Given(&rays)).unwrap();
                let (fresh, _) = trace(&gpu, &scene, &settings, &rays).unwrap();
                assert!(ends == fresh, "{schedule:?}, {angle}");
            }
        }
    }
}
