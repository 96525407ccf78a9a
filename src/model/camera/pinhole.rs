//! The pinhole camera: all rays start at the position, with a perspective projection.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{Kind, Projection};
use crate::document::reader::TableReader;
use crate::document::values::{angle, fitting, length, point};
use crate::document::{Dimension, Value, keys};

pub static KIND: Kind = Kind {
    name: "pinhole",
    keys: keys! {
        fov: "number between 0 and 180" = "50",
            "vertical opening angle, in degrees; an angle on the sky, such as \"60 uas\", is the height of the image as seen from units.distance";
    },
    read: |table| Some(Arc::new(Pinhole { fov: fov(table) })),
};

/// Reads the opening angle, or the angle at the distance of the scene that the image covers around `look_at`.
fn fov(table: &TableReader) -> f64 {
    let on_sky = table.node("fov").filter(|node| match &node.value {
        Value::Quantity(read) => read.dimension == Dimension::SkyAngle,
        _ => false,
    });
    let Some(node) = on_sky else {
        let angle = fitting(angle, "an angle between 0 and 180 degrees", |x| x > 0.0 && x < 180.0);
        return table.or("fov", 50.0, angle);
    };
    let place = |key| table.node(key).and_then(|node| point(node).ok());
    let Some(position) = place("position") else {
        let help = "use degrees here, as with a worldline";
        table.fault(&["fov"], "an angle on the sky requires the position of the camera", help);
        return 50.0;
    };
    let distance = position.distance(place("look_at").unwrap_or(DVec3::ZERO));
    let height = table.reader.accept(fitting(length, "an angle above 0", |x| x > 0.0)(node));
    height.map_or(50.0, |height| 2.0 * (0.5 * height / distance).atan().to_degrees())
}

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

    fn solid_angle(&self, pixels: [f64; 2], point: DVec2) -> Option<f64> {
        let slope = point * DVec2::from(self.half_view(pixels));
        Some(self.pixel_angle(pixels)?.powi(2) * (1.0 + slope.length_squared()).powf(-1.5))
    }

    fn pixel_length(&self, pixels: [f64; 2], distance: f64) -> Option<f64> {
        Some(self.pixel_angle(pixels)? * distance)
    }

    fn convergence_part(&self) -> &'static str {
        "camera/eyes/crossing_plane"
    }
}
