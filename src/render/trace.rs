//! Following given rays, one by one, through the same passes.
//!
//! *Length.* Over 300 lines, because given rays, chosen pixels and whole paths are followed by the same tile and batches.

use glam::DVec3;

use super::records::{Records, Row};
use super::renderer::TileEnd;
use super::sample::Sample;
use super::step::Step;
use super::{RenderError, RenderSettings, Renderer, Status, Totals};
use crate::gpu::{Gpu, Tile, pack};
use crate::model::Object;
use crate::model::Value::Vec3;
use crate::model::law::Facts;
use crate::program::{Analysis, Choice, Masks, Pass, Purpose, Regions, Role, Schedule};
use crate::scene::{Precision, Scene};

/// Where a ray ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traced {
    /// How.
    pub status: Status,
    /// Position.
    pub x: [f64; 3],
    /// Velocity.
    pub v: [f64; 3],
    /// The path's parameter.
    pub tau: f64,
    /// Segments, whole ones and a fraction.
    pub depth: f64,
    /// Accepted steps.
    pub steps: u32,
    /// Rejected tries.
    pub rejected: u32,
    /// Index into the scene's objects, if one was hit.
    pub object: Option<u32>,
}

impl Traced {
    /// The angle between this ray's direction and another's, in radians.
    #[must_use]
    pub fn angle_to(&self, other: &Self) -> f64 {
        let (a, b) = (DVec3::from(self.v), DVec3::from(other.v));
        a.cross(b).length().atan2(a.dot(b))
    }

    /// Between this ray's end and another's.
    #[must_use]
    pub fn distance_to(&self, other: &Self) -> f64 {
        DVec3::from(self.x).distance(other.x.into())
    }

    /// The size of its velocity.
    #[must_use]
    pub fn speed(&self) -> f64 {
        DVec3::from(self.v).length()
    }
}

/// A segment's end along a path; the first is the path's start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Position.
    pub x: [f64; 3],
    /// Velocity.
    pub v: [f64; 3],
    /// The path's parameter.
    pub tau: f64,
}

/// Rays of one batch.
pub(super) const BATCH: usize = 1 << 18;
/// Records of one batch of paths, over all segments.
const PATH_RECORDS: usize = 1 << 22;
/// Arcs of one path, at most, where the picture's own path takes leaps: 2600 windings of a spiral.
const ARCS: u32 = 1 << 16;
/// Rays in one row of the state's textures.
const ROW: u32 = 1024;

