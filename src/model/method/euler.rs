//! Euler's method: p ← p + h F(p) (W04 Eq. 2).

use super::{Controls, Kind, Path};
use crate::model::control::{doubling, scaled};

pub static KIND: Kind = Kind {
    name: "euler",
    path: Path::Steps,
    parts: &["method/step/euler"],
    evaluations: 1,
    order: 1,
    controls: Controls::PlannedOrDoubled,
    refuses: |_| Vec::new(),
    closed_forms: false,
    polygon: false,
    step_cost: None,
    sweeps: || {
        vec![
            ("euler", scaled::sweep(18)),
            ("euler-doubling (2004)", doubling::sweep(&doubling::PAPER, 9)),
            ("euler-doubling", doubling::sweep(&doubling::REJECTING, 9)),
        ]
    },
    own: None,
};
