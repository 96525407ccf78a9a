//! A light's grid (G95 §6): the voxels about what it lights, and what its light is in each.
//!
//! *Theory.* A path that carries the flux Φ over the length ℓ through a voxel of side h adds Φℓ/h³ along itself to the light vector F
//! there, and as much to the fluence φ. A surface receives −F·n (Gershun's light field), however many paths come to it, as long as all
//! come from its front. |F|/φ is 1 where they have one direction, and less where several meet.
//!
//! *Practice.* A voxel that disagrees with its neighbours, in direction or in brightness, is cut into a brick of smaller ones: there are
//! caustics, shadows' edges and surfaces. What is smooth stays coarse.

use glam::{DVec3, IVec3, UVec3, Vec4};
use rayon::prelude::*;

use crate::model::{Row, row};
use crate::scene::{Object, Scene};

/// Voxels on each side of what is lit, so that there are some about every place where light is looked for.
const MARGIN: u32 = 2;
/// Of the brightest around: neighbours whose light differs by more are unlike.
const UNLIKE: f32 = 0.4;
/// Of a voxel's own light: neighbours that differ by less are alike.
const ALIKE: f32 = 0.2;
/// Paths through a part of a voxel, at least: of fewer it would show no more than their noise.
const PATHS: f64 = 12.0;

/// Cubes in a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightVolume {
    /// The lower corner.
    pub lo: DVec3,
    /// A voxel's side.
    pub h: f64,
    /// Voxels along each axis.
    pub count: [u32; 3],
}

impl LightVolume {
    /// About all that shows lights and lies in the bounding sphere, with so many voxels along the longest side.
    #[must_use]
    pub fn new(scene: &Scene, voxels: u32) -> Self {
        let lit = |object: &&Object| scene.material_of(object).is_some_and(|material| material.surface.facts().is_lit);
        let boxes = scene.objects.iter().filter(lit).map(Object::bounds);
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (lo, hi) = boxes.fold(nothing, |all, own| (all.0.min(own.0), all.1.max(own.1)));
        let bound = &scene.rays.bound;
        let (lo, hi) = (lo.max(bound.center - bound.radius), hi.min(bound.center + bound.radius));
        let extent = if lo.cmple(hi).all() { hi - lo } else { DVec3::ZERO };
        let longest = if extent.max_element() > 0.0 { extent.max_element() } else { bound.radius };
        let h = longest / f64::from(voxels.saturating_sub(2 * MARGIN).max(1));
        // Rounding adds no voxel.
        let count = (extent / h - 1e-9).ceil().max(DVec3::ZERO).as_uvec3() + 2 * MARGIN;
        Self { lo: 0.5 * (lo + hi - h * count.as_dvec3()), h, count: count.to_array() }
    }

    /// The number of a voxel, or of that on the rim which is next to it.
    fn voxel(&self, at: IVec3) -> usize {
        let [nx, ny, nz] = self.count.map(u32::cast_signed);
        let at = at.clamp(IVec3::ZERO, IVec3::new(nx, ny, nz) - 1);
        ((at.z * ny + at.y) * nx + at.x) as usize
    }

    /// How many there are.
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

/// What a light's light is in each voxel.
#[derive(Debug, Clone, PartialEq)]
pub struct LightField {
    /// Where the voxels are.
    pub volume: LightVolume,
    /// Parts along each axis of a voxel that is a brick.
    pub refine: u32,
    /// For each voxel the number of its brick, from 1, or 0.
    pub bricks: Vec<u32>,
    /// F and φ, first of the voxels, then of the bricks' parts.
    pub field: Vec<Vec4>,
}

impl LightField {
    /// Without bricks, of these values for each voxel.
    #[must_use]
    pub fn new(volume: LightVolume, refine: u32, voxels: &[Vec4]) -> Self {
        let bricks = vec![0; volume.voxels()];
        Self { volume, refine, bricks, field: smooth(voxels, volume.count) }
    }

    /// The numbers of `LightSums` as light: `sums` are those of `flux`, in voxels of side h.
    #[must_use]
    pub fn values(sums: &[[f64; 4]], flux: f64, h: f64, unit: f64) -> Vec<Vec4> {
        let scale = flux / (unit * h * h);
        sums.iter().map(|sum| Vec4::from_array(sum.map(|n| (n * scale) as f32))).collect()
    }

    /// As what guides paths. Where none came there is what lies around, or in the voxel of the part. And so much more fluence of no direction
    /// wherever there is any: of few paths it is not known how far apart their directions are.
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

    /// F and φ at a place that no surface is near: between the middles of voxels, or of parts where its own is in parts. None outside
    /// of the voxels.
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

    /// Of a part, each voxel cut into `cut` along each axis, or of all of a voxel that is not in parts.
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

    /// What it takes on the device while a picture is made.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (size_of_val(&self.bricks[..]) + size_of_val(&self.field[..])) as u64
    }

    /// Adds bricks for some voxels, of these values for each part.
    pub fn cut(&mut self, bricks: Vec<u32>, parts: &[Vec4]) {
        let count = [self.refine; 3];
        self.field.extend(parts.chunks(self.refine.pow(3) as usize).flat_map(|brick| smooth(brick, count)));
        self.bricks = bricks;
    }

    /// Voxels in which light is so unlike that of a neighbour that they are worth cutting, where so many paths as carry `flux` each come
    /// through a part: the most unlike first, and of two alike the first one.
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

    /// The members of `GridLight` in `shaders/surface/light/field.wgsl` that say where it lies: before its own there are so many voxels and
    /// values of others.
    #[must_use]
    pub(super) fn row(&self, first_brick: usize, first: usize) -> Row {
        let own = row! { first_brick: Uint(first_brick as u32), first: Uint(first as u32) };
        [self.volume.row(self.refine), own].concat()
    }
}

/// Bytes on the device of `voxels` in which light is left and of as many in which it lies ready.
#[must_use]
pub fn light_bytes(voxels: u64) -> u64 {
    voxels * (4 * size_of::<u32>() + size_of::<Vec4>() + size_of::<u32>()) as u64
}

/// Those that differ by at most one along each axis from one of so many voxels, with itself.
fn around(count: [u32; 3], voxel: usize) -> impl Iterator<Item = usize> {
    let [nx, ny, nz] = count.map(|n| n as usize);
    let (x, y, z) = (voxel % nx, voxel / nx % ny, voxel / nx / ny);
    let range = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
    range(z, nz).flat_map(move |z| range(y, ny).flat_map(move |y| range(x, nx).map(move |x| (z * ny + y) * nx + x)))
}

/// Each voxel with those next to it that are alike: of what paths happened to come through it less noise is left, and edges stay.
fn smooth(field: &[Vec4], count: [u32; 3]) -> Vec<Vec4> {
    let mean = |voxel: usize| {
        let own = field[voxel];
        let alike = around(count, voxel).map(|i| field[i]).filter(|f| f.distance(own) <= ALIKE * own.w);
        let (sum, count) = alike.fold((Vec4::ZERO, 0.0), |(sum, count), f| (sum + f, count + 1.0));
        sum / count
    };
    (0..field.len()).into_par_iter().map(mean).collect()
}
