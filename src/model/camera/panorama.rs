//! The panorama camera. All rays start at the position, and longitude runs to the right and latitude upwards, as in an equirectangular sky.

use std::sync::Arc;

use glam::DVec2;

use super::{Kind, Projection};
use crate::document::values::{Parsed, array, positive_angle};
use crate::document::{Node, keys};
use crate::model::{Row, row};

pub static KIND: Kind = Kind {
    name: "panorama",
    keys: keys! {
        fov: "[across, upwards], up to [360, 180]" = "[360, 180]",
            "opening angles, in degrees; the full sphere has the layout of an equirectangular sky";
    },
    read: |table| Some(Arc::new(Panorama { fov: table.or("fov", [360.0, 180.0], sides) })),
};

/// Reads the horizontal and vertical opening angles.
fn sides(node: &Node) -> Parsed<[f64; 2]> {
    let angles: [f64; 2] = array("two angles in degrees, [across, upwards]", positive_angle)(node)?;
    if angles[0] > 360.0 || angles[1] > 180.0 {
        let problem = format!("expected angles of up to [360, 180] degrees, found {angles:?}");
        return Err(node.fault(problem, "the full sphere is 360 by 180 degrees"));
    }
    Ok(angles)
}

/// The equirectangular projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Panorama {
    /// The opening angles in degrees, horizontal in (0, 360] and vertical in (0, 180].
    pub fov: [f64; 2],
}

impl Projection for Panorama {
    fn part(&self) -> &'static str {
        "camera/panorama"
    }

    fn half_view(&self, _: [f64; 2]) -> [f64; 2] {
        [1.0; 2]
    }

    fn values(&self, _: [f64; 2]) -> Row {
        row! { quarters: Vec2(DVec2::from(self.fov) / 180.0) }
    }

    fn solid_angle(&self, [width, height]: [f64; 2], point: DVec2) -> Option<f64> {
        let [across, upwards] = self.fov.map(f64::to_radians);
        let half = 0.5 * upwards / height;
        let latitude = 0.5 * upwards * point.y;
        Some(across / width * ((latitude + half).sin() - (latitude - half).sin()))
    }

    fn pixel_angle(&self, [width, height]: [f64; 2]) -> Option<f64> {
        let [across, upwards] = self.fov;
        Some((across / width).min(upwards / height).to_radians())
    }
}
