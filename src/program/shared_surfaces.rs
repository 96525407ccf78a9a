//! Objects whose surfaces touch.
//!
//! *Theory.* Where surfaces coincide, a ray meets them all at once, but rounding decides which of them its search finds first.
//! From there a scattered ray could slip under an opaque surface, or see an air gap that does not exist. Scenes in
//! which objects touch link the module that looks for the other surfaces at a hit.
//!
//! *Practice.* Every object of these lists is tested at every scattering surface; scenes without such objects pay nothing. Meshes are
//! in none of the lists, because it is not known whether a point is on a mesh: a ray meets a mesh and an object on it separately.

use crate::scene::Scene;

/// Objects, as indices into the scene's objects, whose surfaces may touch the surface of another object that light passes through.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Touching {
    /// The objects that end or reflect rays.
    pub opaque: Vec<usize>,
    /// The objects that light passes through.
    pub clear: Vec<usize>,
}

impl Touching {
    /// Finds the objects that touch the objects `clear`. A mesh that light passes through may rest on an opaque object.
    pub(super) fn of(scene: &Scene, clear: &[usize]) -> Self {
        let objects = &scene.objects;
        let touches = |i: usize, j: usize| i != j && objects[i].may_touch(&objects[j]);
        let is_clear = |i: usize| objects[i].interior().is_some();
        let is_mesh = |i: usize| objects[i].shape.mesh().is_some();
        let all = 0..objects.len();
        let opaque = all.filter(|&j| !is_clear(j) && clear.iter().any(|&i| touches(i, j))).collect();
        let shapes: Vec<usize> = clear.iter().copied().filter(|&i| !is_mesh(i)).collect();
        let clear = shapes.iter().copied().filter(|&j| shapes.iter().any(|&i| touches(i, j))).collect();
        Self { opaque, clear }
    }

    /// Returns the number of these objects.
    #[must_use]
    pub fn count(&self) -> usize {
        self.opaque.len() + self.clear.len()
    }
}
