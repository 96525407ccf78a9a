//! The Euler method: p ← p + h F(p) (W04 Eq. 2).

use super::MethodKind;
use crate::model::control::{PLANNED_OR_DOUBLED, doubling, scaled};

pub static KIND: MethodKind = MethodKind {
    name: "euler",
    parts: &["method/step/euler"],
    controls: &PLANNED_OR_DOUBLED,
    sweeps: || {
        vec![
            ("euler", scaled::sweep(18)),
            ("euler-doubling (2004)", doubling::sweep(&doubling::PAPER, 9)),
            ("euler-doubling", doubling::sweep(&doubling::REJECTING, 9)),
        ]
    },
    ..MethodKind::STEPS
};
