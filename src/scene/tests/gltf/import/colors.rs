//! Tests of vertex colors in glTF files, which multiply the base color according to the specification.

use glam::DVec3;
use serde_json::{Value, json};

use super::super::{Made, SQUARE};
use super::{Case, pbr};
use crate::model::material::Phong;
use crate::scene::{Material, Pattern, Scene, Substance};

/// Returns a square for each material index and number of colors.
fn squares(materials: &[Value], shown: &[(usize, usize)]) -> Case {
    let mut made = Made::default();
    let positions = made.floats(&SQUARE);
    let colors = made.floats(&[[0.25, 0.5, 1.0]; 4]);
    made.accessors.push(made.accessors[colors].clone());
    made.accessors[colors + 1]["count"] = json!(3);
    let attributes = |accessor: usize| match accessor {
        0 => json!({ "POSITION": positions }),
        which => json!({ "POSITION": positions, "COLOR_0": colors + which - 1 }),
    };
    let meshes = shown.iter().map(|(material, colors)| {
        json!({ "primitives": [{ "attributes": attributes(*colors), "mode": 5, "material": material }] })
    });
    let nodes = (0..shown.len()).map(|i| json!({ "mesh": i, "name": format!("n{i}"), "translation": [0, 0, i] }));
    let rest = json!({
        "nodes": nodes.collect::<Vec<_>>(),
        "meshes": meshes.collect::<Vec<_>>(),
        "materials": materials,
    });
    Case::of(&made, &rest)
}

fn of(scene: &Scene, object: usize) -> &Material {
    let Substance::Opaque(material) = scene.objects[object].substance else { panic!("object {object} is clear") };
    &scene.materials[material]
}

fn times_vertex_colors(pattern: Pattern) -> Pattern {
    Pattern::VertexColors(Box::new(pattern))
}

#[test]
fn vertex_colors_multiply_the_base_color() {
    let unlit = json!({ "extensions": { "KHR_materials_unlit": {} } });
    let case = squares(&[pbr(0.0, 1.0), pbr(1.0, 0.0), unlit], &[(0, 1), (0, 0), (0, 1), (1, 1), (2, 1)]);
    let scene = case.scene();
    let base = Pattern::Constant(DVec3::new(0.5, 0.25, 0.125));
    // One material is used with vertex colors and without.
    assert_eq!(of(&scene, 0).color, times_vertex_colors(base.clone()));
    assert_eq!(of(&scene, 1).color, base);
    assert_eq!(scene.objects[0].substance, scene.objects[2].substance);
    assert_eq!(of(&scene, 3).color, times_vertex_colors(base));
    assert_eq!(of(&scene, 4).color, times_vertex_colors(Pattern::Constant(DVec3::ONE)));
    assert_eq!(scene.unused_vertex_colors(), None);
    assert!(!case.imported.left_out.join("\n").contains("vertex"), "{:?}", case.imported.left_out);
}

/// Checks that the highlight of a rough metal has one color, which is not a vertex color.
#[test]
fn highlights_of_rough_metals_are_gray_where_colors_vary() {
    let scene = squares(&[pbr(1.0, 0.5)], &[(0, 1)]).scene();
    assert_eq!(of(&scene, 0).color, times_vertex_colors(Pattern::Constant(0.5 * DVec3::new(0.5, 0.25, 0.125))));
    assert_eq!(of(&scene, 0).surface.downcast::<Phong>().expect("phong").specular, DVec3::splat(0.3));
}

#[test]
fn vertex_colors_that_cannot_be_used_are_named() {
    let case = squares(&[pbr(0.0, 1.0)], &[(0, 2)]);
    assert_eq!(of(&case.scene(), 0).color, Pattern::Constant(DVec3::new(0.5, 0.25, 0.125)));
    let told = case.imported.left_out.join("\n");
    assert!(told.contains("not imported: vertex colors that cannot be used (of `n0`)"), "{told}");
}
