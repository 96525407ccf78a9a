//! Maxwell's fisheye: n = n₀/(1 + r²/a²). Paths are circles.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, center, length};
use crate::document::keys;
use crate::document::values::positive;
use crate::model::{CIRCLE, ClosedForm, Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "maxwell-fisheye",
    keys: &[
        CENTER,
        keys! { n0: "number above 0" = "2", "n = n₀/(1 + r²/a²)"; }[0],
        keys! { a: "number above 0" = "the object's radius, or required", "scene units"; }[0],
    ],
    read: |table, around, _| {
        let center = center(table, around);
        let n0 = table.or("n0", 2.0, positive);
        Some(Arc::new(Fisheye { center, n0, a: length(table, "a", "1", around)? }))
    },
};

/// n = n₀/(1 + r²/a²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fisheye {
    /// Where r is 0.
    pub center: DVec3,
    /// The index at the centre.
    pub n0: f64,
    /// Where the index is half of that.
    pub a: f64,
}

impl Medium for Fisheye {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/fisheye"])
    }

    fn values(&self, _: u32) -> Row {
        row! { center: Vec3(self.center), n0: Float(self.n0), a: Float(self.a) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.n0 / (1.0 + x.distance_squared(self.center) / self.a.powi(2)))
    }

    fn closed_form(&self, ends: bool) -> Option<&'static ClosedForm> {
        (!ends).then_some(&CIRCLE)
    }

    fn center(&self) -> Option<DVec3> {
        Some(self.center)
    }
}
