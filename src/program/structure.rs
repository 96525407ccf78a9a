//! Which shapes stand in a structure that segments search, and which in lists that they walk.
//!
//! *Practice.* Few shapes are tested fastest one after the other, from lists of a length that the compiler knows, written out
//! without a loop; many of a kind, and all meshes, in a hierarchy. Surfaces that rays go on from stay in lists: they are told apart
//! by side, and there are no more of them than a set of regions has bits.

use super::plan::{shape_kind, shape_kinds};
use super::regions::Regions;
use crate::scene::{Accelerate, Scene, Shape};

/// How a structure is searched: the name of its part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Search {
    /// A hierarchy of boxes.
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

/// Up to so many shapes stand in lists. On lavapipe sixteen spheres take the same time by lists written out and by hierarchy, as
/// many shapes of four kinds 0.8 of it.
const FEW: usize = 16;
/// More shapes of a kind than this are in a hierarchy where the scene does not say. On lavapipe spheres take the same time by list
/// and by hierarchy up to eight, 1.4 times as long by list from sixteen on.
const MANY: usize = 6;
/// More than this are no list of a uniform any more.
const LONG: usize = 512;

/// A scene's structure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Structure {
    /// How it is searched.
    pub search: Search,
    /// The kinds of shape whose opaque objects are in it; of meshes all.
    pub kinds: Vec<&'static str>,
    /// Are lists written out item by item, rather than walked in a loop?
    pub written_out: bool,
}

impl Structure {
    /// That of `scene`.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let regions = Regions::of(scene);
        let listed = || {
            let opaque = scene.objects.iter().enumerate().filter(|(i, _)| regions.bit(*i).is_none());
            opaque.map(|(_, object)| object)
        };
        let count = |kind: &str| listed().filter(|o| shape_kind(&o.shape, &o.transform) == kind).count();
        let shapes = listed().filter(|object| !matches!(object.shape, Shape::Mesh(_))).count();
        let meshes = scene.objects.iter().filter(|object| matches!(object.shape, Shape::Mesh(_)));
        let (search, least) = match scene.rays.accelerate {
            Accelerate::Auto => (Search::Hierarchy, if shapes <= FEW { FEW } else { MANY } + 1),
            Accelerate::Hierarchy => (Search::Hierarchy, 1),
            Accelerate::Grid => (Search::Grid, 1),
            Accelerate::None => (Search::List, LONG + 1),
        };
        let kinds = shape_kinds(listed().chain(meshes));
        Self {
            search,
            kinds: kinds.into_iter().filter(|kind| *kind == "triangle" || count(kind) >= least).collect(),
            written_out: scene.rays.accelerate == Accelerate::Auto,
        }
    }

    /// Are its items those of a single kind, in that kind's own order?
    #[must_use]
    pub fn in_order(&self) -> bool {
        self.kinds.len() == 1 && self.search == Search::Hierarchy
    }

    /// Is an opaque object of this kind in it?
    #[must_use]
    pub fn holds(&self, kind: &str) -> bool {
        self.kinds.contains(&kind)
    }
}

/// How far a search of a built structure may go.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Extent {
    /// Nodes or cells on one way through it, at most.
    pub places: u64,
    /// Items met on it, at most.
    pub items: u64,
    /// Items tested in one place, at most: a walk stops between places.
    pub at_once: u64,
}
