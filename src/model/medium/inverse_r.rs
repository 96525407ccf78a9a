//! n = k/r (thesis Eq. 17): paths are logarithmic spirals.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Facts, Kind, Medium, Surroundings, center, length};
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
    /// n = k/r.
    InverseR(table: &TableReader, around: Surroundings) {
        /// Where r is 0, and n infinite.
        center: DVec3 as Vec3 = Some(center(table, around)),
        /// k; by default n = 1 at the surface.
        k: f64 as Float = length(table, "k", "4", around),
        /// What becomes of rays that go in.
        ingoing: Ingoing = Some(table.or("ingoing", Ingoing::Black, word(&[("black", Ingoing::Black), ("continue", Ingoing::Continued)]))),
    }
}

/// What becomes of rays that move towards the center.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ingoing {
    /// They wind into the center and are captured there.
    Black,
    /// They are taken for outgoing ones: |d·b| stands for d·b (thesis Figs. 43 and 46).
    Continued,
}

impl InverseR {
    /// Rays that come this near to the middle never come back: there n is 10⁴.
    fn capture_radius(&self) -> f64 {
        1e-4 * self.k
    }
}

impl Medium for InverseR {
    fn facts(&self) -> Facts<'_> {
        let capture = Capture { anchor: Anchor::center(self.center), radius: self.capture_radius() };
        Facts {
            closed_form: Some(&SPIRAL),
            center: Some(self.center),
            capture: Some(capture),
            ..Facts::of(&["medium/inverse_r"])
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
