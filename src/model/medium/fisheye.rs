//! The Maxwell fisheye lens, n = n₀/(1 + r²/a²), with circular paths.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, Surroundings, center, length};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::model::{CIRCLE, Row, fields};

pub static KIND: Kind = Kind {
    name: "maxwell-fisheye",
    keys: &[
        CENTER,
        keys! { n0: "number above 0" = "2", "n = n₀/(1 + r²/a²)"; }[0],
        keys! { a: "number above 0" = "the object's radius, or required", "scene units"; }[0],
    ],
    read: |table, around, _| Some(Arc::new(Fisheye::read(table, around)?)),
};

fields! {
    /// The Maxwell fisheye lens, n = n₀/(1 + r²/a²).
    Fisheye(table: &TableReader, around: Surroundings) {
        /// The point r = 0.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The index at the center.
        n0: f64 as Float = Some(table.or("n0", 2.0, positive)),
        /// The radius at which the index is half the index at the center.
        a: f64 as Float = length(table, "a", "1", around),
    }
}

impl Medium for Fisheye {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties {
            closed_form: Some(&CIRCLE),
            center: Some(self.center),
            ..MediumProperties::of(&["medium/fisheye"])
        }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.n0 / (1.0 + x.distance_squared(self.center) / self.a.powi(2)))
    }
}
