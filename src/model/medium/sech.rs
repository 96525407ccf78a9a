//! n = n₀ sech(g y), y the distance from a plane.

use std::sync::Arc;

use glam::DVec3;

use super::rod::N0;
use super::{Kind, Medium, ORIGIN, UP, layers};
use crate::document::keys;
use crate::document::values::positive;
use crate::model::{Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "sech",
    keys: &[ORIGIN, UP, N0, keys! { g: "number above 0" = "required", "n = n₀ sech(g y), y the height"; }[0]],
    read: |table, around, _| {
        let (origin, up) = layers(table, around);
        let n0 = table.required("n0", "1.5", positive);
        let g = table.required("g", "1", positive);
        Some(Arc::new(Sech { origin, up, n0: n0?, g: g? }))
    },
};

/// n = n₀ sech(g y).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sech {
    /// A point of the plane.
    pub origin: DVec3,
    /// Its unit normal.
    pub up: DVec3,
    /// The index on it.
    pub n0: f64,
    /// g.
    pub g: f64,
}

impl Medium for Sech {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/sech"])
    }

    fn values(&self, _: u32) -> Row {
        row! { origin: Vec3(self.origin), up: Vec3(self.up), n0: Float(self.n0), g: Float(self.g) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.n0 / (self.g * self.up.dot(x - self.origin)).cosh())
    }
}
