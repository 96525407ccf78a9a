//! An exponential atmosphere: n = 1 + δ e^(−y/H), where y is the height above the origin.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties, ORIGIN, Surroundings, UP, origin, up};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{number_where, positive_length};
use crate::model::{Row, fields};

pub static KIND: Kind = Kind {
    name: "exponential",
    keys: &[
        ORIGIN,
        UP,
        keys! { delta: "number above -1, other than 0" = "required", "δ in n = 1 + δ e^(−y/H); y is the height"; }[0],
        keys! { height: "number above 0" = "required", "H, scene units"; }[0],
    ],
    read: |table, around, _| Some(Arc::new(Exponential::read(table, around)?)),
};

fields! {
    /// The exponential atmosphere, n = 1 + δ e^(−y/H).
    Exponential(table: &TableReader, around: Surroundings) {
        /// The point y = 0.
        origin: DVec3 as Vec3 = Some(origin(table, around)),
        /// The unit vector along which y grows.
        up: DVec3 as Vec3 = Some(up(table)),
        /// The value of n − 1 at the origin, which must be above −1 for a positive index.
        delta: f64 as Float = table.required("delta", "0.00029", number_where("a number above -1, other than 0", |delta| delta > -1.0 && delta != 0.0)),
        /// The scale height H.
        height: f64 as Float = table.required("height", "8000", positive_length),
    }
}

impl Medium for Exponential {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties::of(&["medium/exponential"])
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some((1.0 + self.delta * (-self.up.dot(x - self.origin) / self.height).exp()).max(0.0))
    }
}
