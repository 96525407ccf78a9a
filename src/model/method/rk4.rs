//! The classical Runge–Kutta method of order 4.

use super::{Controls, Kind, Path};
use crate::model::control::{curvature, doubling, scaled};

pub static KIND: Kind = Kind {
    name: "rk4",
    path: Path::Steps,
    parts: &["method/step/rk4"],
    evaluations: 4,
    order: 4,
    controls: Controls::PlannedOrDoubled,
    refuses: |_| Vec::new(),
    closed_forms: false,
    polygon: false,
    step_cost: Some(5.0),
    sweeps: || {
        vec![
            ("rk4", scaled::sweep(16)),
            ("rk4-curvature", curvature::sweep(16)),
            ("rk4-doubling", doubling::sweep(&doubling::REJECTING, 12)),
        ]
    },
    own: None,
};
