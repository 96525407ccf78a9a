//! Path guiding to light that next-event estimation cannot reach, because mirrors, transparent objects or the law deflect it.

use super::{Lamp, LightGrid, Scene};
use crate::model::Substance;

/// A beam: light from an emitter that is traced before the image, so that paths learn the directions from which it arrives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// The emitter.
    pub lamp: Lamp,
    /// The index of the mirror or transparent object that the beam passes; `None` for all light of the emitter where space bends light.
    pub through: Option<usize>,
}

/// The largest number of beams, because each adds a few operations to every vertex.
const MOST: usize = 8;
/// The number of paths of a beam.
const PATHS: std::ops::RangeInclusive<u64> = 1 << 12..=1 << 17;
/// The largest number of segments of a beam's path; light that circulates is recorded on its first rounds.
const SEGMENTS: u32 = 256;
/// The approximate number of paths per voxel with a surface.
const PATHS_A_VOXEL: f64 = 64.0;

impl Scene {
    /// Returns up to eight of the brightest beams; empty if next-event estimation reaches all light.
    #[must_use]
    pub fn beams(&self) -> Vec<Beam> {
        if !self.rays.path_tracing.is_some_and(|paths| paths.guiding) || self.law.facts().refuses_sent_light.is_some() {
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
        // Sorted by brightness; beams of equal brightness stay in the order of the file.
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        all.truncate(MOST);
        all.into_iter().map(|(_, beam)| beam).collect()
    }

    /// Returns the resolution of the beams' light grids.
    #[must_use]
    pub fn guide_grid(&self) -> LightGrid {
        let [width, height] = self.image.size.map(u64::from);
        // One path per pixel costs little compared with the image. The number does not depend on the samples, so that a render can be
        // resumed.
        let paths = (width * height).clamp(*PATHS.start(), *PATHS.end());
        let voxels = ((paths as f64 / PATHS_A_VOXEL).sqrt() as u32).max(LightGrid::COARSEST.voxels);
        LightGrid { voxels, refine: 6, paths: paths as u32 }
    }

    /// Returns the scene in which beams are traced, without emitters and paths, and without absorption, because the directions of light do
    /// not depend on it.
    #[must_use]
    pub fn of_beams(&self) -> Self {
        let mut scene = self.clone();
        scene.rays.path_tracing = None;
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

    /// Returns the modules of `shaders/path/light_sampling` for the targets of path guiding.
    #[must_use]
    pub fn aims(&self) -> Vec<&'static str> {
        let lamps = (!self.lamps().is_empty()).then_some("emitters");
        let guide = (!self.beams().is_empty()).then_some("guiding");
        let sky = self.aims_at_sky().then_some("sky");
        lamps.into_iter().chain(guide).chain(sky).collect()
    }
}
