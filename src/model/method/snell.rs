//! Straight until the index has changed by more than a threshold, then Snell's law (W04 §5.3): for media.

use super::{Controls, Kind, OwnNumber, Path, Refusal};
use crate::document::keys;
use crate::model::control::scaled;

pub static KIND: Kind = Kind {
    name: "snell",
    path: Path::Steps,
    parts: &["method/step/snell"],
    evaluations: 1,
    order: 1,
    controls: Controls::Planned,
    refuses: |scene| {
        let problem = "snell needs law.kind = \"medium\", or an interior that bends light";
        if scene.has_medium { Vec::new() } else { vec![Refusal::method(problem)] }
    },
    closed_forms: false,
    polygon: false,
    step_cost: None,
    sweeps: || vec![("snell", scaled::sweep(16))],
    own: Some(&OwnNumber {
        key: keys! { threshold: "number above 0" = "0.001", "the change of index at which the ray is refracted"; }[0],
        default: 0.001,
        uniform: "snell",
    }),
};
