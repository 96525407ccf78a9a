//! The values of a scene's uniforms, by the names of their members in WGSL.

use super::source::Source;
use glam::DVec2;

use super::records::Value::{self, Float, Uint, Uint2, Uint4, Vec2, Vec3};
use crate::program::Work;
use crate::scene::{CameraKind, Control, FlowField, Law, Scene, Sky};

impl Source<'_> {
    pub(super) fn camera(&self) -> Vec<(&'static str, Value)> {
        let Some(camera) = &self.scene.camera else { return Vec::new() };
        let [width, height] = camera.view_size(self.scene.image.size).map(f64::from);
        let to_edges = |half: f64| [half * width / height, half];
        let ([right, up], own) = match camera.kind {
            CameraKind::Pinhole { fov } => (to_edges((0.5 * fov).to_radians().tan()), Vec::new()),
            CameraKind::Plane { height } => (to_edges(0.5 * height), Vec::new()),
            CameraKind::Fisheye { fov, .. } => {
                let sides = DVec2::new(width, height) / width.min(height);
                ([1.0; 2], vec![("sides", Vec2(sides)), ("quarters", Float(fov / 180.0))])
            }
            CameraKind::Panorama { fov } => ([1.0; 2], vec![("quarters", Vec2(DVec2::from(fov) / 180.0))]),
        };
        let axes = [
            ("position", Vec3(camera.position)),
            ("forward", Vec3(camera.forward)),
            ("right", Vec3(camera.right * right)),
            ("up", Vec3(camera.up * up)),
        ];
        axes.into_iter().chain(own).collect()
    }

    pub(super) fn stereo(&self) -> Vec<(&'static str, Value)> {
        let Some((camera, stereo)) = self.scene.camera.as_ref().and_then(|c| Some((c, c.stereo?))) else {
            return Vec::new();
        };
        let offset = ("offset", Vec3(0.5 * stereo.separation * camera.right));
        [offset].into_iter().chain(stereo.convergence.map(|distance| ("distance", Float(distance)))).collect()
    }

    pub(super) fn law(&self) -> Vec<(&'static str, Value)> {
        match &self.scene.law {
            Law::Schwarzschild { mass, center, .. } => vec![("center", Vec3(*center)), ("mass", Float(*mass))],
            Law::Flow { field: FlowField::Lorenz { sigma, rho, beta }, .. } => {
                vec![("sigma", Float(*sigma)), ("rho", Float(*rho)), ("beta", Float(*beta))]
            }
            Law::Flow { field: FlowField::Rossler { alpha, beta, gamma }, .. } => {
                vec![("alpha", Float(*alpha)), ("beta", Float(*beta)), ("gamma", Float(*gamma))]
            }
            Law::Straight | Law::Sources(_) | Law::Medium(_) => Vec::new(),
        }
    }

    pub(super) fn refinement(&self) -> Vec<(&'static str, Value)> {
        let Scene { image, output, .. } = self.scene;
        vec![
            ("tolerance", Float(image.adaptive.unwrap_or(0.0))),
            ("most", Uint(image.samples)),
            ("gain", Float(output.exposure.exp2())),
        ]
    }

    pub(super) fn sky(&self) -> Vec<(&'static str, Value)> {
        match &self.scene.sky {
            Sky::Color(color) => vec![("color", Vec3(*color))],
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
}

/// The members of `schedule`.
#[must_use]
pub fn schedule_values(max_segments: u32, segments: u32, work: &Work) -> [(&'static str, Value); 3] {
    // Where no mask holds an ended ray back it runs on to the end of the pass: no further than a path may go.
    let segments = segments.min(max_segments);
    [("max_segments", Uint(max_segments)), ("segments", Uint(segments)), ("segment_work", Uint(work.segment as u32))]
}

/// The members of `control`.
#[must_use]
pub fn control_values(control: Control) -> Vec<(&'static str, Value)> {
    match control {
        Control::Exact => Vec::new(),
        Control::Fixed { step, eta } => vec![("step", Float(step)), ("eta", Float(eta))],
        Control::Curvature { turn, eta } => vec![("turn", Float(turn)), ("eta", Float(eta))],
        Control::Embedded { tolerance, eta } => vec![("tolerance", Float(tolerance)), ("eta", Float(eta))],
        Control::Scaled { eta } => vec![("eta", Float(eta))],
        Control::Doubling { tolerance, grow_below, eta, .. } => {
            vec![("tolerance", Float(tolerance)), ("grow_below", Float(grow_below)), ("eta", Float(eta))]
        }
    }
}
