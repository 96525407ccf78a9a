//! A Gaussian ball: n = a e^(−b r²/R²).

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, RADIUS, center, length};
use crate::document::keys;
use crate::document::values::{number, positive};
use crate::model::{Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "gaussian",
    keys: &[
        CENTER,
        RADIUS,
        keys! { a: "number above 0" = "required", "n = a e^(−b r²/R²)"; }[0],
        keys! { b: "number" = "ln a: n = 1 at R", "see a"; }[0],
    ],
    read: |table, around, _| {
        let (center, radius) = (center(table, around), length(table, "radius", "1", around));
        let a = table.required("a", "1.4", positive);
        let b = table.or("b", a.unwrap_or(1.0).ln(), number);
        Some(Arc::new(Gaussian { center, radius: radius?, a: a?, b }))
    },
};

/// n = a e^(−b r²/R²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaussian {
    /// Where r is 0.
    pub center: DVec3,
    /// R.
    pub radius: f64,
    /// The index at the centre.
    pub a: f64,
    /// The exponent at R.
    pub b: f64,
}

impl Medium for Gaussian {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/gaussian"])
    }

    fn values(&self, _: u32) -> Row {
        row! { center: Vec3(self.center), radius: Float(self.radius), a: Float(self.a), b: Float(self.b) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.a * (-self.b * x.distance_squared(self.center) / self.radius.powi(2)).exp())
    }

    fn edge(&self) -> Option<(DVec3, f64)> {
        Some((self.center, self.radius))
    }
}
