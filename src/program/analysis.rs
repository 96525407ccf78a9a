//! What a scene is to its program, found once and handed on: its regions, which objects touch, and what segments search.

use super::{Regions, Structure};
use crate::scene::Scene;

/// What was found of a scene.
#[derive(Debug, Clone, Default)]
pub struct Analysis {
    /// The space outside of everything, and the inside of each object that light goes through.
    pub regions: Regions,
    /// Which shapes stand in a structure.
    pub structure: Structure,
}

impl Analysis {
    /// Of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let regions = Regions::of(scene);
        let structure = Structure::of(scene, &regions);
        Self { regions, structure }
    }
}
