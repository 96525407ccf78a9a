//! A gradient-index rod: n = n₀ √(1 − g²ρ²), where ρ is the distance from its axis (Suffern and Getto 1991). Paths are sinusoidal.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, Surroundings, center, root};
use crate::document::reader::TableReader;
use crate::document::values::{direction, positive};
use crate::document::{Key, keys};
use crate::model::{HARMONIC, Row, fields};

/// The key `n0` of media with a reference index on an axis or a plane.
pub(super) const N0: Key = keys! { n0: "number above 0" = "required", "the index on the axis, or on the plane"; }[0];

pub static KIND: Kind = Kind {
    name: "rod",
    keys: &[
        CENTER,
        N0,
        keys! { g: "number above 0" = "required", "n = n₀ √(1 − g²ρ²); ρ is the distance from the axis"; }[0],
        keys! { axis: "[x, y, z]" = "the cylinder's, or [0, 0, 1]", "direction of the rod"; }[0],
    ],
    read: |table, around, _| Some(Arc::new(Rod::read(table, around)?)),
};

fields! {
    /// The gradient-index rod, n = n₀ √(1 − g²ρ²).
    Rod(table: &TableReader, around: Surroundings) {
        /// A point of the axis.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The unit vector of the axis.
        axis: DVec3 as Vec3 = Some(table.or("axis", around.axis.unwrap_or(DVec3::Z), direction)),
        /// The index on the axis.
        n0: f64 as Float = table.required("n0", "1.6", positive),
        /// The constant g.
        g: f64 as Float = table.required("g", "0.3", positive),
    }
}

impl Medium for Rod {
    fn facts(&self) -> MediumProperties<'_> {
        MediumProperties { closed_form: Some(&HARMONIC), ..MediumProperties::of(&["medium/rod"]) }
    }

    fn values(&self, _: u32) -> Row {
        self.row()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        let off_axis = (x - self.center).reject_from_normalized(self.axis).length_squared();
        Some(self.n0 * root(1.0 - self.g.powi(2) * off_axis))
    }
}
