//! Finds the paths from lights to positions by the shooting method.

use std::borrow::Cow;
use std::time::Instant;

use glam::DVec3;

use super::clock::Clock;
use super::grids::LightGrids;
use super::prepared::Prepared;
use super::ray_tiles::{BATCH, ray_tile};
use super::records::{Records, Row};
use super::{RenderError, RenderSettings, Totals};
use crate::gpu::{Gpu, GpuError};
use crate::model::Control;
use crate::program::{Mode, ProgramOptions, RaySkipping, Role, Schedule, all_shots, constant};
use crate::scene::Scene;

/// A path from a light to a position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightPath {
    /// The unit direction at the light.
    pub leaves: [f64; 3],
    /// The unit direction at the position.
    pub arrives: [f64; 3],
    /// The cross section of the ray bundle at the position, per unit solid angle at the light.
    pub spread: f64,
    /// The estimated error of its directions, in radians, from the distance by which it misses the position.
    pub error: f64,
    /// `true` if nothing opaque blocks it.
    pub clear: bool,
}

/// The distance between directions at the light below which two paths are identical.
const SAME: f64 = 2e-3;

/// Returns each path once.
fn distinct<'p>(paths: impl Iterator<Item = &'p LightPath>) -> Vec<LightPath> {
    let mut found: Vec<LightPath> = Vec::new();
    for path in paths {
        let is_known = |known: &LightPath| DVec3::from(known.leaves).distance(path.leaves.into()) < SAME;
        if !found.iter().any(is_known) {
            found.push(*path);
        }
    }
    found
}

/// Finds, for each pair of a position and a light, the paths between them under the law of the scene, in scene units.
///
/// Around a single center, shooting finds all paths that make less than one revolution. Light leaves with the speed that the law
/// prescribes, or with 1. A pair without paths has an empty list.
///
/// # Errors
///
/// Returns [`RenderError::Program`] if WGSL of the scene is invalid or the scene has too many primitives, [`RenderError::Window`] if the
/// window of the settings is not inside the image, and [`RenderError::Gpu`] if the device lacks a feature or memory, or fails.
///
/// # Examples
///
/// ```no_run
/// use bentray::glam::{DVec3, dvec3};
/// use bentray::{gpu::Gpu, model::law::RoundHole, render::{RenderSettings, light_paths}, scene::Scene};
///
/// let scene = Scene::new(RoundHole::new(1.0, DVec3::ZERO), 50.0);
/// let pairs = [[dvec3(10.0, 0.0, 0.0), dvec3(-10.0, 8.0, 0.0)]];
/// let (paths, _) = light_paths(&Gpu::open(None)?, &scene, &RenderSettings::default(), &pairs)?;
/// for path in &paths[0] {
///     println!("leaves the light along {:?}, clear: {}", path.leaves, path.clear);
/// }
/// # Ok::<(), bentray::render::RenderError>(())
/// ```
pub fn light_paths(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pairs: &[[DVec3; 2]],
) -> Result<(Vec<Vec<LightPath>>, Totals), RenderError> {
    LightTracer::new(gpu, scene.clone(), settings)?.paths_between(pairs)
}

/// A tracer that finds the paths from lights to positions.
#[derive(Debug)]
pub struct LightTracer<'a> {
    prepared: Prepared<'a>,
}

impl<'a> LightTracer<'a> {
    /// Creates a tracer: links and compiles the program, and uploads the scene.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`light_paths`].
    pub fn new(gpu: &'a Gpu, scene: Scene, settings: &RenderSettings) -> Result<Self, RenderError> {
        let options = ProgramOptions {
            mode: Mode::Lit,
            schedule: Schedule::Fused,
            masks: RaySkipping::Off,
            ..ProgramOptions::default()
        };
        let settings = RenderSettings { options, ..settings.clone() };
        Ok(Self { prepared: Prepared::new(gpu, Cow::Owned(scene), settings, LightGrids::default())? })
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

    /// Finds, for each pair of a position and a light, the paths between them, like [`light_paths`].
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::Gpu`] if the device fails or has too little memory.
    pub fn paths_between(&mut self, pairs: &[[DVec3; 2]]) -> Result<(Vec<Vec<LightPath>>, Totals), RenderError> {
        let prepared = &mut self.prepared;
        let (each, started) = (all_shots(&prepared.scene), Instant::now());
        let mut clock = Clock::new(prepared.gpu, true);
        let (mut found, mut totals) = (Vec::with_capacity(pairs.len()), Totals::default());
        let stage = prepared.gpu.progress.measured("tracing rays to lights", pairs.len() as f64);
        let abreast = constant("pass/shots", "ABREAST") as usize;
        for batch in pairs.chunks(BATCH / each) {
            // One ray searches for each path. A row is padded with positions that coincide with their light.
            let row = |pair: Option<&[DVec3; 2]>| pair.map_or([0.0; 6], |[x, s]| [x.x, x.y, x.z, s.x, s.y, s.z]);
            let rows = batch.chunks(abreast).map(|pairs| (0..abreast).map(|i| row(pairs.get(i))).collect::<Vec<_>>());
            let rays: Vec<[f64; 6]> = rows.flat_map(|pairs| pairs.repeat(each)).collect();
            let (tile, sample) = ray_tile(prepared, None, &rays)?;
            prepared.run_sample(&tile, sample, &mut clock, &|_| {})?;
            prepared.read_tally(&tile, &mut totals, None)?;
            let path = |row: Row| {
                let path = LightPath {
                    leaves: row.vector("leaves"),
                    arrives: row.vector("arrives"),
                    spread: row.float("spread"),
                    error: row.float("error"),
                    clear: row.uint("clear") == 1,
                };
                (row.uint("found") == 1).then_some(path)
            };
            let rows: Vec<_> =
                Records::read(prepared.gpu, &prepared.program, &tile, &Role::Records)?.rows().map(path).collect();
            stage.advance(batch.len() as f64);
            let own = |pair: usize| {
                let first = pair / abreast * each * abreast + pair % abreast;
                distinct(rows[first..].iter().step_by(abreast).take(each).flatten())
            };
            found.extend((0..batch.len()).map(own));
        }
        prepared.finish_totals(&mut totals, &clock, started)?;
        Ok((found, totals))
    }
}
