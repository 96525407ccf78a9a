//! A constant index n, given as a number or by the name of a common medium.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::model::{Row, STRAIGHT, fields};

pub static KIND: Kind = Kind {
    name: "constant",
    keys: keys! { n: "number above 0" = "required", "index of refraction"; },
    read: |table, _, _| Some(Arc::new(Constant::read(table)?)),
};

/// The indices of common media (T Table 1), with their names in a scene file.
pub const COMMON: [(&str, f64); 11] = [
    ("vacuum", 1.0),
    ("air", 1.0003),
    ("ice", 1.31),
    ("water", 1.33),
    ("ethyl-alcohol", 1.36),
    ("fused-quartz", 1.46),
    ("acrylic", 1.49),
    ("crown-glass", 1.52),
    ("polyester-resin", 1.56),
    ("flint-glass", 1.66),
    ("diamond", 2.42),
];

fields! {
    /// A constant index of refraction.
    Constant(table: &TableReader) {
        /// The index n.
        n: f64 as Float = table.required("n", "1.5", positive),
    }
}

impl Medium for Constant {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties { closed_form: Some(&STRAIGHT), ..MediumProperties::of(&["medium/constant"]) }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, _: DVec3) -> Option<f64> {
        Some(self.n)
    }
}
