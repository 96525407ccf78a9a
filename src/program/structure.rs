//! The choice of the shapes that are in an acceleration structure, and of the shapes in lists.
//!
//! *Practice.* A few shapes are tested fastest one after the other, from lists of known length, unrolled; many shapes of a kind, and
//! all meshes, are fastest in a hierarchy. Surfaces that scatter rays are always in lists: they are distinguished
//! by side, and there are at most as many of them as a set of regions has bits.

use std::collections::HashSet;
use std::sync::Arc;

use super::regions::{RegionKind, Regions};
use super::{ProgramError, constant};
use crate::model::shape::Primitive;
use crate::scene::{Accelerate, Object, Scene, Segment};

/// The largest number of triangles in copies of meshes; beyond it, meshes are instanced. On a CPU copies are
/// up to twice as fast, because no ray is mapped to the meshes' object spaces; this many copies take 30 MB.
const COPIES: usize = 1 << 18;

/// The way in which an acceleration structure is searched.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Search {
    /// A bounding volume hierarchy.
    #[default]
    Hierarchy,
    /// A uniform grid.
    Grid,
    /// One item after the other.
    List,
}

impl Search {
    /// Returns the name of its file in `shaders/segment/structure/`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Hierarchy => "bvh",
            Self::Grid => "grid",
            Self::List => "list",
        }
    }
}

/// The largest number of shapes that are all kept in lists. On a CPU sixteen spheres take equal time in unrolled lists and in a hierarchy;
/// sixteen shapes of four kinds take 0.8 times as long in lists.
const FEW: usize = 16;
/// By default, more shapes of a kind than this are in a hierarchy. On a CPU up to eight spheres take equal time in a list
/// and in a hierarchy, and sixteen or more take 1.4 times as long in a list.
const MANY: usize = 6;
/// The largest number of entries of a list in a uniform.
const LONG: usize = 512;

/// The largest number of loop iterations of a traversal that fits into the room of every segment.
const LONG_WALK: u64 = 4_000;
/// The largest number of items that a hierarchy's leaf, or a primitive, has bits for.
const MOST_ITEMS: u64 = 1 << 28;
/// The largest number of items of instanced meshes, over all instances, and of nodes; one value is reserved for no item.
const MOST_ONCE: u64 = (1 << 31) - 1;

/// The largest number of shapes in lists that a mask has bits for, next to the bits of the acceleration structure.
const BITS: usize = 31;

/// The number of parts of an acceleration structure with a bounding sphere each, to find the parts near a segment.
pub const PARTS: usize = 8;

/// The acceleration structure of a scene.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Structure {
    /// The way in which it is searched.
    pub search: Search,
    /// The solids whose opaque objects are in it; all objects with meshes are in it.
    pub solids: Vec<&'static Primitive>,
    /// Whether lists are unrolled item by item, instead of traversed in a loop.
    pub written_out: bool,
    /// Whether the shapes near a segment are found first, for all lists and the structure at once.
    pub near: bool,
    /// Whether meshes are instanced: each mesh is stored once for all its objects.
    pub once: bool,
}

impl Structure {
    /// Chooses the structure of `scene` with these regions.
    #[must_use]
    pub(super) fn of(scene: &Scene, regions: &Regions) -> Self {
        let listed = || {
            let opaque = scene.objects.iter().enumerate().filter(|(i, _)| regions.bit(*i).is_none());
            opaque.map(|(_, object)| object).filter(|object| object.travel.is_none())
        };
        let count = |solid: &Primitive| listed().filter(|object| object.solid() == solid).count();
        let shapes = listed().filter(|object| object.shape.mesh().is_none()).count();
        let meshes = scene.objects.iter().filter(|object| object.shape.mesh().is_some());
        let (search, least) = match scene.rays.acceleration {
            Accelerate::Auto => (Search::Hierarchy, if shapes <= FEW { FEW } else { MANY } + 1),
            Accelerate::Hierarchy => (Search::Hierarchy, 1),
            Accelerate::Grid => (Search::Grid, 1),
            Accelerate::None => (Search::List, LONG + 1),
        };
        let solids = solids(listed().chain(meshes));
        let is_held = |solid: &&Primitive| solid.lists.is_none() || count(solid) >= least;
        let solids: Vec<_> = solids.into_iter().filter(is_held).collect();
        // Straight rays and random paths have few segments, most of which end on an object. Then it costs more to find the shapes near a
        // segment than to test them all.
        let meets = scene.rays.path_tracing.is_some() || regions.kinds.iter().all(RegionKind::is_line);
        let in_lists = listed().filter(|object| !solids.contains(&object.solid())).count() + regions.regions.len();
        let finds_near = scene.rays.acceleration != Accelerate::None && !(meets && solids.is_empty());
        Self {
            search,
            solids,
            written_out: scene.rays.acceleration == Accelerate::Auto,
            near: finds_near && in_lists <= BITS,
            once: search == Search::Hierarchy && copies(scene) > COPIES,
        }
    }

