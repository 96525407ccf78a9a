//! The medium n² = n₀² + gradient · (x − origin), in which paths are parabolas (Evans and Rosenquist 1985).

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties, ORIGIN, Surroundings, origin, root};
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, positive, vector};
use crate::document::{Node, keys};
use crate::model::{PARABOLA, Row, fields};

pub static KIND: Kind = Kind {
    name: "linear",
    keys: &[
        ORIGIN,
        keys! { n0: "number above 0" = "1", "index at the origin"; }[0],
        keys! { gradient: "[x, y, z], not all 0" = "required", "n² = n₀² + gradient · (x − origin)"; }[0],
    ],
    read: |table, around, _| Some(Arc::new(Linear::read(table, around)?)),
};

fields! {
    /// The medium n² = n₀² + gradient · (x − origin).
    Linear(table: &TableReader, around: Surroundings) {
        /// The point where the index is n₀.
        origin: DVec3 as Vec3 = Some(origin(table, around)),
        /// The index n₀ at the origin.
        n0: f64 as Float = Some(table.or("n0", 1.0, positive)),
        /// The gradient of n².
        gradient: DVec3 as Vec3 = table.required("gradient", "[0, 0.02, 0]", gradient),
    }
}

/// Reads a gradient that is not zero, because the index would otherwise be constant.
fn gradient(node: &Node) -> Parsed<DVec3> {
    let gradient = vector(node)?;
    let none = || Err(node.fault("without a gradient, the index is constant", "use kind = \"constant\""));
    if gradient == DVec3::ZERO { none() } else { Ok(gradient) }
}

impl Medium for Linear {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties { closed_form: Some(&PARABOLA), ..MediumProperties::of(&["medium/linear"]) }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(root(self.n0.powi(2) + self.gradient.dot(x - self.origin)))
    }
}
