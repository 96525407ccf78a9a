//! Nyström's method of order 4, for accelerations that depend on place alone.

use super::leapfrog::needs_place_alone;
use super::{Controls, Kind, Path};
use crate::model::control::scaled;

pub static KIND: Kind = Kind {
    name: "rkn4",
    path: Path::Steps,
    parts: &["method/step/rkn4"],
    evaluations: 3,
    order: 4,
    controls: Controls::Planned,
    refuses: |scene| needs_place_alone(scene.order),
    closed_forms: false,
    polygon: false,
    step_cost: Some(5.0),
    sweeps: || vec![("rkn4", scaled::sweep(16))],
    own: None,
};
