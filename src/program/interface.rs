//! What each binding is for: the one table between the names of WGSL variables and what the host does about them.
//!
//! *Idea.* The host makes a resource for every binding of a pass. What a binding is for is decided once, where its program is
//! reflected; from then on the host matches on its [`Role`], and looks at no name. The renderer's own bindings stand in the
//! tables below, which a test holds to the parts. The scene's do not, for a kind of law, medium or shape brings its own: what
//! is in no table and is only read is a value of the scene, under the name that its part gives it.

use std::fmt;

/// What a binding is for.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// The scene's uniforms in one block, for the pass of this entry point.
    Uniforms(String),
    /// A list of the scene.
    Scene(SceneValue),
    /// A picture of the scene, by its place among them.
    Picture(usize),
    /// The state of every pixel's ray.
    State(StatePart, Slot),
    /// What passes keep for each pixel: members of one struct.
    Pixels,
    /// The sums of an adaptive picture's samples.
    Moments,
    /// The pixels that a pass runs over, or those that it leaves to a later one.
    List(Access),
    /// The arguments of dispatches over that list.
    Arguments(Access),
    /// Dispatch parameters: what a pass is told of one dispatch.
    Parameters,
    /// What passes are told of a tile and a sample.
    Frame,
    /// Sums over all rays.
    Tally,
    /// How many pixels want more samples.
    Refined,
    /// The ends of rays that are traced.
    Records,
    /// Their starts.
    Given,
    /// The regions that they start in.
    GivenSets,
    /// The pixels of the picture that are traced.
    Chosen,
    /// The steps that each pixel's ray is to take, for measurements.
    WantedSteps,
    /// The voxels that a light's paths leave their light in.
    LightVolume,
    /// Those that are cut into bricks.
    VolumeBricks,
    /// What is left there.
    LightSums,
    /// Whether a path left anything.
    LightReaches,
    /// None of these, and of no pass: a kernel of its own binds it by its number.
    Other {
        /// Where the linked program declares it, in bytes.
        at: usize,
    },
}

/// A value of the scene, as a part declares it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct SceneValue {
    /// The name in the part.
    pub name: String,
    /// The kind of region that it is for; 0 where all share it.
    pub region: usize,
}

/// A part of a ray's state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum StatePart {
    /// Position, and the path's parameter.
    X,
    /// Velocity, and the step's size.
    V,
    /// What else is kept of it.
    W,
    /// All three, in 64 bits.
    All,
}

/// The slot of the state that a binding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slot {
    /// What the pass reads.
    Input,
    /// What it writes.
    Output,
    /// A segment's start.
    Start,
    /// A segment's end.
    End,
    /// This one, in every dispatch.
    Fixed(usize),
}

/// What a pass does with a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Access {
    /// Runs over it.
    Read,
    /// Adds to it.
    Write,
}

/// The renderer's bindings.
const ROLES: [(&str, Role); 19] = [
    ("pixels", Role::Pixels),
    ("moments", Role::Moments),
    ("list_in", Role::List(Access::Read)),
    ("list_out", Role::List(Access::Write)),
    ("active_in", Role::Arguments(Access::Read)),
    ("active_out", Role::Arguments(Access::Write)),
    ("dispatch", Role::Parameters),
    ("frame", Role::Frame),
    ("tally", Role::Tally),
    ("refined", Role::Refined),
    ("records", Role::Records),
    ("given", Role::Given),
    ("given_sets", Role::GivenSets),
    ("chosen", Role::Chosen),
    ("wanted_steps", Role::WantedSteps),
    ("light_volume", Role::LightVolume),
    ("volume_bricks", Role::VolumeBricks),
    ("light_sums", Role::LightSums),
    ("light_reaches", Role::LightReaches),
];

/// Bindings of the state are named by a part and a slot, such as `x_in`.
const STATE: [(&str, StatePart); 4] =
    [("x", StatePart::X), ("v", StatePart::V), ("w", StatePart::W), ("state", StatePart::All)];
const SLOTS: [(&str, Slot); 7] = [
    ("in", Slot::Input),
    ("out", Slot::Output),
    ("start", Slot::Start),
    ("end", Slot::End),
    ("0", Slot::Fixed(0)),
    ("1", Slot::Fixed(1)),
    ("2", Slot::Fixed(2)),
];

/// Textures of the scene's pictures have this name and a number.
pub(super) const PICTURE: &str = "image";

