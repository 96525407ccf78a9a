//! Straight paths until the index has changed by more than a threshold, then Snell's law (W04 §5.3), for media.

use super::{MethodKind, MethodParameter, Unsupported};
use crate::document::keys;
use crate::model::control::scaled;

pub static KIND: MethodKind = MethodKind {
    name: "snell",
    parts: &["method/step/snell"],
    refuses: |scene| {
        let problem = "snell requires law.kind = \"medium\", or an interior that bends light";
        if scene.has_medium { Vec::new() } else { vec![Unsupported::method(problem)] }
    },
    sweeps: || vec![("snell", scaled::sweep(16))],
    own: Some(&MethodParameter {
        key: keys! { threshold: "number above 0" = "0.001", "change of the index at which the ray is refracted"; }[0],
        default: 0.001,
        uniform: "snell",
    }),
    ..MethodKind::STEPS
};
