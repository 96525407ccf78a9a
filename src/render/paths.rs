//! Follows given rays segment by segment, and records the end of every segment.

use glam::DVec3;

use super::prepared::Prepared;
use super::ray_tiles::{BATCH, ROW, captured_at, is_swallowed, pixel_tile, ray_tile, read_records, read_starts};
use super::step::Step;
use super::trace::Tracer;
use super::{PathPoint, RenderError, RenderSettings, Status, Traced};
use crate::gpu::Gpu;
use crate::program::{Analysis, Mode, Pass, ProgramOptions, RaySkipping, Schedule};
use crate::scene::{Precision, Scene};

/// The number of records of one batch of paths, over all segments.
const PATH_RECORDS: usize = 1 << 22;
/// The maximum number of arcs of one path, if the image's own path takes leaps: 2600 windings of a spiral.
const ARCS: u32 = 1 << 16;

/// Follows `rays`, as [`trace`](super::trace()) does, and returns the status of each path and the ends of its segments, beginning with its
/// start.
///
/// A leap, which passes any number of windings in one segment, is replaced by its arcs: up to 65,536 of them, in 64 bits if the device
/// supports it, because each arc begins at the rounded end of the previous one.
///
/// # Errors
///
/// Returns the errors of [`trace`](super::trace()).
///
/// # Examples
///
/// ```no_run
/// use bentray::glam::DVec3;
/// use bentray::{gpu::Gpu, model::law::RoundHole, render::{RenderSettings, trace_paths}, scene::Scene};
///
/// let scene = Scene::new(RoundHole::new(1.0, DVec3::ZERO), 50.0);
/// let rays = [[-40.0, 6.0, 0.0, 1.0, 0.0, 0.0]];
/// for (status, points) in trace_paths(&Gpu::open(None)?, &scene, &RenderSettings::default(), &rays)? {
///     println!("{} after {} segments", status.name(), points.len() - 1);
/// }
/// # Ok::<(), bentray::render::RenderError>(())
/// ```
pub fn trace_paths(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<Vec<Path>, RenderError> {
    let options = ProgramOptions { schedule: Schedule::Segment, masks: RaySkipping::List, ..ProgramOptions::default() };
    let leaping = Analysis::of(scene).regions.kinds.iter().any(|kind| kind.leaps);
    let mut scene = scene.clone();
    if std::mem::take(&mut scene.rays.leaps) && leaping {
        scene.rays.max_segments = scene.rays.max_segments.max(ARCS);
        if gpu.f64 && scene.rays.precision == Precision::Single {
            scene.rays.precision = Precision::Double;
        }
    }
    let Tracer { mut prepared, .. } =
        Tracer::new(gpu, &scene, RenderSettings { options, ..settings.clone() }, Mode::Trace)?;
    let batch = (PATH_RECORDS / (scene.rays.max_segments as usize + 1)).clamp(1, BATCH);
    let mut paths = Vec::with_capacity(rays.len());
    let stage = gpu.progress.measured("tracing paths", rays.len() as f64);
    for batch in rays.chunks(batch) {
        paths.extend(trace_batch_paths(&mut prepared, batch)?);
        stage.advance(batch.len() as f64);
    }
    Ok(paths)
}

/// The termination status of a path, and the ends of its segments.
type Path = (Status, Vec<PathPoint>);

/// Returns the starts of the camera's rays through the centers of some pixels, as `[x, y, z, vx, vy, vz]` for [`trace`](super::trace()).
///
/// A pixel is its column and row, counted from 0 at the top left.
///
/// # Errors
///
/// Returns [`RenderError::NoCamera`] if the scene has no camera, [`RenderError::NoRay`] if the camera has no ray through a pixel, and the
/// errors of [`trace`](super::trace()).
///
/// # Examples
///
/// ```no_run
/// use bentray::{gpu::Gpu, render::{RenderSettings, pixel_starts, trace_paths}, scene::Scene};
///
/// let (gpu, settings) = (Gpu::open(None)?, RenderSettings::default());
/// let scene = Scene::load("scenes/black_hole.toml".as_ref(), &[])?;
/// let starts = pixel_starts(&gpu, &scene, &settings, &[[100, 80]])?;
/// let paths = trace_paths(&gpu, &scene, &settings, &starts)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pixel_starts(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pixels: &[[u32; 2]],
) -> Result<Vec<[f64; 6]>, RenderError> {
    let options = ProgramOptions { schedule: Schedule::Segment, masks: RaySkipping::Off, ..ProgramOptions::default() };
    let mut scene = scene.clone();
    scene.image.samples = 1;
    let Tracer { prepared, .. } =
        Tracer::new(gpu, &scene, RenderSettings { options, ..settings.clone() }, Mode::Pixels)?;
    let (tile, sample) = pixel_tile(&prepared, None, pixels, ROW)?;
    let steps = &prepared.plan.steps;
    let started = steps.iter().filter(|step| matches!(step.pass, Pass::Setup | Pass::Record)).copied();
    prepared.run_steps(&tile, sample, &started.collect::<Vec<_>>())?;
    let starts = read_starts(&prepared, &tile, pixels.len())?;
    if let Some((pixel, _)) = pixels.iter().zip(&starts).find(|(_, (status, _))| *status == Status::Outside) {
        return Err(RenderError::NoRay { pixel: *pixel });
    }
    Ok(starts.into_iter().map(|(_, PathPoint { x: [x, y, z], v: [a, b, c], .. })| [x, y, z, a, b, c]).collect())
}

