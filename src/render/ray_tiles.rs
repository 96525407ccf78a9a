//! Creates tiles whose pixels are single rays: writes their starts, and reads their records.

use glam::DVec3;
use rayon::prelude::*;

use super::prepared::Prepared;
use super::records::{Records, Row};
use super::sample::Sample;
use super::{PathPoint, RenderError, Status, Traced};
use crate::gpu::{GpuError, Tile, pack};
use crate::model::Object;
use crate::model::Value::Vec3;
use crate::model::law::LawProperties;
use crate::program::{Layout, Regions, Role};
use crate::scene::Scene;

/// The number of rays in one batch.
pub(super) const BATCH: usize = 1 << 18;
/// The smallest number of rays that a thread of the host converts at once.
const FEW: usize = 1 << 12;
/// The number of rays in one row of the state's textures.
pub(super) const ROW: u32 = 1024;

/// Returns `true` if a ray starts in a region that no light leaves.
pub(super) fn is_swallowed(law: &LawProperties, ray: &[f64; 6]) -> bool {
    law.swallows(DVec3::from_slice(&ray[..3]))
}

/// Returns the end of a ray that is captured at its start.
pub(super) fn captured_at(ray: &[f64; 6]) -> Traced {
    let [x, v] = [0, 3].map(|k| [ray[k], ray[k + 1], ray[k + 2]]);
    Traced { status: Status::Captured, x, v, tau: 0.0, segments: 0.0, steps: 0, rejected: 0, object: None }
}

/// Returns a tile with one pixel per ray: an earlier one of the same program with other rays, if it is like it, or a new one.
pub(super) fn ray_tile(
    prepared: &Prepared,
    earlier: Option<Tile>,
    batch: &[[f64; 6]],
) -> Result<(Tile, Sample), RenderError> {
    // A law without forces keeps any speed, but frequencies and times are those of light.
    let is_light = prepared.scene.radiation.is_some() && prepared.scene.law.facts().is_straight;
    let as_light = is_light.then(|| batch.iter().map(at_light_speed).collect::<Vec<_>>());
    let bytes = packed(prepared.layout(&Role::Given)?, as_light.as_deref().unwrap_or(batch))?;
    let mut tile = list_tile((prepared, earlier), batch.len(), ROW, &Role::Given, &bytes)?;
    if prepared.program.layout(&Role::GivenSets).is_some() {
        let meshes = closed_meshes(&prepared.scene, &prepared.regions);
        let mut sets: Vec<u32> = Vec::with_capacity(batch.len());
        for (i, ray) in batch.iter().enumerate() {
            // Many rays may start at one position.
            let known = i.checked_sub(1).filter(|before| batch[*before][..3] == ray[..3]).map(|before| sets[before]);
            sets.push(known.unwrap_or_else(|| starting_set(&meshes, ray)));
        }
        tile.add_input(prepared.gpu, &Role::GivenSets, bytemuck::cast_slice(&sets))?;
    }
    let image = tile.size;
    Ok((tile, Sample::first(image)))
}

/// Returns a ray with the speed 1.
fn at_light_speed(ray: &[f64; 6]) -> [f64; 6] {
    let v = DVec3::from_slice(&ray[3..]).normalize_or_zero();
    [ray[0], ray[1], ray[2], v.x, v.y, v.z]
}

/// Returns rays as the device reads them. The first is packed and checked like all other values, and the others like the first.
fn packed(layout: &Layout, batch: &[[f64; 6]]) -> Result<Vec<u8>, GpuError> {
    let row = |ray: &[f64; 6]| {
        [("x", Vec3(DVec3::new(ray[0], ray[1], ray[2]))), ("v", Vec3(DVec3::new(ray[3], ray[4], ray[5])))]
    };
    let first = pack("given", layout, batch.iter().take(1).map(row))?;
    let places = ["x", "v"].map(|name| layout.field(name).map_or((0, 0), |f| (f.offset as usize, f.width as usize)));
    let mut bytes = vec![0; batch.len() * layout.span as usize];
    bytes.par_chunks_exact_mut(layout.span as usize).zip(batch).with_min_len(FEW).for_each(|(bytes, ray)| {
        for ((offset, width), values) in places.into_iter().zip(ray.chunks_exact(3)) {
            for (scalar, value) in bytes[offset..].chunks_exact_mut(width.max(1)).zip(values) {
                match width {
                    8 => scalar.copy_from_slice(&value.to_ne_bytes()),
                    _ => scalar.copy_from_slice(&(*value as f32).to_ne_bytes()),
                }
            }
        }
    });
    debug_assert!(bytes.starts_with(&first));
    Ok(bytes)
}

