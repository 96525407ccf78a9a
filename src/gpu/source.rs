//! Collects the inputs for the values of a scene's bindings.

use super::star_buckets::{StarLists, StarSkies};
use super::{Geometry, LightGridData};
use crate::model::Binding;
use crate::program::Program;
use crate::scene::Scene;

/// A scene, with the results of its analysis.
pub(super) struct Uploads<'a> {
    pub(super) scene: &'a Scene,
    pub(super) geometry: &'a Geometry,
    pub(super) program: &'a Program,
    /// The fields of the lights that have a grid.
    pub(super) fields: &'a [LightGridData],
    /// K, the number of segments of one fused pass.
    pub(super) segments: u32,
    /// The stars of both skies.
    pub(super) star_skies: StarSkies,
    /// The lists of these stars, unless they are on the device already.
    pub(super) stars: StarLists,
    /// The bindings of the scene's kinds.
    pub(super) kinds: Vec<Binding>,
}
