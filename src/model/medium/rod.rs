//! A gradient rod: n = n₀ √(1 − g²ρ²), ρ the distance from its axis (Suffern and Getto 1991). Paths are sinusoidal.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, center, root};
use crate::document::values::{direction, positive};
use crate::document::{Key, keys};
use crate::model::{ClosedForm, HARMONIC, Row, Wgsl, row};

/// `n0` of media that have it on an axis or a plane.
pub(super) const N0: Key = keys! { n0: "number above 0" = "required", "the index on the axis, or on the plane"; }[0];

pub static KIND: Kind = Kind {
    name: "rod",
    keys: &[
        CENTER,
        N0,
        keys! { g: "number above 0" = "required", "n = n₀ √(1 − g²ρ²), ρ the distance from the axis"; }[0],
        keys! { axis: "[x, y, z]" = "the cylinder's, or [0, 0, 1]", "along the rod"; }[0],
    ],
    read: |table, around, _| {
        let axis = table.or("axis", around.axis.unwrap_or(DVec3::Z), direction);
        let n0 = table.required("n0", "1.6", positive);
        let g = table.required("g", "0.3", positive);
        Some(Arc::new(Rod { center: center(table, around), axis, n0: n0?, g: g? }))
    },
};

/// n = n₀ √(1 − g²ρ²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rod {
    /// A point of the axis.
    pub center: DVec3,
    /// The axis, a unit vector.
    pub axis: DVec3,
    /// The index on the axis.
    pub n0: f64,
    /// g.
    pub g: f64,
}

impl Medium for Rod {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/rod"])
    }

    fn values(&self, _: u32) -> Row {
        row! { center: Vec3(self.center), axis: Vec3(self.axis), n0: Float(self.n0), g: Float(self.g) }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        let off_axis = (x - self.center).reject_from_normalized(self.axis).length_squared();
        Some(self.n0 * root(1.0 - self.g.powi(2) * off_axis))
    }

    fn closed_form(&self, _: bool) -> Option<&'static ClosedForm> {
        Some(&HARMONIC)
    }
}
