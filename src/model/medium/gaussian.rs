//! A Gaussian ball: n = a e^(−b r²/R²).

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, RADIUS, Surroundings, center, length};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{number, positive};
use crate::model::{Row, fields};

pub static KIND: Kind = Kind {
    name: "gaussian",
    keys: &[
        CENTER,
        RADIUS,
        keys! { a: "number above 0" = "required", "n = a e^(−b r²/R²)"; }[0],
        keys! { b: "number" = "ln a: n = 1 at R", "see a"; }[0],
    ],
    read: |table, around, _| Some(Arc::new(Gaussian::read(table, around)?)),
};

fields! {
    /// The Gaussian ball, n = a e^(−b r²/R²).
    Gaussian(table: &TableReader, around: Surroundings) {
        /// The point r = 0.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The radius R.
        radius: f64 as Float = length(table, "radius", "1", around),
        /// The index at the center.
        a: f64 as Float = table.required("a", "1.4", positive),
        /// The exponent at R.
        b: f64 as Float = Some(table.or("b", a.unwrap_or(1.0).ln(), number)),
    }
}

impl Medium for Gaussian {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties { edge: Some((self.center, self.radius)), ..MediumProperties::of(&["medium/gaussian"]) }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.a * (-self.b * x.distance_squared(self.center) / self.radius.powi(2)).exp())
    }
}
