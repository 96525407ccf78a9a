//! The Dormand–Prince 5(4) pair (1980), first same as last.

use super::MethodKind;
use crate::model::control::embedded;

pub static KIND: MethodKind = MethodKind {
    name: "dormand-prince",
    parts: &["method/control/embedded", "method/step/dormand_prince"],
    evaluations: 6,
    order: 5,
    controls: &[&embedded::KIND],
    step_cost: Some(15.0),
    sweeps: || vec![("dormand-prince", embedded::sweep(14))],
    ..MethodKind::STEPS
};
