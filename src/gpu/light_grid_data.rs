//! Stores the photon grid of a light (G95 §6): voxels around the lit objects, and the light in each.
//!
//! *Theory.* A path that carries the flux Φ over the length ℓ through a voxel of side h adds Φℓ/h³ along its direction to the light vector
//! F there, and Φℓ/h³ to the fluence φ. A surface receives −F·n (Gershun, the light field), however many paths reach it, if all come from
//! its front. |F|/φ is 1 if they have one direction, and less if several directions meet.
//!
//! *Practice.* A voxel whose light differs from its neighbors in direction or brightness is refined into a brick of smaller voxels; this
//! happens at caustics, shadow edges and surfaces. Smooth regions stay coarse.

use glam::{DVec3, IVec3, UVec3, Vec4};
use rayon::prelude::*;

use crate::model::{Row, row};
use crate::scene::{Object, Scene};

/// The number of voxels added on each side of the lit box, so that every lit position has neighbors.
const MARGIN: u32 = 2;
/// The difference from a neighbor above which a voxel is refined, as a fraction of the brightest light around it.
const UNLIKE: f32 = 0.4;
/// The difference from a neighbor below which both are averaged, as a fraction of the voxel's own fluence.
const ALIKE: f32 = 0.2;
/// The minimum number of paths through a subvoxel; with fewer it would show only noise.
const PATHS: f64 = 12.0;

/// A grid of cubic voxels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightVolume {
    /// The lower corner.
    pub lo: DVec3,
    /// The side of a voxel.
    pub h: f64,
    /// The number of voxels along each axis.
    pub count: [u32; 3],
}

impl LightVolume {
    /// Creates a volume around all lit objects inside the bounding sphere, with `voxels` voxels along the longest side.
    #[must_use]
    pub fn new(scene: &Scene, voxels: u32) -> Self {
        let lit = |object: &&Object| scene.material_of(object).is_some_and(|material| material.surface.facts().is_lit);
        let boxes = scene.objects.iter().filter(lit).map(Object::bounds);
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (lo, hi) = boxes.fold(nothing, |all, own| (all.0.min(own.0), all.1.max(own.1)));
        let bound = &scene.rays.bounding_sphere;
        let (lo, hi) = (lo.max(bound.center - bound.radius), hi.min(bound.center + bound.radius));
        let extent = if lo.cmple(hi).all() { hi - lo } else { DVec3::ZERO };
        let longest = if extent.max_element() > 0.0 { extent.max_element() } else { bound.radius };
        let h = longest / f64::from(voxels.saturating_sub(2 * MARGIN).max(1));
        // Do not let rounding add a voxel.
        let count = (extent / h - 1e-9).ceil().max(DVec3::ZERO).as_uvec3() + 2 * MARGIN;
        Self { lo: 0.5 * (lo + hi - h * count.as_dvec3()), h, count: count.to_array() }
    }

    /// Returns the index of a voxel; positions outside are clamped to the rim.
    fn voxel(&self, at: IVec3) -> usize {
        let [nx, ny, nz] = self.count.map(u32::cast_signed);
        let at = at.clamp(IVec3::ZERO, IVec3::new(nx, ny, nz) - 1);
        ((at.z * ny + at.y) * nx + at.x) as usize
    }

    /// Returns the number of voxels.
    #[must_use]
    pub fn voxels(&self) -> usize {
        self.count.iter().map(|n| *n as usize).product()
    }

    /// The members of `LightVolume` in `shaders/segment/leave_light.wgsl`.
    #[must_use]
    pub fn row(&self, refine: u32) -> Row {
        row! { lo: Vec3(self.lo), h: Float(self.h), count: Uint3(self.count), refine: Uint(refine) }
    }
}

/// The light of one source in each voxel.
#[derive(Debug, Clone, PartialEq)]
pub struct LightGridData {
    /// The positions of the voxels.
    pub volume: LightVolume,
    /// The number of subvoxels along each axis of a brick.
    pub refine: u32,
    /// The number of each voxel's brick, counted from 1, or 0.
    pub bricks: Vec<u32>,
    /// F and φ, first of the voxels, then of the bricks' subvoxels.
    pub field: Vec<Vec4>,
}

impl LightGridData {
    /// Creates a field without bricks from the values of the voxels.
    #[must_use]
    pub fn new(volume: LightVolume, refine: u32, voxels: &[Vec4]) -> Self {
        let bricks = vec![0; volume.voxels()];
        Self { volume, refine, bricks, field: smooth(voxels, volume.count) }
    }

    /// Converts the numbers of `LightSums` to light: `sums` come from paths that carry `flux`, in voxels of side h.
    #[must_use]
    pub fn values(sums: &[[f64; 4]], flux: f64, h: f64, unit: f64) -> Vec<Vec4> {
        let scale = flux / (unit * h * h);
        sums.iter().map(|sum| Vec4::from_array(sum.map(|n| (n * scale) as f32))).collect()
    }

    /// Prepares the grid for path guiding: fills empty voxels from their neighbors and empty subvoxels from their voxel, and adds
    /// isotropic fluence (`voxels`, `parts`), because directions estimated from few paths are uncertain.
    #[must_use]
    pub fn guiding(mut self, voxels: f32, parts: f32) -> Self {
        let count = self.volume.voxels();
        let near = |voxel: usize| around(self.volume.count, voxel).map(|i| self.field[i]).sum::<Vec4>() / 27.0;
        let spread = |voxel: usize| if self.field[voxel] == Vec4::ZERO { near(voxel) } else { self.field[voxel] };
        let coarse: Vec<Vec4> = (0..count).map(spread).collect();
        let each = self.refine.pow(3) as usize;
        for (voxel, brick) in self.bricks.iter().enumerate().filter(|(_, brick)| **brick != 0) {
            let first = count + (*brick as usize - 1) * each;
            for part in self.field[first..first + each].iter_mut().filter(|part| **part == Vec4::ZERO) {
                *part = coarse[voxel];
            }
        }
        self.field[..count].copy_from_slice(&coarse);
        for (i, value) in self.field.iter_mut().enumerate().filter(|(_, value)| value.w > 0.0) {
            value.w += if i < count { voxels } else { parts };
        }
        self
    }

