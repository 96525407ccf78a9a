//! The separated equations of the orbit in Mino time, for a rotating black hole.

use super::{MethodKind, Path, Unsupported, refuses_orbits};
use crate::model::control::scaled;

pub static KIND: MethodKind = MethodKind {
    name: "separated",
    path: Path::Orbit,
    // The evaluations of the Nyström method of the orbit.
    evaluations: 3,
    order: 4,
    controls: &[&scaled::KIND],
    refuses: |scene| {
        let mut refused = Vec::new();
        if !scene.separates {
            refused.push(Unsupported::method(
                "separated requires law.kind = \"kerr-newman\" and a black hole with a horizon",
            ));
        }
        refused.extend(refuses_orbits(*scene));
        refused
    },
    closed_forms: true,
    step_cost: Some(3.0),
    sweeps: || vec![("separated", scaled::sweep(16))],
    ..MethodKind::STEPS
};
