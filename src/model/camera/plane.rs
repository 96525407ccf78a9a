//! The orthographic camera: rays start on a plane through the position, parallel to forward (a flow defines its own direction).

use std::sync::Arc;

use glam::DVec2;

use super::{Kind, Projection};
use crate::document::keys;
use crate::document::values::positive_length;

pub static KIND: Kind = Kind {
    name: "orthographic",
    keys: keys! { height: "number above 0" = "required", "height of the plane, scene units"; },
    read: |table| Some(Arc::new(Plane { height: table.required("height", "10", positive_length)? })),
};

/// The orthographic projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// The plane's height in scene units, above 0; its width follows from the aspect ratio of the image.
    pub height: f64,
}

impl Projection for Plane {
    fn part(&self) -> &'static str {
        "camera/plane"
    }

    fn half_view(&self, [width, height]: [f64; 2]) -> [f64; 2] {
        let half = 0.5 * self.height;
        [half * width / height, half]
    }

    fn pixel_angle(&self, _: [f64; 2]) -> Option<f64> {
        None
    }

    fn solid_angle(&self, _: [f64; 2], _: DVec2) -> Option<f64> {
        None
    }

    fn pixel_length(&self, [_, height]: [f64; 2], _: f64) -> Option<f64> {
        Some(self.height / height)
    }

    fn convergence_part(&self) -> &'static str {
        "camera/eyes/crossing_plane"
    }

    fn is_from_a_point(&self) -> bool {
        false
    }
}