    /// Returns F and φ at a position away from surfaces, interpolated between the centers of voxels, or of subvoxels in a brick; `None`
    /// outside of the volume.
    #[must_use]
    pub fn at(&self, x: DVec3) -> Option<Vec4> {
        let place = (x - self.volume.lo) / self.volume.h;
        let count = UVec3::from_array(self.volume.count).as_dvec3();
        if !(place.cmpge(DVec3::ZERO).all() && place.cmple(count).all()) {
            return None;
        }
        let own = self.volume.voxel(place.floor().as_ivec3());
        let cut = if self.bricks[own] == 0 { 1 } else { self.refine };
        let at = place * f64::from(cut) - 0.5;
        let (corner, part) = (at.floor().as_ivec3(), (at - at.floor()).as_vec3());
        let corners = (0..8).map(|k| IVec3::new(k & 1, k >> 1 & 1, k >> 2));
        Some(corners.fold(Vec4::ZERO, |sum, by| {
            let shares = (1.0 - part) + by.as_vec3() * (2.0 * part - 1.0);
            sum + shares.element_product() * self.value(corner + by, cut)
        }))
    }

    /// Returns the value of a subvoxel, if each voxel is cut into `cut` along each axis, or of the whole voxel if it has no brick.
    fn value(&self, part: IVec3, cut: u32) -> Vec4 {
        let n = cut.cast_signed();
        let voxel = part.div_euclid(IVec3::splat(n));
        let own = self.volume.voxel(voxel);
        if cut == 1 || self.bricks[own] == 0 {
            return self.field[own];
        }
        let fine = part - n * voxel;
        let brick = (self.bricks[own] - 1) * cut.pow(3);
        self.field[self.volume.voxels() + (brick.cast_signed() + (fine.z * n + fine.y) * n + fine.x) as usize]
    }

    /// Returns the size of the field on the device during a render, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (size_of_val(&self.bricks[..]) + size_of_val(&self.field[..])) as u64
    }

    /// Adds bricks for some voxels, with the values of their subvoxels.
    pub fn cut(&mut self, bricks: Vec<u32>, parts: &[Vec4]) {
        let count = [self.refine; 3];
        self.field.extend(parts.chunks(self.refine.pow(3) as usize).flat_map(|brick| smooth(brick, count)));
        self.bricks = bricks;
    }

    /// Returns the voxels whose light differs so much from a neighbor that they are worth refining, if enough paths of `flux` each cross a
    /// subvoxel. The largest difference comes first, and the lower index if two are equal.
    #[must_use]
    pub fn worth_cutting(&self, flux: f64) -> Vec<u32> {
        let part = self.volume.h / f64::from(self.refine);
        let enough = (PATHS * flux / (part * part)) as f32;
        let unlike = |voxel: usize| {
            let (mut most, mut apart) = (0.0_f32, 0.0_f32);
            for i in around(self.volume.count, voxel) {
                most = most.max(self.field[i].w);
                apart = apart.max(self.field[i].distance(self.field[voxel]));
            }
            (most > enough && apart > UNLIKE * most).then_some(apart)
        };
        let mut all: Vec<(f32, u32)> =
            (0..self.volume.voxels()).filter_map(|voxel| Some((unlike(voxel)?, voxel as u32))).collect();
        all.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        all.into_iter().map(|(_, voxel)| voxel).collect()
    }

    /// Returns the members of `GridLight` in `shaders/surface/light/field.wgsl` that locate this field; `first_brick` voxels and `first`
    /// values of other fields precede its own.
    #[must_use]
    pub(super) fn row(&self, first_brick: usize, first: usize) -> Row {
        let own = row! { first_brick: Uint(first_brick as u32), first: Uint(first as u32) };
        [self.volume.row(self.refine), own].concat()
    }
}

/// Returns the bytes on the device for `voxels` voxels: the sums that paths add to, and the finished values.
#[must_use]
pub fn light_bytes(voxels: u64) -> u64 {
    voxels * (4 * size_of::<u32>() + size_of::<Vec4>() + size_of::<u32>()) as u64
}

/// Returns the voxels that differ by at most one along each axis from `voxel`, including itself.
fn around(count: [u32; 3], voxel: usize) -> impl Iterator<Item = usize> {
    let [nx, ny, nz] = count.map(|n| n as usize);
    let (x, y, z) = (voxel % nx, voxel / nx % ny, voxel / nx / ny);
    let range = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
    range(z, nz).flat_map(move |z| range(y, ny).flat_map(move |y| range(x, nx).map(move |x| (z * ny + y) * nx + x)))
}

/// Averages each voxel with similar neighbors, which reduces the noise of the paths and preserves edges.
fn smooth(field: &[Vec4], count: [u32; 3]) -> Vec<Vec4> {
    let mean = |voxel: usize| {
        let own = field[voxel];
        let alike = around(count, voxel).map(|i| field[i]).filter(|f| f.distance(own) <= ALIKE * own.w);
        let (sum, count) = alike.fold((Vec4::ZERO, 0.0), |(sum, count), f| (sum + f, count + 1.0));
        sum / count
    };
    (0..field.len()).into_par_iter().map(mean).collect()
}
