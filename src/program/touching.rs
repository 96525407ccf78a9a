//! Objects whose surfaces lie on each other.
//!
//! *Theory.* Where surfaces lie on each other a ray meets them all at once, but its walk finds one of them first, by rounding
//! alone; from there a ray that goes on could slip under an opaque surface, or see a gap of air that is not there. Scenes in
//! which objects touch link the part that looks for the others where a ray has met one.
//!
//! *Practice.* Every object of these lists is asked at every surface that a ray goes on from; scenes without any pay nothing.
//! Meshes are in none of the lists, for nothing says where in a mesh a point is: what lies on a mesh still meets it apart.

use crate::scene::Scene;

/// Objects, as indices into the scene's, whose surfaces may lie on that of another that light goes through.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Touching {
    /// Those that end or reflect rays.
    pub opaque: Vec<usize>,
    /// Those that light goes through.
    pub clear: Vec<usize>,
}

impl Touching {
    /// Of the objects `clear` with all others. A mesh that light goes through may stand on what is opaque.
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

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.opaque.len() + self.clear.len()
    }
}
