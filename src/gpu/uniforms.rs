//! The values of a scene's uniforms, by the names of their members in WGSL.

use glam::DVec3;

use super::source::Source;
use crate::model::Value::{self, Float, Uint, Uint2, Uint4, Vec3};
use crate::scene::{Clear, Scene, Sky};

impl Source<'_> {
    pub(super) fn refinement(&self) -> Vec<(&'static str, Value)> {
        let Scene { image, output, .. } = self.scene;
        vec![
            ("tolerance", Float(image.adaptive.unwrap_or(0.0))),
            ("most", Uint(image.samples)),
            ("gain", Float(output.exposure.exp2())),
        ]
    }

    /// How far ambient light comes from: from all around, if no less.
    pub(super) fn ambient(&self) -> [(&'static str, Value); 3] {
        let occlusion = self.scene.occlusion.as_ref();
        let along_law = occlusion.is_some_and(|occlusion| occlusion.along_law);
        // Paths may go round before they leave.
        let across = if along_law { f64::from(f32::MAX) } else { 2.0 * self.scene.rays.bound.radius };
        let distance = occlusion.and_then(|occlusion| occlusion.distance).unwrap_or(across);
        let floor = occlusion.map_or(0.0, |occlusion| occlusion.floor);
        let shadows = self.shadow_code(occlusion.map_or(Clear::Open, |occlusion| occlusion.clear));
        [("distance", Float(distance)), ("floor", Float(floor)), ("shadows", Uint(shadows))]
    }

    /// How far paths go.
    pub(super) fn transport(&self) -> [(&'static str, Value); 3] {
        let paths = self.scene.rays.paths.unwrap_or_default();
        let depth = paths.depth.unwrap_or(u32::MAX);
        [("depth", Uint(depth)), ("roulette", Uint(paths.roulette)), ("seed", Uint(paths.seed))]
    }
}

/// The members of `sky`.
pub(super) fn sky_values(sky: &Sky) -> Vec<(&'static str, Value)> {
    match sky {
        Sky::Color(color) => vec![("color", Vec3(*color))],
        Sky::Transparent => vec![("color", Vec3(DVec3::ZERO))],
        Sky::Equirectangular(image, intensity) => {
            vec![("intensity", Float(*intensity)), ("image", Uint(*image as u32))]
        }
        Sky::Faces(faces, intensity) => {
            let f = faces.map(|face| face as u32);
            vec![
                ("faces", Uint4([f[0], f[1], f[2], f[3]])),
                ("more_faces", Uint2([f[4], f[5]])),
                ("intensity", Float(*intensity)),
            ]
        }
    }
}

/// The members of `schedule`.
#[must_use]
pub fn schedule_values(max_segments: u32, segments: u32) -> [(&'static str, Value); 2] {
    // Where no mask holds an ended ray back it runs on to the end of the pass: no further than a path may go.
    let segments = segments.min(max_segments);
    [("max_segments", Uint(max_segments)), ("segments", Uint(segments))]
}
