//! The drift–kick–drift leapfrog (Störmer–Verlet) method of order 2, for accelerations that depend on position alone.

use super::{MethodKind, Unsupported};
use crate::model::Order;
use crate::model::control::scaled;

pub static KIND: MethodKind = MethodKind {
    name: "leapfrog",
    parts: &["method/step/leapfrog"],
    order: 2,
    refuses: |scene| needs_place_alone(scene.order),
    sweeps: || vec![("leapfrog", scaled::sweep(18))],
    ..MethodKind::STEPS
};

/// Returns why a method for accelerations that depend on position alone does not support a law.
pub(super) fn needs_place_alone(order: Order) -> Vec<Unsupported> {
    let problem = match order {
        Order::Place => return Vec::new(),
        Order::Flow => "this method requires a law of the second order, and the flow is of the first",
        Order::General => "this method requires an acceleration that depends on position alone",
    };
    vec![Unsupported::method(problem)]
}
