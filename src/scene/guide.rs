//! Path guiding to light that next-event estimation cannot reach, because mirrors, transparent objects or the law deflect it.

use super::{Emitter, LightGrid, Scene};
use crate::model::Substance;

/// A beam: light from an emitter that is traced before the image, so that paths learn the directions from which it arrives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    /// The emitter.
    pub emitter: Emitter,
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
        let emitters = self.emitters();
        let outside = |emitter: &Emitter, x: glam::DVec3| emitter.center.distance(x) > emitter.radius;
        let mut all: Vec<(f64, Beam)> = if self.law.facts().is_straight {
            let sends = |object: &super::Object| object.interior().is_some() || self.continues_from(object);
            let objects = || self.objects.iter().enumerate().filter(|(_, object)| sends(object));
            let beam = |emitter: &Emitter, (i, object): (usize, &super::Object)| {
                let (center, radius) = object.ball();
                let part = (radius / emitter.center.distance(center)).min(1.0);
                (emitter.power * part * part, Beam { emitter: *emitter, through: Some(i) })
            };
            let reached = |emitter: &Emitter, object: &super::Object| outside(emitter, object.ball().0);
            emitters
                .iter()
                .flat_map(|emitter| objects().filter(|(_, o)| reached(emitter, o)).map(|o| beam(emitter, o)))
                .collect()
        } else {
            let lit = |emitter: &&Emitter| self.camera.as_ref().is_none_or(|camera| outside(emitter, camera.position));
            emitters
                .iter()
                .filter(lit)
                .map(|emitter| (emitter.power, Beam { emitter: *emitter, through: None }))
                .collect()
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

    /// Returns the scene in which beams are traced, without emitters and paths, and without matter that absorbs, because the directions
    /// of light do not depend on it.
    #[must_use]
    pub fn of_beams(&self) -> Self {
        let mut scene = self.clone();
        scene.rays.path_tracing = None;
        scene.rays.max_segments = scene.rays.max_segments.min(SEGMENTS);
        scene.absorption = None;
        scene.volumes.clear();
        for object in &mut scene.objects {
            if let Substance::TransparentShadows(interior) = &mut object.substance {
                interior.absorption = None;
            }
        }
        let emitters: Vec<_> = self.emitters().iter().map(|emitter| emitter.object).collect();
        let mut places = 0..;
        scene.objects.retain(|_| places.next().is_some_and(|i| !emitters.contains(&i)));
        scene
    }

    /// Returns the modules of `shaders/path/light_sampling` for the targets of path guiding.
    #[must_use]
    pub fn aims(&self) -> Vec<&'static str> {
        let emitters = (!self.emitters().is_empty()).then_some("emitters");
        let guide = (!self.beams().is_empty()).then_some("guiding");
        let sky = self.aims_at_sky().then_some("sky");
        emitters.into_iter().chain(guide).chain(sky).collect()
    }
}
