//! The medium n = k/r (T Eq. 17), in which paths are logarithmic spirals.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, MediumProperties, Surroundings, center, length};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::word;
use crate::model::{Anchor, Capture, Row, SPIRAL, fields, row};

pub static KIND: Kind = Kind {
    name: "inverse-r",
    keys: &[
        CENTER,
        keys! { k: "number above 0" = "the object's radius, or required", "n = k/r"; }[0],
        keys! {
            ingoing: "black | continue" = "black",
                "capture rays that move towards the center, or follow them as if they moved outwards";
        }[0],
    ],
    read: |table, around, _| Some(Arc::new(InverseR::read(table, around)?)),
};

fields! {
    /// The medium n = k/r.
    InverseR(table: &TableReader, around: Surroundings) {
        /// The point r = 0, where n is infinite.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// The constant k; by default n = 1 at the surface.
        k: f64 as Float = length(table, "k", "4", around),
        /// The treatment of ingoing rays.
        ingoing: Ingoing = Some(table.or("ingoing", Ingoing::Black, word(&[("black", Ingoing::Black), ("continue", Ingoing::Continued)]))),
    }
}

/// The treatment of rays that move towards the center.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ingoing {
    /// Rays spiral into the center and are captured there.
    Black,
    /// Rays are treated as outgoing, with |d·b| instead of d·b (T Figs. 43 and 46).
    Continued,
}

impl InverseR {
    /// Returns the radius where n is 10⁴, below which rays never return.
    fn capture_radius(&self) -> f64 {
        1e-4 * self.k
    }
}

impl Medium for InverseR {
    fn facts(&self) -> MediumProperties<'_> {
        let capture = Capture { anchor: Anchor::center(self.center), radius: self.capture_radius() };
        MediumProperties {
            closed_form: Some(&SPIRAL),
            center: Some(self.center),
            capture: Some(capture),
            ..MediumProperties::of(&["medium/inverse_r"])
        }
    }

    fn values(&self, _: u32) -> Row {
        let continued = u32::from(self.ingoing == Ingoing::Continued);
        [self.row(), row! { capture: Float(self.capture_radius()), continued: Uint(continued) }].concat()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.k / x.distance(self.center))
    }
}
