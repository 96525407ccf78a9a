//! The orbit's equation in the ray's own plane (Binet): for laws with one centre.

use super::{Controls, Kind, Path, Refusal};
use crate::model::control::scaled;

pub static KIND: Kind = Kind {
    name: "planar",
    path: Path::Orbit,
    parts: &[],
    // Nyström's, of the orbit.
    evaluations: 3,
    order: 4,
    controls: Controls::Scaled,
    refuses: |scene| {
        let mut refused = Vec::new();
        if scene.has_solved_interior {
            refused.push(Refusal::method("planar has no way through these interiors"));
        } else if !scene.has_center {
            refused.push(Refusal::method("planar needs a law with a single centre, which keeps a ray in its plane"));
        }
        if scene.ends {
            let problem = "planar steps are measured by angle and cannot end at a given τ";
            refused.push(Refusal { key: "length", problem, help: "use dormand-prince, or leave `length` out" });
        }
        if scene.has_chords {
            let help = "use segment = \"arc\", or another method";
            refused.push(Refusal { key: "segment", problem: "the planar method has no chords", help });
        }
        refused
    },
    closed_forms: true,
    polygon: false,
    step_cost: Some(1.5),
    sweeps: || vec![("planar", scaled::sweep(16))],
    own: None,
};
