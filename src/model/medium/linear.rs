//! n² = n₀² + gradient · (x − origin): paths are parabolas (Evans and Rosenquist 1985).

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, ORIGIN, root};
use crate::document::values::{Read, positive, vector};
use crate::document::{Node, keys};
use crate::model::{ClosedForm, PARABOLA, Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "linear",
    keys: &[
        ORIGIN,
        keys! { n0: "number above 0" = "1", "the index at the origin"; }[0],
        keys! { gradient: "[x, y, z], not all 0" = "required", "n² = n₀² + gradient · (x − origin)"; }[0],
    ],
    read: |table, around, _| {
        let origin = table.or("origin", around.center, vector);
        let n0 = table.or("n0", 1.0, positive);
        let gradient = table.required("gradient", "[0, 0.02, 0]", gradient)?;
        Some(Arc::new(Linear { origin, n0, gradient }))
    },
};

/// Without one the index would be constant.
fn gradient(node: &Node) -> Read<DVec3> {
    let gradient = vector(node)?;
    let none = || Err(node.fault("without a gradient the index is constant", "use kind = \"constant\""));
    if gradient == DVec3::ZERO { none() } else { Ok(gradient) }
}

/// n² = n₀² + gradient · (x − origin).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear {
    /// Where the index is n₀.
    pub origin: DVec3,
    /// n₀.
    pub n0: f64,
    /// Of n².
    pub gradient: DVec3,
}

impl Medium for Linear {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/linear"])
    }

    fn values(&self, _: u32) -> Row {
        row! { origin: Vec3(self.origin), n0: Float(self.n0), gradient: Vec3(self.gradient) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(root(self.n0.powi(2) + self.gradient.dot(x - self.origin)))
    }

    fn closed_form(&self, _: bool) -> Option<&'static ClosedForm> {
        Some(&PARABOLA)
    }
}
