//! Bogacki and Shampine's pair of orders 3 and 2 (1989), first same as last.

use super::{Controls, Kind, Path};
use crate::model::control::embedded;

pub static KIND: Kind = Kind {
    name: "bogacki-shampine",
    path: Path::Steps,
    parts: &["method/control/embedded", "method/step/bogacki_shampine"],
    evaluations: 3,
    order: 3,
    controls: Controls::Embedded,
    refuses: |_| Vec::new(),
    closed_forms: false,
    polygon: false,
    step_cost: None,
    sweeps: || vec![("bogacki-shampine", embedded::sweep(14))],
    own: None,
};