/// Which rays to follow.
#[derive(Debug, Clone, Copy)]
pub enum Starts<'s> {
    /// Places and velocities.
    Given(&'s [[f64; 6]]),
    /// The camera's rays of these pixels, laid out in rows of so many: neighbours in the list run side by side.
    Pixels(&'s [[u32; 2]], u32),
}

/// Follows `rays` (x and v) to their ends.
pub fn trace(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<(Vec<Traced>, Totals), RenderError> {
    let choice = Choice { purpose: Purpose::Trace, layers: Vec::new(), ..settings.choice.clone() };
    Renderer::new(gpu, scene, RenderSettings { choice, ..settings.clone() })?.follow(Starts::Given(rays))
}

/// Follows the camera's rays of some pixels to their ends.
pub fn trace_pixels(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pixels: &[[u32; 2]],
) -> Result<(Vec<Traced>, Totals), RenderError> {
    let choice = Choice { purpose: Purpose::Pixels, layers: Vec::new(), ..settings.choice.clone() };
    Renderer::new(gpu, scene, RenderSettings { choice, ..settings.clone() })?.follow(Starts::Pixels(pixels, ROW))
}

impl Renderer<'_> {
    /// Follows rays to their ends; the program's purpose is to record them.
    pub fn follow(&mut self, starts: Starts) -> Result<(Vec<Traced>, Totals), RenderError> {
        let mut totals = Totals::default();
        let mut clock = super::clock::Clock::new(self.gpu, true);
        let started = std::time::Instant::now();
        let count = match starts {
            Starts::Given(rays) => rays.len(),
            Starts::Pixels(pixels, _) => pixels.len(),
        };
        let mut traced = Vec::with_capacity(count);
        let stage = self.gpu.progress.measured("following rays", count as f64);
        while traced.len() < count {
            let part = traced.len()..count.min(traced.len() + BATCH);
            let (tile, sample) = match starts {
                Starts::Given(rays) => ray_tile(self, &rays[part.clone()])?,
                Starts::Pixels(pixels, row) => pixel_tile(self, &pixels[part.clone()], row)?,
            };
            let told = |done: f64| stage.reach(part.start as f64 + done * part.len() as f64);
            self.run_sample(&tile, sample, &mut clock, &told)?;
            if self.read_tally(&tile, &mut totals, None)? == TileEnd::Done {
                traced.extend(read_records(self, &tile, part.len())?);
            }
            if let Starts::Given(rays) = starts {
                let ends = traced[part.start..].iter_mut().zip(&rays[part.start..]);
                let law = self.scene.law.facts();
                ends.filter(|(_, ray)| is_swallowed(&law, ray)).for_each(|(end, ray)| *end = captured_at(ray));
            }
        }
        self.finish_totals(&mut totals, &clock, started)?;
        // The last row of the state is filled up with pixels that have no ray.
        totals.rays = count as u64;
        totals.by_status = count_by_status(&traced);
        Ok((traced, totals))
    }
}

/// Does a ray start where nothing comes out?
fn is_swallowed(law: &Facts, ray: &[f64; 6]) -> bool {
    law.swallows(DVec3::from_slice(&ray[..3]))
}

/// The end of a ray that starts there.
fn captured_at(ray: &[f64; 6]) -> Traced {
    let [x, v] = [0, 3].map(|k| [ray[k], ray[k + 1], ray[k + 2]]);
    Traced { status: Status::Captured, x, v, tau: 0.0, depth: 0.0, steps: 0, rejected: 0, object: None }
}

fn count_by_status(traced: &[Traced]) -> Vec<(Status, u64)> {
    let count = |status: Status| traced.iter().filter(|ray| ray.status == status).count() as u64;
    std::iter::once(Status::Alive).chain(Status::ENDS).map(|s| (s, count(s))).filter(|(_, n)| *n > 0).collect()
}

/// Follows `rays` and keeps the end of every segment. Leaps, which pass any number of windings in one segment, are taken as the
/// arcs they stand for: up to 65,536 of them, in 64 bits where the device has them, because each begins where rounding put the one
/// before, which a leap does not.
pub fn trace_paths(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: &[[f64; 6]],
) -> Result<Vec<Path>, RenderError> {
    let choice =
        Choice { purpose: Purpose::Trace, schedule: Schedule::Segment, masks: Masks::List, ..Choice::default() };
    let leaping = Analysis::of(scene).regions.kinds.iter().any(|kind| kind.leaps);
    let mut scene = scene.clone();
    if std::mem::take(&mut scene.rays.leaps) && leaping {
        scene.rays.max_segments = scene.rays.max_segments.max(ARCS);
        if gpu.f64 && scene.rays.precision == Precision::Single {
            scene.rays.precision = Precision::Double;
        }
    }
    let mut renderer = Renderer::new(gpu, &scene, RenderSettings { choice, ..settings.clone() })?;
    let batch = (PATH_RECORDS / (scene.rays.max_segments as usize + 1)).clamp(1, BATCH);
    let mut paths = Vec::with_capacity(rays.len());
    let stage = gpu.progress.measured("following paths", rays.len() as f64);
    for batch in rays.chunks(batch) {
        paths.extend(trace_batch_paths(&mut renderer, batch)?);
        stage.advance(batch.len() as f64);
    }
    Ok(paths)
}

/// How a path ended, and the ends of its segments.
type Path = (Status, Vec<PathPoint>);

/// The camera's rays through the middles of some pixels, where they start to be followed: places and velocities.
pub fn pixel_starts(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pixels: &[[u32; 2]],
) -> Result<Vec<[f64; 6]>, RenderError> {
    let choice =
        Choice { purpose: Purpose::Pixels, schedule: Schedule::Segment, masks: Masks::Off, ..Choice::default() };
    let mut scene = scene.clone();
    scene.image.samples = 1;
    let renderer = Renderer::new(gpu, &scene, RenderSettings { choice, ..settings.clone() })?;
    let (tile, sample) = pixel_tile(&renderer, pixels, ROW)?;
    let steps = &renderer.plan.steps;
    let started = steps.iter().filter(|step| matches!(step.pass, Pass::Setup | Pass::Record)).copied();
    renderer.run_steps(&tile, sample, &started.collect::<Vec<_>>())?;
    let starts = read_starts(&renderer, &tile, pixels.len())?;
    if let Some((pixel, _)) = pixels.iter().zip(&starts).find(|(_, (status, _))| *status == Status::Outside) {
        return Err(RenderError::NoRay { pixel: *pixel });
    }
    Ok(starts.into_iter().map(|(_, PathPoint { x: [x, y, z], v: [a, b, c], .. })| [x, y, z, a, b, c]).collect())
}

/// Until no walk is cut short.
fn trace_batch_paths(renderer: &mut Renderer, batch: &[[f64; 6]]) -> Result<Vec<Path>, RenderError> {
    loop {
        let paths = try_batch_paths(renderer, batch)?;
        if paths.iter().all(|(status, _)| *status != Status::Alive) || !renderer.make_room()? {
            return Ok(paths);
        }
    }
}

fn try_batch_paths(renderer: &Renderer, batch: &[[f64; 6]]) -> Result<Vec<Path>, RenderError> {
    let plan = &renderer.plan;
    let (tile, sample) = ray_tile(renderer, batch)?;
    let law = renderer.scene.law.facts();
    let begun = |ray: &[f64; 6]| {
        let Traced { x, v, tau, .. } = captured_at(ray);
        let swallowed = is_swallowed(&law, ray);
        if swallowed { (Status::Captured, vec![PathPoint { x, v, tau }]) } else { (Status::Alive, Vec::new()) }
    };
    let mut paths: Vec<_> = batch.iter().map(begun).collect();
    let Some((record, rest)) = plan.steps.split_last() else { return Ok(paths) };
    let iterations = rest.chunk_by(|a, b| a.iteration == b.iteration && b.pass != Pass::Setup && a.pass != Pass::Setup);
    // Setup, then segment by segment until no ray is active.
    for iteration in iterations {
        let steps: Vec<Step> = iteration.iter().copied().chain([*record]).collect();
        renderer.run_steps(&tile, sample, &steps)?;
        let mut active = false;
        if iteration[0].pass == Pass::Setup {
            let starts = read_starts(renderer, &tile, batch.len())?;
            let begun = paths.iter_mut().zip(starts).filter(|((status, _), _)| *status == Status::Alive);
            begun.for_each(|((_, points), (_, start))| points.push(start));
        }
        for ((status, points), ray) in paths.iter_mut().zip(read_records(renderer, &tile, batch.len())?) {
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

/// A tile with one pixel a ray.
pub(super) fn ray_tile(renderer: &Renderer, batch: &[[f64; 6]]) -> Result<(Tile, Sample), RenderError> {
    let row = |ray: &[f64; 6]| {
        [("x", Vec3(DVec3::new(ray[0], ray[1], ray[2]))), ("v", Vec3(DVec3::new(ray[3], ray[4], ray[5])))]
    };
    let bytes = pack("given", renderer.layout(&Role::Given)?, batch.iter().map(row))?;
    let mut tile = list_tile(renderer, batch.len(), ROW, &Role::Given, &bytes)?;
    if renderer.program.layout(&Role::GivenSets).is_some() {
        let meshes = closed_meshes(&renderer.scene, &renderer.regions);
        let mut sets: Vec<u32> = Vec::with_capacity(batch.len());
        for (i, ray) in batch.iter().enumerate() {
            // Many may start at one place.
            let known = i.checked_sub(1).filter(|before| batch[*before][..3] == ray[..3]).map(|before| sets[before]);
            sets.push(known.unwrap_or_else(|| starting_set(&meshes, ray)));
        }
        tile.add_input(renderer.gpu, &Role::GivenSets, bytemuck::cast_slice(&sets))?;
    }
    let image = tile.size;
    Ok((tile, Sample::first(image)))
}

/// A mesh that rays may start in: its bit in the set of regions, and the corners of the box about it.
type ClosedMesh<'a> = (usize, &'a Object, (DVec3, DVec3));

fn closed_meshes<'a>(scene: &'a Scene, regions: &Regions) -> Vec<ClosedMesh<'a>> {
    let objects = regions.regions.iter().map(|region| &scene.objects[region.object]).enumerate();
    let meshes = objects.filter(|(_, object)| object.shape.mesh().is_some());
    meshes.map(|(bit, object)| (bit, object, object.bounds())).collect()
}

/// The meshes that a ray starts in, as bits of the set of regions. To ask a mesh takes as long as it has triangles.
fn starting_set(meshes: &[ClosedMesh], ray: &[f64; 6]) -> u32 {
    let x = DVec3::new(ray[0], ray[1], ray[2]);
    let near = |(lo, hi): &(DVec3, DVec3)| x.cmpge(*lo).all() && x.cmple(*hi).all();
    let inside = meshes.iter().filter(|(_, object, bounds)| near(bounds) && object.contains(x));
    inside.fold(0, |set, (bit, ..)| set | 1 << bit)
}

/// A tile whose pixels stand for pixels of the picture.
fn pixel_tile(renderer: &Renderer, batch: &[[u32; 2]], row: u32) -> Result<(Tile, Sample), RenderError> {
    let tile = list_tile(renderer, batch.len(), row, &Role::Chosen, bytemuck::cast_slice(batch))?;
    Ok((tile, Sample::first(renderer.scene.image.size)))
}

/// A tile of rows of `row` pixels, with a list of what each is and room for their records.
fn list_tile(renderer: &Renderer, count: usize, row: u32, role: &Role, list: &[u8]) -> Result<Tile, RenderError> {
    let width = row.min(count as u32).max(1);
    let size = [width, (count as u32).div_ceil(width).max(1)];
    let mut tile = renderer.tile(size)?;
    tile.add_input(renderer.gpu, role, list)?;
    let records = u64::from(renderer.layout(&Role::Records)?.span) * u64::from(size[0]) * u64::from(size[1]);
    tile.add_storage(renderer.gpu, &Role::Records, records)?;
    Ok(tile)
}

fn read_records(renderer: &Renderer, tile: &Tile, count: usize) -> Result<Vec<Traced>, RenderError> {
    let traced = |row: Row| Traced {
        status: Status::from_code(row.uint("status")),
        x: row.vector("x"),
        v: row.vector("v"),
        tau: row.float("tau"),
        depth: row.float("depth"),
        steps: row.uint("steps"),
        rejected: row.uint("rejected"),
        object: row.uint("object").checked_sub(1),
    };
    Ok(Records::read(renderer.gpu, &renderer.program, tile, &Role::Records)?.rows().take(count).map(traced).collect())
}

/// Where rays start, after the setup alone: it knows of some that they end in their first segment, and records that end.
fn read_starts(renderer: &Renderer, tile: &Tile, count: usize) -> Result<Vec<(Status, PathPoint)>, RenderError> {
    let begun = |row: Row| {
        let start = PathPoint { x: row.vector("from_x"), v: row.vector("from_v"), tau: 0.0 };
        (Status::from_code(row.uint("status")), start)
    };
    Ok(Records::read(renderer.gpu, &renderer.program, tile, &Role::Records)?.rows().take(count).map(begun).collect())
}
