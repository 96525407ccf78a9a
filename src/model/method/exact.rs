//! Closed forms alone, for straight rays and media whose paths are known.

use super::{MethodKind, Path, Unsupported};
use crate::model::control;

pub static KIND: MethodKind = MethodKind {
    name: "exact",
    path: Path::Closed,
    evaluations: 0,
    order: 0,
    controls: &[&control::exact::KIND],
    refuses: |scene| {
        let mut refused = Vec::new();
        if scene.needs_solver {
            let problem = "the exact method requires straight rays, or media whose paths have a closed form";
            refused.push(Unsupported::method(problem));
        }
        if scene.has_chords {
            let help = "use segment = \"arc\", or another method";
            refused.push(Unsupported { key: "segment", problem: "the exact method does not support chords", help });
        }
        refused
    },
    closed_forms: true,
    step_cost: Some(0.0),
    sweeps: || vec![("exact", vec![control::exact::CONTROL])],
    ..MethodKind::STEPS
};
