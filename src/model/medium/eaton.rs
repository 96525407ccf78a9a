//! Eaton's lens: n² = 2R/r − 1. It sends every ray back to where it came from.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, RADIUS, center, length, root};
use crate::model::{Row, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "eaton",
    keys: &[CENTER, RADIUS],
    read: |table, around, _| {
        let center = center(table, around);
        Some(Arc::new(Eaton { center, radius: length(table, "radius", "1", around)? }))
    },
};

/// n² = 2R/r − 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eaton {
    /// Where r is 0, and n infinite.
    pub center: DVec3,
    /// R.
    pub radius: f64,
}

impl Medium for Eaton {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/eaton"])
    }

    fn values(&self, _: u32) -> Row {
        row! { center: Vec3(self.center), radius: Float(self.radius) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(root(2.0 * self.radius / x.distance(self.center) - 1.0))
    }

    fn edge(&self) -> Option<(DVec3, f64)> {
        Some((self.center, self.radius))
    }
}
