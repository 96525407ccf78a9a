//! The paths that lead from lights to places, found by shooting.

use std::time::Instant;

use glam::DVec3;

use super::clock::Clock;
use super::trace::{BATCH, ray_tile, read_rows};
use super::{RenderError, RenderSettings, Renderer, Totals};
use crate::gpu::Gpu;
use crate::program::{Choice, Masks, Purpose, Schedule, shots};
use crate::scene::Scene;

/// A path that leads from a light to a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightPath {
    /// Its unit direction at the light.
    pub leaves: [f64; 3],
    /// Its unit direction at the place.
    pub arrives: [f64; 3],
    /// The area of the bundle about it at the place, square to it, for each solid angle at the light.
    pub spread: f64,
    /// Is nothing opaque on it?
    pub clear: bool,
}

/// Directions at the light closer than this are one path's.
const SAME: f64 = 2e-3;

/// Each path once.
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

/// For each pair of a place and a light the paths between them under the scene's law, as many as shooting finds: about one centre all that
/// go less than once round. Light leaves with the law's own speed, or with 1.
pub fn light_paths(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pairs: &[[DVec3; 2]],
) -> Result<(Vec<Vec<LightPath>>, Totals), RenderError> {
    let choice = Choice { purpose: Purpose::Lit, schedule: Schedule::Fused, masks: Masks::Off, layers: Vec::new() };
    let renderer = Renderer::new(gpu, scene, RenderSettings { choice, ..settings.clone() })?;
    let (each, started) = (shots(scene), Instant::now());
    let mut clock = Clock::new(gpu, true);
    let (mut found, mut totals) = (Vec::with_capacity(pairs.len()), Totals::default());
    let stage = gpu.progress.measured("shooting rays at lights", pairs.len() as f64);
    for batch in pairs.chunks(BATCH / each) {
        // One ray for each path that is looked for.
        let rays: Vec<[f64; 6]> = batch.iter().flat_map(|[x, s]| vec![[x.x, x.y, x.z, s.x, s.y, s.z]; each]).collect();
        let (tile, sample) = ray_tile(&renderer, &rays)?;
        renderer.run_sample(&tile, sample, &mut clock, &|_| {})?;
        renderer.read_tally(&tile, &mut totals, None)?;
        let rows = read_rows(&renderer, &tile, rays.len(), |row| {
            let path = LightPath {
                leaves: row.vector("leaves"),
                arrives: row.vector("arrives"),
                spread: row.float("spread", 0),
                clear: row.uint("clear") == 1,
            };
            (row.uint("found") == 1).then_some(path)
        })?;
        stage.advance(batch.len() as f64);
        found.extend(rows.chunks(each).map(|shots| distinct(shots.iter().flatten())));
    }
    renderer.finish_totals(&mut totals, &clock, started)?;
    Ok((found, totals))
}
