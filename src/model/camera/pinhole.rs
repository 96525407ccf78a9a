//! The pinhole camera: all rays start at the position, with a perspective projection.

use std::sync::Arc;

use super::{Kind, Projection};
use crate::document::keys;
use crate::document::values::number_where;

pub static KIND: Kind = Kind {
    name: "pinhole",
    keys: keys! { fov: "number between 0 and 180" = "50", "vertical opening angle, degrees"; },
    read: |table| {
        let angle = number_where("an angle between 0 and 180 degrees", |x| x > 0.0 && x < 180.0);
        Some(Arc::new(Pinhole { fov: table.or("fov", 50.0, angle) }))
    },
};

/// The perspective projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pinhole {
    /// The vertical opening angle in degrees, in (0, 180).
    pub fov: f64,
}

impl Projection for Pinhole {
    fn part(&self) -> &'static str {
        "camera/pinhole"
    }

    fn half_view(&self, [width, height]: [f64; 2]) -> [f64; 2] {
        let half = (0.5 * self.fov).to_radians().tan();
        [half * width / height, half]
    }

    fn pixel_angle(&self, [_, height]: [f64; 2]) -> Option<f64> {
        Some(2.0 * (0.5 * self.fov).to_radians().tan() / height)
    }

    fn convergence_part(&self) -> &'static str {
        "camera/eyes/crossing_plane"
    }
}
