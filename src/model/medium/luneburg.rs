//! Luneburg's lens, generalised: n = √(C − r²/R²) (thesis Eq. 16). Paths are harmonic.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, RADIUS, center, length, root};
use crate::document::keys;
use crate::document::values::number_where;
use crate::model::{ClosedForm, HARMONIC, Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "luneburg",
    keys: &[CENTER, RADIUS, keys! { c: "number, 2 or above" = "2", "C: n = √(C − r²/R²)"; }[0]],
    read: |table, around, _| {
        let (center, radius) = (center(table, around), length(table, "radius", "1", around));
        let c = table.or("c", 2.0, number_where("a number of 2 or more", |c| c >= 2.0));
        Some(Arc::new(Luneburg { center, radius: radius?, c }))
    },
};

/// n = √(C − r²/R²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Luneburg {
    /// Where r is 0.
    pub center: DVec3,
    /// R.
    pub radius: f64,
    /// C ≥ 2.
    pub c: f64,
}

impl Medium for Luneburg {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/luneburg"])
    }

    fn values(&self, _: u32) -> Row {
        row! { center: Vec3(self.center), radius: Float(self.radius), c: Float(self.c) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(root(self.c - x.distance_squared(self.center) / self.radius.powi(2)))
    }

    fn closed_form(&self, _: bool) -> Option<&'static ClosedForm> {
        Some(&HARMONIC)
    }

    fn center(&self) -> Option<DVec3> {
        Some(self.center)
    }

    fn edge(&self) -> Option<(DVec3, f64)> {
        Some((self.center, self.radius))
    }
}
