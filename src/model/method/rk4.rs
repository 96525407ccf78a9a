//! The classical Runge–Kutta method of order 4.

use super::MethodKind;
use crate::model::control::{PLANNED_OR_DOUBLED, curvature, doubling, scaled};

pub static KIND: MethodKind = MethodKind {
    name: "rk4",
    parts: &["method/step/rk4"],
    evaluations: 4,
    order: 4,
    controls: &PLANNED_OR_DOUBLED,
    step_cost: Some(5.0),
    sweeps: || {
        vec![
            ("rk4", scaled::sweep(16)),
            ("rk4-curvature", curvature::sweep(16)),
            ("rk4-doubling", doubling::sweep(&doubling::REJECTING, 12)),
        ]
    },
    ..MethodKind::STEPS
};
