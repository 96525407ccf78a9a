//! What guides paths to light that no cone about a lamp leads to: light that mirrors and clear objects have sent on, or that the law bends.

use super::{Lamp, LightGrid, Scene};
use crate::model::Substance;

/// Light from a lamp that is followed before a picture, so that paths know where it comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// Where it comes from.
    pub lamp: Lamp,
    /// Which mirror or clear object it is sent to; all that leaves the lamp where space itself bends light.
    pub through: Option<usize>,
}

/// Beams, at most: each costs every vertex a few operations.
const MOST: usize = 8;
/// Paths of a beam.
const PATHS: std::ops::RangeInclusive<u64> = 1 << 12..=1 << 17;
/// Segments of a path of a beam: what goes round and round leaves its light on its first rounds.
const SEGMENTS: u32 = 256;
/// Those that come to a voxel by a surface, about.
const PATHS_A_VOXEL: f64 = 64.0;

impl Scene {
    /// The light that guides paths: the eight brightest beams, and none where cones about lamps lead to all light.
    #[must_use]
    pub fn beams(&self) -> Vec<Beam> {
        if !self.rays.paths.is_some_and(|paths| paths.guide) || self.law.facts().refuses_sent_light.is_some() {
            return Vec::new();
        }
        let lamps = self.lamps();
        let outside = |lamp: &Lamp, x: glam::DVec3| lamp.center.distance(x) > lamp.radius;
        let mut all: Vec<(f64, Beam)> = if self.law.facts().is_straight {
            let sends = |object: &super::Object| object.interior().is_some() || self.continues_from(object);
            let objects = || self.objects.iter().enumerate().filter(|(_, object)| sends(object));
            let beam = |lamp: &Lamp, (i, object): (usize, &super::Object)| {
                let (center, radius) = object.ball();
                let part = (radius / lamp.center.distance(center)).min(1.0);
                (lamp.power * part * part, Beam { lamp: *lamp, through: Some(i) })
            };
            let reached = |lamp: &Lamp, object: &super::Object| outside(lamp, object.ball().0);
            lamps.iter().flat_map(|lamp| objects().filter(|(_, o)| reached(lamp, o)).map(|o| beam(lamp, o))).collect()
        } else {
            let lit = |lamp: &&Lamp| self.camera.as_ref().is_none_or(|camera| outside(lamp, camera.position));
            lamps.iter().filter(lit).map(|lamp| (lamp.power, Beam { lamp: *lamp, through: None })).collect()
        };
        // The brightest first, and of equal ones the first in the file.
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        all.truncate(MOST);
        all.into_iter().map(|(_, beam)| beam).collect()
    }

    /// How finely their light is kept.
    #[must_use]
    pub fn guide_grid(&self) -> LightGrid {
        let [width, height] = self.image.size.map(u64::from);
        // One for each pixel: a small part of what a picture's own paths cost, and the same however many there are of those, so that a
        // picture can be gone on with.
        let paths = (width * height).clamp(*PATHS.start(), *PATHS.end());
        let voxels = ((paths as f64 / PATHS_A_VOXEL).sqrt() as u32).max(LightGrid::COARSEST.voxels);
        LightGrid { voxels, refine: 6, paths: paths as u32 }
    }

    /// What the beams' light is followed through: without lamps and paths, and without filters, for where light comes from is known without
    /// what is left of it.
    #[must_use]
    pub fn of_beams(&self) -> Self {
        let mut scene = self.clone();
        scene.rays.paths = None;
        scene.rays.max_segments = scene.rays.max_segments.min(SEGMENTS);
        scene.filter = None;
        for object in &mut scene.objects {
            if let Substance::Clear(interior) = &mut object.substance {
                interior.filter = None;
            }
        }
        let lamps: Vec<_> = self.lamps().iter().map(|lamp| lamp.object).collect();
        let mut places = 0..;
        scene.objects.retain(|_| places.next().is_some_and(|i| !lamps.contains(&i)));
        scene
    }

    /// What paths aim at: the parts of `shaders/path/aim` for it.
    #[must_use]
    pub fn aims(&self) -> Vec<&'static str> {
        let lamps = (!self.lamps().is_empty()).then_some("lamps");
        let guide = (!self.beams().is_empty()).then_some("guide");
        let sky = self.aims_at_sky().then_some("sky");
        lamps.into_iter().chain(guide).chain(sky).collect()
    }
}
