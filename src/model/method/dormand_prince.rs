//! Dormand and Prince's pair of orders 5 and 4 (1980), first same as last.

use super::{Controls, Kind, Path};
use crate::model::control::embedded;

pub static KIND: Kind = Kind {
    name: "dormand-prince",
    path: Path::Steps,
    parts: &["method/control/embedded", "method/step/dormand_prince"],
    evaluations: 6,
    order: 5,
    controls: Controls::Embedded,
    refuses: |_| Vec::new(),
    closed_forms: false,
    polygon: false,
    step_cost: Some(15.0),
    sweeps: || vec![("dormand-prince", embedded::sweep(14))],
    own: None,
};
