//! A medium that fills all of space (W04 §5.3): dx = v, dv = ∇(n²/2), |v| = n.

use std::sync::Arc;

use glam::DVec3;

use super::{CharacteristicSurface, Form, Invariant, Kind, Law, LawProperties, UsualSteps};
use crate::document::keys;
use crate::model::medium::{self, Surroundings};
use crate::model::{Medium, Wgsl};

/// The WGSL modules of a medium without closed-form paths.
pub const SOLVED_PARTS: [&str; 5] =
    ["law/accelerated", "law/no_constant", "law/start_by_index", "law/projected_as_is", "law/medium"];

pub static KIND: Kind = Kind {
    name: "medium",
    keys: keys! {
        index: "number, name or { kind, .. }" = "required", "index of refraction: see medium";
    },
    read: |table, files| {
        let node = table.required_node("index", "{ kind = \"maxwell-fisheye\", n0 = 2, a = 1 }")?;
        let medium = medium::read(table, node, Surroundings::default(), files)?;
        if medium.facts().is_of_surfaces {
            let problem = "a textured index applies only to surfaces, not to space";
            table.fault(&["index"], problem, "use kind = \"noise\", or give it to an object as `interior`");
            return None;
        }
        Some(Arc::new(InMedium(medium)))
    },
};

/// A medium that fills all of space.
#[derive(Debug, Clone)]
pub struct InMedium(pub Arc<dyn Medium>);

impl PartialEq for InMedium {
    fn eq(&self, other: &Self) -> bool {
        *self.0 == *other.0
    }
}

impl Law for InMedium {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&SOLVED_PARTS)
    }

    fn facts(&self) -> LawProperties<'_> {
        LawProperties {
            usual_steps: UsualSteps::Scaled,
            terms: self.0.facts().terms,
            form: Form::Medium(&self.0),
            ..LawProperties::default()
        }
    }

    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let ratio = |n: f64| Invariant { name: "|v| / n", value: v.length() / n, size: 1.0 };
        self.0.index(x).map(ratio).into_iter().collect()
    }

    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        let edge = |(center, radius)| CharacteristicSurface::sphere("r = R", center, radius, false);
        self.0.facts().edge.map(edge).into_iter().collect()
    }

    /// Returns a velocity with the length of the index, or 1 if the host cannot evaluate the index.
    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        self.0.index(x).unwrap_or(1.0) * v.normalize_or_zero()
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let dark = || {
            ["is where the index is 0, which no light reaches".to_owned(), "move it to where n is above 0".to_owned()]
        };
        (self.0.index(at) == Some(0.0)).then(dark)
    }
}
