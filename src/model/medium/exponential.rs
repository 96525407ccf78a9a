//! Exponential air: n = 1 + δ e^(−y/H), y the height over the origin.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, ORIGIN, UP, layers};
use crate::document::keys;
use crate::document::values::{number_where, positive};
use crate::model::{Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "exponential",
    keys: &[
        ORIGIN,
        UP,
        keys! { delta: "number above -1, other than 0" = "required", "n = 1 + δ e^(−y/H), y the height"; }[0],
        keys! { height: "number above 0" = "required", "H, scene units"; }[0],
    ],
    read: |table, around, _| {
        let (origin, up) = layers(table, around);
        // Below −1 the index would be negative at the origin itself.
        let delta = number_where("a number above -1, other than 0", |delta| delta > -1.0 && delta != 0.0);
        let delta = table.required("delta", "0.00029", delta);
        let height = table.required("height", "8000", positive);
        Some(Arc::new(Exponential { origin, up, delta: delta?, height: height? }))
    },
};

/// n = 1 + δ e^(−y/H).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponential {
    /// Where y is 0.
    pub origin: DVec3,
    /// Along which y grows, a unit vector.
    pub up: DVec3,
    /// n − 1 at the origin.
    pub delta: f64,
    /// H.
    pub height: f64,
}

impl Medium for Exponential {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/exponential"])
    }

    fn values(&self, _: u32) -> Row {
        row! { origin: Vec3(self.origin), up: Vec3(self.up), delta: Float(self.delta), height: Float(self.height) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some((1.0 + self.delta * (-self.up.dot(x - self.origin) / self.height).exp()).max(0.0))
    }
}
