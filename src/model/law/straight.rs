//! Straight lines: what other laws are compared with (G95 images 1, 2, 11; W04 Fig. 4a).

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::observer::{OBSERVER_PART, moving, normalised};
use super::{CameraFrame, Invariant, Kind, Law, Order, USUAL_PARTS};
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

    fn keeps_time(&self) -> bool {
        true
    }

    fn frame_part(&self, frame: CameraFrame) -> Option<&'static str> {
        self.observer(frame, DVec3::ZERO).map(|_| OBSERVER_PART)
    }

    /// Flat.
    fn metric(&self, _: DVec3) -> Option<DMat4> {
        Some(DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0)))
    }

    fn observer(&self, frame: CameraFrame, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let metric = self.metric(at)?;
        let found = match frame {
            CameraFrame::Static | CameraFrame::Normal => normalised(&metric, DVec4::W),
            CameraFrame::Moving(velocity) => moving(&metric, velocity),
            _ => return None,
        };
        Some(found.ok_or_else(|| ["is nowhere".to_owned(), "move it".to_owned()]))
    }

    fn momentum_parts(&self) -> &'static [&'static str] {
        &["law/momentum/flat"]
    }

    fn invariants(&self, _: DVec3, v: DVec3) -> Vec<Invariant> {
        vec![Invariant { name: "speed", value: v.length(), size: v.length() }]
    }
}
