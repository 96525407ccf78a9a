//! Straight lines: what other laws are compared with (G95 images 1, 2, 11; W04 Fig. 4a).

use std::sync::Arc;

use glam::DVec3;

use super::{Invariant, Kind, Law, Order, USUAL_PARTS};
use crate::model::{ClosedForm, STRAIGHT, Wgsl};

pub static KIND: Kind = Kind { name: "straight", keys: &[], read: |_, _| Some(Arc::new(Straight)) };

/// Straight lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Straight;

impl Law for Straight {
    fn parts(&self) -> Vec<Wgsl> {
        [Wgsl::parts(&USUAL_PARTS), Wgsl::parts(&["law/straight"])].concat()
    }

    fn order(&self) -> Order {
        Order::Place
    }

    fn closed_form(&self) -> Option<&'static ClosedForm> {
        Some(&STRAIGHT)
    }

    fn is_straight(&self) -> bool {
        true
    }

    fn invariants(&self, _: DVec3, v: DVec3) -> Vec<Invariant> {
        vec![Invariant { name: "speed", value: v.length(), size: v.length() }]
    }
}
