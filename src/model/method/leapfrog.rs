//! Drift, kick, drift: Störmer and Verlet's method, of order 2, for accelerations that depend on place alone.

use super::{Controls, Kind, Path, Refusal};
use crate::model::Order;
use crate::model::control::scaled;

pub static KIND: Kind = Kind {
    name: "leapfrog",
    path: Path::Steps,
    parts: &["method/step/leapfrog"],
    evaluations: 1,
    order: 2,
    controls: Controls::Planned,
    refuses: |scene| needs_place_alone(scene.order),
    closed_forms: false,
    polygon: false,
    step_cost: None,
    sweeps: || vec![("leapfrog", scaled::sweep(18))],
    own: None,
};

/// Why a method for accelerations that depend on place alone does not suit a law.
pub(super) fn needs_place_alone(order: Order) -> Vec<Refusal> {
    let problem = match order {
        Order::Place => return Vec::new(),
        Order::Flow => "this method is for laws of the second order, and the flow is of the first",
        Order::General => "this method is for accelerations that depend on place alone, and this law's depends on more",
    };
    vec![Refusal::method(problem)]
}
