//! The generalized Luneburg lens, n = √(C − r²/R²) (T Eq. 16), in which paths are harmonic.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, RADIUS, Surroundings, center, length, root};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::number_where;
use crate::model::{HARMONIC, Row, fields};

pub static KIND: Kind = Kind {
    name: "luneburg",
    keys: &[CENTER, RADIUS, keys! { c: "number, 2 or above" = "2", "C: n = √(C − r²/R²)"; }[0]],
    read: |table, around, _| Some(Arc::new(Luneburg::read(table, around)?)),
};

fields! {
    /// The generalized Luneburg lens, n = √(C − r²/R²).
    Luneburg(table: &TableReader, around: Surroundings) {
        /// The point r = 0.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The radius R.
        radius: f64 as Float = length(table, "radius", "1", around),
        /// The constant C ≥ 2.
        c: f64 as Float = Some(table.or("c", 2.0, number_where("a number of 2 or above", |c| c >= 2.0))),
    }
}

impl Medium for Luneburg {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties {
            closed_form: Some(&HARMONIC),
            center: Some(self.center),
            edge: Some((self.center, self.radius)),
            ..MediumProperties::of(&["medium/luneburg"])
        }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(root(self.c - x.distance_squared(self.center) / self.radius.powi(2)))
    }
}
