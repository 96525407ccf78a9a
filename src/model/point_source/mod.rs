//! Sources of force and their geometry; one file per kind.
//!
//! *Theory.* A force points from a ray's position to its source, and falls off with the distance from it (G95 §2.1). The kind of source
//! defines this offset: x − p for a point source.
//!
//! *Practice.* [`SOURCES`] lists each kind once. The WGSL contract is `offset_KIND(d, along)`, with d = x − p and the vector `along` that a
//! kind has in addition to its position.

mod center;
mod line;
pub mod spheroid;

use glam::DVec3;

use super::dyn_eq::named;
use super::falloff::Falloff;
use crate::document::reader::TableReader;
use crate::document::{Key, KeyReference, kind_rows};

/// The list of all kinds of source; the first is the default.
pub const SOURCES: [&SourceKind; 2] = [&center::KIND, &line::KIND];

/// The list of all kinds of anchor: those of sources, and additional ones of capture regions.
pub const ANCHORS: [&SourceKind; 3] = [SOURCES[0], SOURCES[1], &spheroid::KIND];

/// The description of a kind of source.
pub struct SourceKind {
    /// The name in a scene file; `offset_NAME` in `shaders/law/offset.wgsl` is its WGSL function.
    pub name: &'static str,
    /// The keys in addition to the keys of all sources.
    pub keys: &'static [Key],
    /// Reads the vector that the kind has in addition to a position; returns `None` after an error.
    pub(crate) along: fn(&TableReader) -> Option<DVec3>,
    /// The offset from the source to a position, as a function of d = x − p.
    pub offset: fn(d: DVec3, along: DVec3) -> DVec3,
    /// Is `true` if the source is a point, so that a ray stays in a plane through it.
    pub is_point: bool,
}

/// The geometry of a source or of a capture region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anchor {
    /// The kind of anchor.
    pub kind: &'static SourceKind,
    /// A point of the anchor.
    pub position: DVec3,
    /// The vector that the kind has in addition; 0 for a point.
    pub along: DVec3,
}

/// A source of force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// The geometry of the source.
    pub anchor: Anchor,
    /// The strength; positive values attract and negative values repel.
    pub strength: f64,
    /// The fall-off of the force.
    pub falloff: Falloff,
    /// The distance below which a ray that moves inwards is captured; zero for no capture.
    pub capture: f64,
}

/// A region in which rays that move inwards end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capture {
    /// The geometry of the region.
    pub anchor: Anchor,
    /// The radius of the region.
    pub radius: f64,
}

impl Anchor {
    /// Creates a point anchor.
    #[must_use]
    pub fn center(position: DVec3) -> Self {
        Self { kind: &center::KIND, position, along: DVec3::ZERO }
    }

    /// Returns the offset from the anchor to a position.
    #[must_use]
    pub fn offset(&self, x: DVec3) -> DVec3 {
        (self.kind.offset)(x - self.position, self.along)
    }

    /// Returns the code of the kind in WGSL.
    #[must_use]
    pub fn code(&self) -> u32 {
        ANCHORS.iter().position(|kind| *kind == self.kind).unwrap_or(0) as u32
    }
}

impl Capture {
    /// Returns the signed distance of a position from the surface, in the metric of its kind; negative inside.
    #[must_use]
    pub fn distance(&self, x: DVec3) -> f64 {
        self.anchor.offset(x).length() - self.radius
    }
}

named!(SourceKind);

/// Returns the reference rows of the keys that kinds of source read.
#[must_use]
pub fn reference() -> Vec<KeyReference> {
    let chooser = ("kind", SOURCES[0].name, "shape on which the source is centered");
    kind_rows("law.sources", chooser, &SOURCES.map(|kind| (kind.name, kind.keys)))
}
