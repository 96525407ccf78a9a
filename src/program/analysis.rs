//! The analysis of a scene for its program, done once: its regions, the objects that touch, and the shapes that segments search.

use super::{Regions, Structure};
use crate::scene::Scene;

/// The result of analyzing a scene.
#[derive(Debug, Clone, Default)]
pub struct Analysis {
    /// The space outside all objects, and the inside of each object that light passes through.
    pub regions: Regions,
    /// The shapes that are in an acceleration structure.
    pub structure: Structure,
}

impl Analysis {
    /// Analyzes a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let regions = Regions::of(scene);
        let structure = Structure::of(scene, &regions);
        Self { regions, structure }
    }
}
