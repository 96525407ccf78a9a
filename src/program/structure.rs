//! Which shapes stand in a structure that segments search, and which in lists that they walk.
//!
//! *Practice.* Few shapes are tested fastest one after the other, from lists of a length that the compiler knows, written out
//! without a loop; many of a kind, and all meshes, in a hierarchy. Surfaces that rays go on from stay in lists: they are told apart
//! by side, and there are no more of them than a set of regions has bits.

use std::collections::HashSet;
use std::sync::Arc;

use super::regions::{RegionKind, Regions};
use super::{ProgramError, constant};
use crate::model::shape::Solid;
use crate::scene::{Accelerate, Object, Scene, Segment};

/// More triangles than this are not copied: each mesh is kept once. On a processor copies are up to twice as fast, for no ray has to be
/// mapped to the meshes' spaces; so many take 30 MB.
const COPIES: usize = 1 << 18;

/// How a structure is searched: the name of its part.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Search {
    /// A hierarchy of boxes.
    #[default]
    Hierarchy,
    /// A uniform grid.
    Grid,
    /// One item after the other.
    List,
}

impl Search {
    /// The name of its file in `shaders/segment/structure/`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Hierarchy => "bvh",
            Self::Grid => "grid",
            Self::List => "list",
        }
    }
}

/// Up to so many shapes stand in lists. On a processor sixteen spheres take the same time by lists written out and by hierarchy, as
/// many shapes of four kinds 0.8 of it.
const FEW: usize = 16;
/// More shapes of a kind than this are in a hierarchy where the scene does not say. On a processor spheres take the same time by list
/// and by hierarchy up to eight, 1.4 times as long by list from sixteen on.
const MANY: usize = 6;
/// More than this are no list of a uniform any more.
const LONG: usize = 512;

/// Loop iterations of a walk up to which it needs no more room than every segment has.
const LONG_WALK: u64 = 4_000;
/// Items that a hierarchy's leaf, or a primitive, has bits for.
const MOST_ITEMS: u64 = 1 << 28;
/// Those of meshes that are kept once, in all their places, beside the word for nothing; and the nodes that a walk is at have bits for.
const MOST_ONCE: u64 = (1 << 31) - 1;

/// Shapes in lists that a mask has bits for, beside the structure's.
const BITS: usize = 31;

/// Parts of a structure with a ball about each, for what a segment is near.
pub const PARTS: usize = 8;

/// A scene's structure.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Structure {
    /// How it is searched.
    pub search: Search,
    /// The solids whose opaque objects are in it; of meshes all.
    pub solids: Vec<&'static Solid>,
    /// Are lists written out item by item, rather than walked in a loop?
    pub written_out: bool,
    /// Is what a segment is near found first, for all lists and the structure at once?
    pub near: bool,
    /// Is each mesh kept once, however many objects show it?
    pub once: bool,
}

impl Structure {
    /// That of `scene` with these regions.
    #[must_use]
    pub(super) fn of(scene: &Scene, regions: &Regions) -> Self {
        let listed = || {
            let opaque = scene.objects.iter().enumerate().filter(|(i, _)| regions.bit(*i).is_none());
            opaque.map(|(_, object)| object).filter(|object| object.travel.is_none())
        };
        let count = |solid: &Solid| listed().filter(|object| object.solid() == solid).count();
        let shapes = listed().filter(|object| object.shape.mesh().is_none()).count();
        let meshes = scene.objects.iter().filter(|object| object.shape.mesh().is_some());
        let (search, least) = match scene.rays.accelerate {
            Accelerate::Auto => (Search::Hierarchy, if shapes <= FEW { FEW } else { MANY } + 1),
            Accelerate::Hierarchy => (Search::Hierarchy, 1),
            Accelerate::Grid => (Search::Grid, 1),
            Accelerate::None => (Search::List, LONG + 1),
        };
        let solids = solids(listed().chain(meshes));
        let is_held = |solid: &&Solid| solid.lists.is_none() || count(solid) >= least;
        let solids: Vec<_> = solids.into_iter().filter(is_held).collect();
        let in_lists = listed().filter(|object| !solids.contains(&object.solid())).count() + regions.regions.len();
        Self {
            search,
            solids,
            written_out: scene.rays.accelerate == Accelerate::Auto,
            near: scene.rays.accelerate != Accelerate::None && in_lists <= BITS,
            once: search == Search::Hierarchy && copies(scene) > COPIES,
        }
    }

    /// Are its items those of a single kind, in that kind's own order?
    #[must_use]
    pub fn in_order(&self) -> bool {
        self.solids.len() == 1 && self.search == Search::Hierarchy && !self.once
    }

    /// The part that knows the order of its items.
    #[must_use]
    pub fn order(&self) -> &'static str {
        if self.once { "segment/order_placed" } else { "segment/order" }
    }

    /// The names in `shaders/segment/structure/` of the parts that search it.
    #[must_use]
    pub fn parts(&self) -> &'static [&'static str] {
        match (self.search, self.once) {
            (Search::Hierarchy, true) => &["boxes", "bvh_instances"],
            (Search::Hierarchy, false) => &["boxes", "bvh"],
            (Search::Grid, _) => &["grid"],
            (Search::List, _) => &["list"],
        }
    }

    /// Is an opaque object of this solid in it?
    #[must_use]
    pub fn holds(&self, solid: &Solid) -> bool {
        self.solids.contains(&solid)
    }
}

/// Triangles that a scene has more of where each object has its own copy of its mesh.
fn copies(scene: &Scene) -> usize {
    let mut known = HashSet::new();
    let again =
        scene.objects.iter().filter_map(|object| object.shape.mesh()).filter(|mesh| !known.insert(Arc::as_ptr(mesh)));
    again.map(|mesh| mesh.triangles.len()).sum()
}

/// The solids of some objects, by name.
pub(super) fn solids<'a>(objects: impl Iterator<Item = &'a Object>) -> Vec<&'static Solid> {
    let mut solids: Vec<_> = objects.map(Object::solid).collect();
    solids.sort_unstable_by_key(|solid| solid.name);
    solids.dedup();
    solids
}

/// How far a search of a built structure may go.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Extent {
    /// Nodes or cells on one way through it, at most.
    pub places: u64,
    /// Items met on it, at most.
    pub items: u64,
}

impl Extent {
    /// Checks that a primitive's word can tell the structure's items apart.
    ///
    /// # Errors
    ///
    /// Returns how many there may be.
    pub(super) fn check(self, structure: &Structure) -> Result<(), ProgramError> {
        let most = if structure.once { MOST_ONCE } else { MOST_ITEMS };
        let items = self.items.max(self.places);
        if items > most { Err(ProgramError::TooManyItems { items, most }) } else { Ok(()) }
    }

    /// May a segment's walk through the structure, with the walks of the shadows at its end, take many loop iterations?
    pub(super) fn is_long(self, scene: &Scene, regions: &Regions) -> bool {
        let is_arc =
            matches!(scene.rays.segment, Segment::Arc { .. }) && !regions.kinds.iter().all(RegionKind::is_line);
        let pieces = if is_arc { constant("segment/curve_arc", "MAX_PIECES") as u64 } else { 1 };
        let crossings = if scene.splits() { constant("surface/shadow/clear", "CROSSINGS") as u64 } else { 1 };
        let shadows = scene.lines().count() as u64 * crossings;
        (pieces + 2 + 2 * shadows) * (self.places + self.items) > LONG_WALK
    }
}
