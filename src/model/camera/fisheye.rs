//! All rays start at the position; their angle from forward grows evenly with the distance from the picture's middle, to half of the
//! opening angle on the rim of a disk that touches the nearer edges.

use std::sync::Arc;

use glam::DVec2;

use super::{Kind, Projection};
use crate::document::keys;
use crate::document::values::{number_where, word};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "fisheye",
    keys: keys! {
        fov: "number above 0, up to 1000000" = "180",
            "opening angle of the image circle, in degrees; above 360, the view repeats";
        corners: "black | transparent" = "black", "area outside the image circle; transparent writes an alpha channel";
    },
    read: |table| {
        // Beyond that f32 has no place for the middle of a turn.
        let angle = number_where("an angle above 0 and up to 1000000 degrees", |x| x > 0.0 && x <= 1e6);
        let choices = &[("black", Corners::Black), ("transparent", Corners::Transparent)];
        let corners = table.or("corners", Corners::Black, word(choices));
        Some(Arc::new(Fisheye { fov: table.or("fov", 180.0, angle), corners }))
    },
};

/// By the angle from the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fisheye {
    /// Degrees, above 0: more than 360 goes round again.
    pub fov: f64,
    /// What is outside the disk.
    pub corners: Corners,
}

/// What a picture shows where its camera has no rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corners {
    /// Black.
    Black,
    /// Nothing: files then carry alpha.
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

    fn is_transparent(&self) -> bool {
        self.corners == Corners::Transparent
    }
}