impl Role {
    /// Of a binding of the renderer's own.
    pub(super) fn of_renderer(name: &str) -> Option<Self> {
        let state = || {
            let (part, slot) = name.rsplit_once('_')?;
            let (_, part) = STATE.iter().find(|(own, _)| *own == part)?;
            let (_, slot) = SLOTS.iter().find(|(own, _)| *own == slot)?;
            Some(Self::State(*part, *slot))
        };
        let role = ROLES.into_iter().find_map(|(own, role)| (own == name).then_some(role));
        role.or_else(state)
    }

    /// Does each dispatch see a section of its own of the buffer?
    #[must_use]
    pub fn is_per_dispatch(&self) -> bool {
        matches!(self, Self::Parameters | Self::Arguments(_))
    }
}

impl fmt::Display for Role {
    /// As the WGSL has it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of_state = |part, slot| {
            let part = STATE.iter().find(|(_, own)| *own == part)?.0;
            Some((part, SLOTS.iter().find(|(_, own)| *own == slot)?.0))
        };
        match self {
            Self::Uniforms(entry) => write!(f, "uniforms of {entry}"),
            Self::Scene(value) => write!(f, "{}", value.name),
            Self::Picture(k) => write!(f, "{PICTURE}_{k}"),
            Self::State(part, slot) => {
                let (part, slot) = of_state(*part, *slot).unwrap_or_default();
                write!(f, "{part}_{slot}")
            }
            role => f.write_str(ROLES.iter().find(|(_, own)| own == role).map_or("other", |(name, _)| name)),
        }
    }
}

impl SceneValue {
    /// A name of a region's parts has a copy for each kind of region, with the kind at its end.
    pub(super) fn of(name: &str) -> Self {
        let copy = name.rsplit_once('_').and_then(|(own, kind)| Some((own, kind.parse().ok()?)));
        let (name, region) = copy.unwrap_or((name, 0));
        Self { name: name.to_owned(), region }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::all_parts;
    use crate::program::bindings::is_of_pixels;
    use crate::program::declarations::declarations;
    use crate::program::tokens::Tokens;

    /// The variables that parts of passes bind, each with its declaration.
    fn bound() -> Vec<(String, String)> {
        let parts = all_parts().into_iter().filter(|part| !part.file.starts_with("ceiling"));
        let variables = parts.flat_map(|part| {
            let own = declarations(Tokens::of(part.text)).unwrap().into_iter().filter(|own| {
                own.keyword() == "var"
                    && matches!(own.space(), None | Some("uniform" | "storage"))
                    && !is_of_pixels(own)
            });
            own.map(|own| (own.name().to_owned(), own.tokens.text())).collect::<Vec<_>>()
        });
        variables.collect()
    }

    #[test]
    fn every_binding_of_a_part_has_a_role() {
        for (name, text) in bound() {
            let is_read = text.contains("var<uniform>") || text.contains("var<storage, read>");
            let value = SceneValue::of(&name);
            let is_scene_value = is_read && value == SceneValue { name: name.clone(), region: 0 };
            assert!(Role::of_renderer(&name).is_some() || is_scene_value, "`{name}`: {value:?}");
        }
    }

    #[test]
    fn every_row_of_the_tables_is_a_binding_of_a_part() {
        let bound = bound();
        let is_bound = |name: &str| bound.iter().any(|(own, _)| own == name);
        for name in ROLES.iter().map(|(name, _)| *name).filter(|name| *name != "pixels") {
            assert!(is_bound(name), "{name}");
            assert_eq!(Role::of_renderer(name).unwrap().to_string(), name);
        }
        let slots = || SLOTS.iter().map(|(slot, _)| *slot);
        for (part, _) in STATE {
            assert!(slots().any(|slot| is_bound(&format!("{part}_{slot}"))), "{part}");
        }
        for slot in slots() {
            assert!(STATE.iter().any(|(part, _)| is_bound(&format!("{part}_{slot}"))), "{slot}");
        }
    }

    #[test]
    fn copies_of_a_regions_values_are_told_apart() {
        let copy = |name: &str, region| SceneValue { name: name.to_owned(), region };
        assert_eq!(SceneValue::of("profile"), copy("profile", 0));
        assert_eq!(SceneValue::of("profile_12"), copy("profile", 12));
        assert_eq!(SceneValue::of("index_samples"), copy("index_samples", 0));
    }
}