    /// Returns `true` if all items have a single kind, and are in the order of that kind.
    #[must_use]
    pub fn in_order(&self) -> bool {
        self.solids.len() == 1 && self.search == Search::Hierarchy && !self.once
    }

    /// Returns the module that defines the order of the items.
    #[must_use]
    pub fn order(&self) -> &'static str {
        if self.once { "segment/order_placed" } else { "segment/order" }
    }

    /// Returns the names in `shaders/segment/structure/` of the modules that search it.
    #[must_use]
    pub fn parts(&self) -> &'static [&'static str] {
        match (self.search, self.once) {
            (Search::Hierarchy, true) => &["boxes", "bvh_instances"],
            (Search::Hierarchy, false) => &["boxes", "bvh"],
            (Search::Grid, _) => &["grid"],
            (Search::List, _) => &["list"],
        }
    }

    /// Returns `true` if opaque objects of this solid are in it.
    #[must_use]
    pub fn holds(&self, solid: &Primitive) -> bool {
        self.solids.contains(&solid)
    }
}

/// Returns the number of additional triangles if each object has a copy of its mesh.
fn copies(scene: &Scene) -> usize {
    let mut known = HashSet::new();
    let again =
        scene.objects.iter().filter_map(|object| object.shape.mesh()).filter(|mesh| !known.insert(Arc::as_ptr(mesh)));
    again.map(|mesh| mesh.triangles.len()).sum()
}

/// Returns the solids of some objects, sorted by name.
pub(super) fn solids<'a>(objects: impl Iterator<Item = &'a Object>) -> Vec<&'static Primitive> {
    let mut solids: Vec<_> = objects.map(Object::solid).collect();
    solids.sort_unstable_by_key(|solid| solid.name);
    solids.dedup();
    solids
}

/// The largest extent of a search of a built structure.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Extent {
    /// The largest number of nodes or cells that one search visits.
    pub places: u64,
    /// The largest number of items that one search tests.
    pub items: u64,
}

impl Extent {
    /// Checks that a primitive's bits can distinguish the structure's items.
    ///
    /// # Errors
    ///
    /// If there are too many items; the error contains the largest possible number.
    pub(super) fn check(self, structure: &Structure) -> Result<(), ProgramError> {
        let most = if structure.once { MOST_ONCE } else { MOST_ITEMS };
        let items = self.items.max(self.places);
        if items > most { Err(ProgramError::TooManyItems { items, most }) } else { Ok(()) }
    }

    /// Returns `true` if a segment's search of the structure, with the shadow rays at its end, may take many loop iterations.
    pub(super) fn is_long(self, scene: &Scene, regions: &Regions) -> bool {
        let is_arc =
            matches!(scene.rays.segment, Segment::Arc { .. }) && !regions.kinds.iter().all(RegionKind::is_line);
        let pieces = if is_arc { constant("segment/curve_arc", "MAX_PIECES") as u64 } else { 1 };
        let crossings = if scene.splits() { constant("surface/shadow/clear", "CROSSINGS") as u64 } else { 1 };
        let shadows = scene.lines().count() as u64 * crossings;
        (pieces + 2 + 2 * shadows) * (self.places + self.items) > LONG_WALK
    }
}
