//! The Eaton lens, n² = 2R/r − 1, which is a retroreflector.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, RADIUS, Surroundings, center, length, root};
use crate::document::reader::TableReader;
use crate::model::{Row, fields};

pub static KIND: Kind = Kind {
    name: "eaton",
    keys: &[CENTER, RADIUS],
    read: |table, around, _| Some(Arc::new(Eaton::read(table, around)?)),
};

fields! {
    /// The Eaton lens, n² = 2R/r − 1.
    Eaton(table: &TableReader, around: Surroundings) {
        /// The point r = 0, where n is infinite.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The radius R.
        radius: f64 as Float = length(table, "radius", "1", around),
    }
}

impl Medium for Eaton {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties { edge: Some((self.center, self.radius)), ..MediumProperties::of(&["medium/eaton"]) }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(root(2.0 * self.radius / x.distance(self.center) - 1.0))
    }
}
