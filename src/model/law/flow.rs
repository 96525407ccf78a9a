//! Definitions that all flows share: the vector field F of a dynamical system is a ray's velocity or its acceleration.

use super::sources::OWN_SPEED;
use super::{LawProperties, USUAL_PARTS};
use crate::document::reader::TableReader;
use crate::document::values::whole;
use crate::document::{Key, keys};
use crate::model::Wgsl;

/// The relation of a vector field F to the ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowOrder {
    /// The velocity: dx/dτ = F(x), so that the ray is an orbit (G95 §2.2).
    Velocity,
    /// The acceleration: d²x/dτ² = F(x), which is W04 Eq. 1 read literally.
    Acceleration,
}

/// The key `order`.
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

    /// Returns the WGSL modules of a field with this order.
    pub(super) fn parts(self, field: &'static str) -> Vec<Wgsl> {
        match self {
            Self::Velocity => Wgsl::parts(&[field, "law/flow"]),
            Self::Acceleration => [Wgsl::parts(&USUAL_PARTS), Wgsl::parts(&[field, "law/flow_acceleration"])].concat(),
        }
    }

    pub(super) fn facts<'a>(self) -> LawProperties<'a> {
        match self {
            Self::Velocity => LawProperties::flow(),
            Self::Acceleration => LawProperties { refuses_interiors: Some(OWN_SPEED), ..LawProperties::default() },
        }
    }
}