/// Traces a batch of paths, with more passes until no traversal is cut short.
fn trace_batch_paths(prepared: &mut Prepared, batch: &[[f64; 6]]) -> Result<Vec<Path>, RenderError> {
    loop {
        let paths = try_batch_paths(prepared, batch)?;
        if paths.iter().all(|(status, _)| *status != Status::Alive) || !prepared.make_room()? {
            return Ok(paths);
        }
    }
}

fn try_batch_paths(prepared: &Prepared, batch: &[[f64; 6]]) -> Result<Vec<Path>, RenderError> {
    let plan = &prepared.plan;
    let (tile, sample) = ray_tile(prepared, None, batch)?;
    let law = prepared.scene.law.facts();
    let begun = |ray: &[f64; 6]| {
        let Traced { x, v, tau, .. } = captured_at(ray);
        let swallowed = is_swallowed(&law, ray);
        if swallowed { (Status::Captured, vec![PathPoint { x, v, tau }]) } else { (Status::Alive, Vec::new()) }
    };
    let mut paths: Vec<_> = batch.iter().map(begun).collect();
    let Some((record, rest)) = plan.steps.split_last() else { return Ok(paths) };
    let iterations = rest.chunk_by(|a, b| a.iteration == b.iteration && b.pass != Pass::Setup && a.pass != Pass::Setup);
    // Run the setup, then one segment after another until no ray is active.
    for iteration in iterations {
        let steps: Vec<Step> = iteration.iter().copied().chain([*record]).collect();
        prepared.run_steps(&tile, sample, &steps)?;
        let mut active = false;
        if iteration[0].pass == Pass::Setup {
            let starts = read_starts(prepared, &tile, batch.len())?;
            let begun = paths.iter_mut().zip(starts).filter(|((status, _), _)| *status == Status::Alive);
            begun.for_each(|((_, points), (_, start))| points.push(start));
        }
        let mut ends = Vec::new();
        read_records(prepared, &tile, batch.len(), &mut ends)?;
        for ((status, points), ray) in paths.iter_mut().zip(ends) {
            if *status != Status::Alive {
                continue;
            }
            // Most rays are still at their start after the setup.
            if iteration[0].pass == Pass::Setup && points.iter().all(|start| DVec3::from(start.x) == ray.x.into()) {
                points.clear();
            }
            points.push(PathPoint { x: ray.x, v: ray.v, tau: ray.tau });
            *status = ray.status;
            active |= *status == Status::Alive;
        }
        if !active {
            break;
        }
    }
    Ok(paths)
}
