//! Packs the surface data of meshes into the words of `shaders/shape/triangle.wgsl`: triangles, then vertices.

use super::Geometry;
use crate::program::constant;
use crate::scene::Scene;

/// Returns the number of words per triangle and per vertex.
fn sizes(colored: bool) -> [usize; 2] {
    let triangle = constant("shape/triangle", "TRIANGLE_WORDS") as usize;
    let color = constant("surface/vertex_colors", "COLOR_WORD") as usize;
    [triangle, if colored { color + 3 } else { color }]
}

/// Returns the number of words of all meshes.
pub(super) fn count(geometry: &Geometry, colored: bool) -> usize {
    let [triangle, vertex] = sizes(colored);
    triangle * geometry.triangles.len() + vertex * geometry.vertices.len()
}

/// Returns the words of the scene's meshes, with vertex colors if `colored`.
pub(super) fn words(geometry: &Geometry, scene: &Scene, colored: bool) -> Vec<u32> {
    let mut words = Vec::with_capacity(count(geometry, colored));
    let [triangle, vertex] = sizes(colored);
    let place = |corner: u32| (triangle * geometry.triangles.len() + vertex * corner as usize) as u32;
    for [a, b, c, object] in &geometry.triangles {
        words.extend([a, b, c].map(|corner| place(*corner)));
        words.extend([*object, geometry.materials.get(*object as usize).copied().unwrap_or(0)]);
    }
    let mut colors = colored.then(|| geometry.vertex_colors(scene));
    for own in &geometry.vertices {
        words.extend(own.normal.to_array().into_iter().chain(own.uv.to_array()).map(f32::to_bits));
        if let Some(color) = colors.as_mut().and_then(Iterator::next) {
            words.extend(color.to_array().map(f32::to_bits));
        }
    }
    words
}
