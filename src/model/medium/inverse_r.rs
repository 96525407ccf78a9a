//! n = k/r (thesis Eq. 17): paths are logarithmic spirals.

use std::sync::Arc;

use glam::DVec3;

use super::{CENTER, Kind, Medium, center, length};
use crate::document::keys;
use crate::document::values::word;
use crate::model::{Anchor, Capture, ClosedForm, Row, SPIRAL, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "inverse-r",
    keys: &[
        CENTER,
        keys! { k: "number above 0" = "the object's radius, or required", "n = k/r"; }[0],
        keys! {
            ingoing: "black | continue" = "black",
                "rays towards the centre are captured there, or followed as if they went outwards";
        }[0],
    ],
    read: |table, around, _| {
        let center = center(table, around);
        // By default n = 1 at the surface.
        let k = length(table, "k", "4", around);
        let ingoing = &[("black", Ingoing::Black), ("continue", Ingoing::Continued)];
        let ingoing = table.or("ingoing", Ingoing::Black, word(ingoing));
        Some(Arc::new(InverseR { center, k: k?, ingoing }))
    },
};

/// n = k/r.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverseR {
    /// Where r is 0, and n infinite.
    pub center: DVec3,
    /// k.
    pub k: f64,
    /// What becomes of rays that go in.
    pub ingoing: Ingoing,
}

/// What becomes of rays that move towards the centre.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ingoing {
    /// They wind into the centre and are captured there.
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
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["medium/inverse_r"])
    }

    fn values(&self, _: u32) -> Row {
        row! {
            center: Vec3(self.center),
            k: Float(self.k),
            capture: Float(self.capture_radius()),
            continued: Uint(u32::from(self.ingoing == Ingoing::Continued)),
        }
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.k / x.distance(self.center))
    }

    fn closed_form(&self, ends: bool) -> Option<&'static ClosedForm> {
        (!ends).then_some(&SPIRAL)
    }

    fn capture(&self) -> Option<Capture> {
        Some(Capture { anchor: Anchor::center(self.center), radius: self.capture_radius() })
    }

    fn center(&self) -> Option<DVec3> {
        Some(self.center)
    }
}