/// A mesh that rays may start in: its bit in the set of regions, the object, and the corners of its box.
type ClosedMesh<'a> = (usize, &'a Object, (DVec3, DVec3));

fn closed_meshes<'a>(scene: &'a Scene, regions: &Regions) -> Vec<ClosedMesh<'a>> {
    let objects = regions.regions.iter().map(|region| &scene.objects[region.object]).enumerate();
    let meshes = objects.filter(|(_, object)| object.shape.mesh().is_some());
    meshes.map(|(bit, object)| (bit, object, object.bounds())).collect()
}

/// Returns the meshes that a ray starts in, as bits of the set of regions. The time of a test is proportional to the mesh's triangles.
fn starting_set(meshes: &[ClosedMesh], ray: &[f64; 6]) -> u32 {
    let x = DVec3::new(ray[0], ray[1], ray[2]);
    let near = |(lo, hi): &(DVec3, DVec3)| x.cmpge(*lo).all() && x.cmple(*hi).all();
    let inside = meshes.iter().filter(|(_, object, bounds)| near(bounds) && object.contains(x));
    inside.fold(0, |set, (bit, ..)| set | 1 << bit)
}

/// Returns a tile whose pixels represent chosen pixels of the image, like [`ray_tile`].
pub(super) fn pixel_tile(
    prepared: &Prepared,
    earlier: Option<Tile>,
    batch: &[[u32; 2]],
    row: u32,
) -> Result<(Tile, Sample), RenderError> {
    let tile = list_tile((prepared, earlier), batch.len(), row, &Role::Chosen, bytemuck::cast_slice(batch))?;
    Ok((tile, Sample::first(prepared.scene.image.size)))
}

/// Returns a tile with rows of `row` pixels, a list of their inputs, and space for their records.
fn list_tile(
    (prepared, earlier): (&Prepared, Option<Tile>),
    count: usize,
    row: u32,
    role: &Role,
    list: &[u8],
) -> Result<Tile, RenderError> {
    let width = row.min(count as u32).max(1);
    let size = [width, (count as u32).div_ceil(width).max(1)];
    let mut tile = prepared.tile_after(earlier, size)?;
    tile.add_input(prepared.gpu, role, list)?;
    let records = u64::from(prepared.layout(&Role::Records)?.span) * u64::from(size[0]) * u64::from(size[1]);
    tile.add_storage(prepared.gpu, &Role::Records, records)?;
    Ok(tile)
}

/// Appends the ends of rays to `traced`.
pub(super) fn read_records(
    prepared: &Prepared,
    tile: &Tile,
    count: usize,
    traced: &mut Vec<Traced>,
) -> Result<(), RenderError> {
    let records = Records::read(prepared.gpu, &prepared.program, tile, &Role::Records)?;
    let [status, x, v, tau, segments, steps, rejected, object] =
        ["status", "x", "v", "tau", "segments", "steps", "rejected", "object"].map(|name| records.field(name));
    let end = |row: Row| Traced {
        status: Status::from_code(row.word(status)),
        x: row.numbers(x),
        v: row.numbers(v),
        tau: row.numbers::<1>(tau)[0],
        segments: row.numbers::<1>(segments)[0],
        steps: row.word(steps),
        rejected: row.word(rejected),
        object: row.word(object).checked_sub(1),
    };
    traced.par_extend(records.par_rows().take(count).with_min_len(FEW).map(end));
    Ok(())
}

/// Returns the start and the status of each ray after the setup alone, which already determines the end of some rays.
pub(super) fn read_starts(
    prepared: &Prepared,
    tile: &Tile,
    count: usize,
) -> Result<Vec<(Status, PathPoint)>, RenderError> {
    let begun = |row: Row| {
        let start = PathPoint { x: row.vector("from_x"), v: row.vector("from_v"), tau: 0.0 };
        (Status::from_code(row.uint("status")), start)
    };
    Ok(Records::read(prepared.gpu, &prepared.program, tile, &Role::Records)?.rows().take(count).map(begun).collect())
}
