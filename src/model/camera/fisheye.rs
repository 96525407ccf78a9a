//! The fisheye camera. All rays start at the position, and their angle from forward grows linearly with the distance from the image center,
//! up to half of the opening angle on the rim of a disk that touches the nearer edges.

use std::sync::Arc;

use glam::DVec2;

use super::{Kind, Projection};
use crate::document::keys;
use crate::document::values::{angle, fitting, word};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "fisheye",
    keys: keys! {
        fov: "number above 0, up to 1000000" = "180",
            "opening angle of the image circle, in degrees; above 360, the view repeats";
        corners: "black | transparent" = "black", "area outside the image circle; transparent writes an alpha channel";
    },
    read: |table| {
        // Beyond that, f32 cannot resolve a fraction of a turn.
        let angle = fitting(angle, "an angle above 0 and up to 1000000 degrees", |x| x > 0.0 && x <= 1e6);
        let choices = &[("black", Corners::Black), ("transparent", Corners::Transparent)];
        let corners = table.or("corners", Corners::Black, word(choices));
        Some(Arc::new(Fisheye { fov: table.or("fov", 180.0, angle), corners }))
    },
};

/// The equidistant fisheye projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fisheye {
    /// The opening angle in degrees, in (0, 10⁶]; more than 360 shows directions repeatedly.
    pub fov: f64,
    /// The content outside the disk.
    pub corners: Corners,
}

/// The content of an image where its camera has no rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corners {
    /// Black pixels.
    Black,
    /// Transparent pixels; the image file then has an alpha channel.
    Transparent,
}

impl Projection for Fisheye {
    fn part(&self) -> &'static str {
        "camera/fisheye"
    }

    fn half_view(&self, _: [f64; 2]) -> [f64; 2] {
        [1.0; 2]
    }

    fn values(&self, [width, height]: [f64; 2]) -> Row {
        row! { sides: Vec2(DVec2::new(width, height) / width.min(height)), quarters: Float(self.fov / 180.0) }
    }

    fn pixel_angle(&self, [width, height]: [f64; 2]) -> Option<f64> {
        Some(self.fov.to_radians() / width.min(height))
    }

    fn solid_angle(&self, [width, height]: [f64; 2], point: DVec2) -> Option<f64> {
        let angle = (point * DVec2::new(width, height) / width.min(height)).length() * 0.5 * self.fov.to_radians();
        let ratio = if angle == 0.0 { 1.0 } else { angle.sin().abs() / angle };
        Some(self.pixel_angle([width, height])?.powi(2) * ratio)
    }

    fn is_transparent(&self) -> bool {
        self.corners == Corners::Transparent
    }
}
