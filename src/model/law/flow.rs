//! What the flows share: a dynamical system's vector field F as a ray's velocity, or as its acceleration.

use super::sources::OWN_SPEED;
use super::{Facts, USUAL_PARTS};
use crate::document::reader::TableReader;
use crate::document::values::whole;
use crate::document::{Key, keys};
use crate::model::Wgsl;

/// What a vector field F is to the ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowOrder {
    /// dx/dτ = F(x): the ray is an orbit (G95 §2.2).
    Velocity,
    /// d²x/dτ² = F(x): W04's Eq. 1 read literally.
    Acceleration,
}

/// `order`.
pub(super) const ORDER: Key = keys! {
    order: "1, 2" = "1", "the field is the velocity of the ray (1) or its acceleration (2)";
}[0];

impl FlowOrder {
    pub(super) fn read(table: &TableReader) -> Self {
        match table.or("order", 1, whole(1..=2)) {
            1 => Self::Velocity,
            _ => Self::Acceleration,
        }
    }

    /// A field's part under this order.
    pub(super) fn parts(self, field: &'static str) -> Vec<Wgsl> {
        match self {
            Self::Velocity => Wgsl::parts(&[field, "law/flow"]),
            Self::Acceleration => [Wgsl::parts(&USUAL_PARTS), Wgsl::parts(&[field, "law/flow_acceleration"])].concat(),
        }
    }

    pub(super) fn facts<'a>(self) -> Facts<'a> {
        match self {
            Self::Velocity => Facts::flow(),
            Self::Acceleration => Facts { refuses_interiors: Some(OWN_SPEED), ..Facts::default() },
        }
    }
}
