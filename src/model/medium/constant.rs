//! n everywhere, given as a number or by the name of a common medium.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium};
use crate::document::keys;
use crate::document::values::positive;
use crate::model::{ClosedForm, Row, STRAIGHT, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "constant",
    keys: keys! { n: "number above 0" = "required", "the index"; },
    read: |table, _, _| Some(Arc::new(Constant { n: table.required("n", "1.5", positive)? })),
};

/// The indices of common media (thesis Table 1), by the names that a scene file may write for them.
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

/// n everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant {
    /// n.
    pub n: f64,
}

impl Medium for Constant {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/constant"])
    }

    fn values(&self, _: u32) -> Row {
        row! { n: Float(self.n) }
    }

    fn index(&self, _: DVec3) -> Option<f64> {
        Some(self.n)
    }

    fn closed_form(&self, _: bool) -> Option<&'static ClosedForm> {
        Some(&STRAIGHT)
    }

    fn bends(&self) -> bool {
        false
    }
}
