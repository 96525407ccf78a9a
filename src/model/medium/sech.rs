//! The medium n = n₀ sech(g y), where y is the distance from a plane.

use std::sync::Arc;

use glam::DVec3;

use super::rod::N0;
use super::{Kind, Medium, MediumProperties, ORIGIN, Surroundings, UP, origin, up};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::model::{Row, fields};

pub static KIND: Kind = Kind {
    name: "sech",
    keys: &[ORIGIN, UP, N0, keys! { g: "number above 0" = "required", "n = n₀ sech(g y); y is the height"; }[0]],
    read: |table, around, _| Some(Arc::new(Sech::read(table, around)?)),
};

fields! {
    /// The medium n = n₀ sech(g y).
    Sech(table: &TableReader, around: Surroundings) {
        /// A point of the plane.
        origin: DVec3 as Vec3 = Some(origin(table, around)),
        /// The unit normal of the plane.
        up: DVec3 as Vec3 = Some(up(table)),
        /// The index on the plane.
        n0: f64 as Float = table.required("n0", "1.5", positive),
        /// The constant g.
        g: f64 as Float = table.required("g", "1", positive),
    }
}

impl Medium for Sech {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties::of(&["medium/sech"])
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.n0 / (self.g * self.up.dot(x - self.origin)).cosh())
    }
}
