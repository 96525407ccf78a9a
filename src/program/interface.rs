//! Roles of bindings: the one table that relates the names of WGSL variables to the host's resources.
//!
//! *Idea.* The host creates a resource for every binding of a pass. The purpose of a binding is determined once, when its program is
//! reflected; after that the host matches on its [`Role`] and never on a name. The tables below contain the renderer's bindings;
//! a test compares them with the modules. They do not contain the scene's bindings, because each kind of law, medium or shape has its
//! own: a read-only binding that is in no table is a value of the scene, named as in its module.

use std::fmt;

/// The purpose of a binding.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// The scene's uniforms in one block, for the pass with this entry point.
    Uniforms(String),
    /// A list of the scene.
    Scene(SceneValue),
    /// An image of the scene, by its index.
    Picture(usize),
    /// The state of every pixel's ray.
    State(StatePart, Slot),
    /// The per-pixel values of the passes, members of one struct.
    Pixels,
    /// The sums over the samples of an adaptive image.
    Moments,
    /// The pixels that a pass processes, or the pixels that it leaves to a later pass.
    List(Access),
    /// The arguments of indirect dispatches over that list.
    Arguments(Access),
    /// The parameters of one dispatch.
    Parameters,
    /// The parameters of a tile and a sample.
    Frame,
    /// Sums over all rays.
    Tally,
    /// The number of pixels that need more samples.
    Refined,
    /// The rays of the grid.
    GridRays,
    /// The cells of that grid that have starlight, behind the arguments of a dispatch over them.
    StarWork(Access),
    /// The first image of a star in each cell.
    StarHeads,
    /// The images of stars.
    StarImages,
    /// The numbers of images of stars.
    StarCounts,
    /// The end states of traced rays.
    Records,
    /// The ends of an image's paths.
    PathEnds,
    /// The start states of traced rays.
    Given,
    /// The regions in which traced rays start.
    GivenSets,
    /// The pixels of the image that are traced.
    Chosen,
    /// The number of steps that each pixel's ray takes, for measurements.
    WantedSteps,
    /// The voxels in which the paths of a light deposit their light.
    LightVolume,
    /// The voxels that are refined into bricks.
    VolumeBricks,
    /// The light that is deposited in the voxels.
    LightSums,
    /// A flag that a path has deposited light.
    LightReaches,
    /// None of these roles, and of no pass; a custom kernel binds it by its number.
    Other {
        /// The position of its declaration in the linked program, in bytes.
        at: usize,
    },
}

/// A value of the scene, as declared by a module.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct SceneValue {
    /// The name in the module.
    pub name: String,
    /// The kind of region that it belongs to; 0 if all regions share it.
    pub region: usize,
}

/// A part of a ray's state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum StatePart {
    /// The position, and the path's parameter.
    X,
    /// The velocity, and the size of the step.
    V,
    /// The other values of the state.
    W,
    /// All three parts, in 64 bits.
    All,
}

/// A slot of the state that a binding accesses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slot {
    /// The state that the pass reads.
    Input,
    /// The state that the pass writes.
    Output,
    /// The start of a segment.
    Start,
    /// The end of a segment.
    End,
    /// A slot that is equal in every dispatch.
    Fixed(usize),
}

/// The access of a pass to a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Access {
    /// The pass processes the list.
    Read,
    /// The pass appends to the list.
    Write,
}

/// The renderer's bindings.
const ROLES: [(&str, Role); 26] = [
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
    ("grid_rays", Role::GridRays),
    ("star_work_in", Role::StarWork(Access::Read)),
    ("star_work_out", Role::StarWork(Access::Write)),
    ("star_heads", Role::StarHeads),
    ("star_images", Role::StarImages),
    ("star_counts", Role::StarCounts),
    ("records", Role::Records),
    ("stored_ends", Role::PathEnds),
    ("given", Role::Given),
    ("given_sets", Role::GivenSets),
    ("chosen", Role::Chosen),
    ("wanted_steps", Role::WantedSteps),
    ("light_volume", Role::LightVolume),
    ("volume_bricks", Role::VolumeBricks),
    ("light_sums", Role::LightSums),
    ("light_reaches", Role::LightReaches),
];

/// The parts of the state; bindings are named by a part and a slot, such as `x_in`.
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

/// The prefix of the names of the textures of the scene's images; their number follows.
pub(super) const PICTURE: &str = "image";

impl Role {
    /// Returns the role of one of the renderer's bindings, or `None` for other names.
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

    /// Returns `true` if each dispatch uses a separate section of the buffer.
    #[must_use]
    pub fn is_per_dispatch(&self) -> bool {
        matches!(self, Self::Frame | Self::Parameters | Self::Arguments(_))
    }
}

impl fmt::Display for Role {
    /// Writes the role by its name in WGSL.
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
    /// Splits a name in WGSL: each kind of region has a copy of the names of its modules, with the kind as a suffix.
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

    /// Returns the variables that the modules of passes bind, each with its declaration.
    fn bound() -> Vec<(String, String)> {
        let parts = all_parts().into_iter().filter(|part| !part.file.starts_with("device_speed"));
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
