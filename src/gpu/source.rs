//! What the values of a scene's bindings are read from.

use super::{Geometry, LightField};
use crate::model::Binding;
use crate::program::Program;
use crate::scene::Scene;

/// A scene, and what has been found out about it.
pub(super) struct Source<'a> {
    pub(super) scene: &'a Scene,
    pub(super) geometry: &'a Geometry,
    pub(super) program: &'a Program,
    /// Of each light that has a grid.
    pub(super) fields: &'a [LightField],
    /// K: segments of one fused pass.
    pub(super) segments: u32,
    /// What the scene's kinds feed their own parts.
    pub(super) kinds: Vec<Binding>,
}
