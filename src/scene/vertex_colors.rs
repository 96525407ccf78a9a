//! Vertex colors, and warnings about vertex colors that materials do not use.

use super::{Object, Scene};

/// The largest number of objects in a message.
const NAMED: usize = 3;

impl Scene {
    /// Returns `true` if some surface is multiplied by vertex colors.
    #[must_use]
    pub fn uses_vertex_colors(&self) -> bool {
        self.used_materials().any(|material| material.color.has_vertex_colors())
    }

    /// Returns a message about objects with vertex colors that their materials do not use, or `None` if there are none.
    #[must_use]
    pub fn unused_vertex_colors(&self) -> Option<String> {
        let has_some = |object: &Object| object.shape.mesh().is_some_and(|mesh| !mesh.colors.is_empty());
        let ignores = |object: &Object| {
            self.material_of(object).is_some_and(|material| !material.color.has_vertex_colors()) && has_some(object)
        };
        let unused = self.objects.iter().enumerate().filter(|(_, object)| ignores(object));
        let unused: Vec<String> = unused.map(|(i, _)| format!("objects[{i}]")).collect();
        let names = unused.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", ");
        let more = if unused.len() > NAMED { ", …" } else { "" };
        match unused.len() {
            0 => None,
            1 => Some(format!("{names} has vertex colors that its material does not use: see `vertex_colors`")),
            _ => Some(format!("{names}{more} have vertex colors that their materials do not use: see `vertex_colors`")),
        }
    }
}
