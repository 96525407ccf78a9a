//! The Nyström method of order 4, for accelerations that depend on position alone.

use super::MethodKind;
use super::leapfrog::needs_place_alone;
use crate::model::control::scaled;

pub static KIND: MethodKind = MethodKind {
    name: "rkn4",
    parts: &["method/step/rkn4"],
    evaluations: 3,
    order: 4,
    refuses: |scene| needs_place_alone(scene.order),
    step_cost: Some(5.0),
    sweeps: || vec![("rkn4", scaled::sweep(16))],
    ..MethodKind::STEPS
};
