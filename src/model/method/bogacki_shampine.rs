//! The Bogacki–Shampine 3(2) pair (1989), first same as last.

use super::MethodKind;
use crate::model::control::embedded;

pub static KIND: MethodKind = MethodKind {
    name: "bogacki-shampine",
    parts: &["method/control/embedded", "method/step/bogacki_shampine"],
    evaluations: 3,
    order: 3,
    controls: &[&embedded::KIND],
    sweeps: || vec![("bogacki-shampine", embedded::sweep(14))],
    ..MethodKind::STEPS
};
