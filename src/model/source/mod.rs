//! Sources of force: what they are centred on, one kind a file.
//!
//! *Theory.* A force points from a ray's place to its source, and falls off with the distance from it (G95 §2.1). What a kind of
//! source decides is that way: from a centre it is x − p.
//!
//! *Practice.* [`SOURCES`] names each kind once. The WGSL contract is `offset_KIND(d, along)`, with d = x − p and `along` what the
//! kind has besides a position.

mod center;
mod line;
pub mod spheroid;

use glam::DVec3;

use super::falloff::Falloff;
use super::same::named;
use crate::document::reader::TableReader;
use crate::document::{Key, KeyReference, kind_rows};

/// Every kind of source; the first is that of a source that names none.
pub const SOURCES: [&Kind; 2] = [&center::KIND, &line::KIND];

/// Every kind of anchor: those of sources, and what captures besides.
pub const ANCHORS: [&Kind; 3] = [SOURCES[0], SOURCES[1], &spheroid::KIND];

/// What is known of a kind of source.
pub struct Kind {
    /// As a scene file has it; `offset_NAME` in `shaders/law/offset.wgsl` is its WGSL.
    pub name: &'static str,
    /// The keys that it reads besides those that all sources have.
    pub keys: &'static [Key],
    /// Reads what it has besides a position; none if that is wrong.
    pub(crate) along: fn(&TableReader) -> Option<DVec3>,
    /// The way from the source to a place, of d = x − p.
    pub offset: fn(d: DVec3, along: DVec3) -> DVec3,
    /// Is it a point, so that a ray stays in a plane through it?
    pub is_point: bool,
}

/// What a source, or a sphere that captures, is centred on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anchor {
    /// Its kind.
    pub kind: &'static Kind,
    /// A point of it.
    pub position: DVec3,
    /// What the kind has besides: 0 for a centre.
    pub along: DVec3,
}

/// A source of force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// What it is centred on.
    pub anchor: Anchor,
    /// Positive attracts, negative repels.
    pub strength: f64,
    /// How the force falls off.
    pub falloff: Falloff,
    /// A ray that comes this near moving inwards is captured; zero for none.
    pub capture: f64,
}

/// Where rays that move inwards end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capture {
    /// What it is about.
    pub anchor: Anchor,
    /// How near a ray may come.
    pub radius: f64,
}

impl Anchor {
    /// A point.
    #[must_use]
    pub fn center(position: DVec3) -> Self {
        Self { kind: &center::KIND, position, along: DVec3::ZERO }
    }

    /// The way from it to a place.
    #[must_use]
    pub fn offset(&self, x: DVec3) -> DVec3 {
        (self.kind.offset)(x - self.position, self.along)
    }

    /// The number that WGSL knows its kind by.
    #[must_use]
    pub fn code(&self) -> u32 {
        ANCHORS.iter().position(|kind| *kind == self.kind).unwrap_or(0) as u32
    }
}

impl Capture {
    /// Returns how far a place is from the surface, in the measure of its kind: below 0 within.
    #[must_use]
    pub fn distance(&self, x: DVec3) -> f64 {
        self.anchor.offset(x).length() - self.radius
    }
}

named!(Kind);

/// The reference's rows of the keys that kinds of source read.
#[must_use]
pub fn reference() -> Vec<KeyReference> {
    let chooser = ("kind", SOURCES[0].name, "shape on which the source is centered");
    kind_rows("law.sources", chooser, &SOURCES.map(|kind| (kind.name, kind.keys)))
}
