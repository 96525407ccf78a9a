//! The Binet equation of the orbit in the ray's plane, for laws with one center.

use super::{MethodKind, Path, Unsupported, refuses_orbits};
use crate::model::control::scaled;

pub static KIND: MethodKind = MethodKind {
    name: "planar",
    path: Path::Orbit,
    // The evaluations of the Nyström method of the orbit.
    evaluations: 3,
    order: 4,
    controls: &[&scaled::KIND],
    refuses: |scene| {
        let mut refused = Vec::new();
        if scene.has_solved_interior {
            refused.push(Unsupported::method("planar cannot follow rays through these interiors"));
        } else if !scene.has_plane {
            refused.push(Unsupported::method(
                "planar requires a law with a single center, so that each ray stays in a plane",
            ));
        }
        refused.extend(refuses_orbits(*scene));
        refused
    },
    closed_forms: true,
    step_cost: Some(1.5),
    sweeps: || vec![("planar", scaled::sweep(16))],
    ..MethodKind::STEPS
};
