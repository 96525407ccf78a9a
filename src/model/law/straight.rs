//! Straight rays, as the baseline of other laws (G95 images 1, 2, 11; W04 Fig. 4a).

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::observer::in_space;
use super::{Invariant, Kind, Law, LawProperties, Observer, USUAL_PARTS, UsualSteps};
use crate::model::{STRAIGHT, Wgsl};

pub static KIND: Kind = Kind { name: "straight", keys: &[], read: |_, _| Some(Arc::new(Straight)) };

/// The law of straight rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Straight;

impl Law for Straight {
    fn parts(&self) -> Vec<Wgsl> {
        [Wgsl::parts(&USUAL_PARTS), Wgsl::parts(&["law/straight"])].concat()
    }

    fn facts(&self) -> LawProperties<'_> {
        LawProperties {
            closed_form: Some(&STRAIGHT),
            is_straight: true,
            // Only media of interiors need steps.
            usual_steps: UsualSteps::Scaled,
            keeps_time: true,
            momentum_parts: &["law/momentum/radius", "law/momentum/flat"],
            ..LawProperties::default()
        }
    }

    /// Returns the flat metric.
    fn metric(&self, _: DVec3, _: f64) -> Option<DMat4> {
        Some(DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0)))
    }

    fn observer(&self, frame: Observer, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        in_space(&self.metric(at, 0.0)?, frame)
    }

    fn invariants(&self, _: DVec3, v: DVec3) -> Vec<Invariant> {
        vec![Invariant { name: "speed", value: v.length(), size: v.length() }]
    }
}
