//! Gröller's iteration as published: x ← x + h v/|v|, v ← f(x, v) (G95 §3.1, Table 1).
//!
//! *Theory.* Under sources of force, f(x, v) = v − Σ M d(r) n̂ without h. The iteration therefore integrates the law by arc length, dx =
//! v/|v|, dv = a(x), with M/h instead of M, so that the image depends on h. Under a flow, f is the field.

use super::{MethodKind, Unsupported};
use crate::model::{Order, control};

pub static KIND: MethodKind = MethodKind {
    name: "groeller",
    parts: &["method/step/groeller"],
    controls: &[&control::iterated::KIND],
    refuses: |scene| {
        let mut refused = Vec::new();
        if scene.order == Order::General || scene.has_medium {
            refused.push(Unsupported::method("Gröller's iteration requires sources of force, or a flow"));
        }
        if !scene.has_chords {
            let help = "use segment = \"chord\", or remove `segment`";
            refused.push(Unsupported {
                key: "segment",
                problem: "Gröller's iteration consists of straight steps",
                help,
            });
        }
        refused
    },
    polygon: true,
    // The image depends on h, so that a chart has no accuracy to show.
    ..MethodKind::STEPS
};
