//! Tests of vertex colors in each format, and of the error if a material needs them and they are missing.

use std::path::Path;

use glam::{DVec3, Vec3};
use serde_json::{Value, json};

use super::gltf::{Made, SQUARE};
use super::{RAYS, mistakes_of};
use crate::scene::{Mesh, Scene};

/// Values of eight bits in sRGB, and their linear values by IEC 61966-2-1.
const SRGB: [(u8, f32); 6] =
    [(0, 0.0), (10, 0.003_035_27), (64, 0.051_269_46), (128, 0.215_860_5), (188, 0.502_886_5), (255, 1.0)];

fn load(name: &str, bytes: &[u8]) -> Mesh {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("written");
    Mesh::load(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn obj(vertices: [&str; 3]) -> Mesh {
    let text = format!("v 0 0 0{}\nv 1 0 0{}\nv 0 1 0{}\nf 1 2 3\n", vertices[0], vertices[1], vertices[2]);
    Mesh::parse(&text, Path::new("a.obj")).unwrap_or_else(|error| panic!("{error}"))
}

/// Checks two of the colors above at the first vertices, and black at the third.
fn assert_srgb(mesh: &Mesh, of: &str) {
    let [first, second] = [[0, 1, 2], [3, 4, 5]].map(|color| Vec3::from_array(color.map(|i: usize| SRGB[i].1)));
    let expected = [first, second, Vec3::ZERO];
    assert_eq!(mesh.colors.len(), 3, "{of}");
    for (found, expected) in mesh.colors.iter().zip(expected) {
        assert!(found.abs_diff_eq(expected, 1e-7), "{of}: {found} and not {expected}");
    }
}

/// Returns these colors as text, each as a fraction of `white`.
fn words(white: f64, digits: usize) -> [String; 3] {
    let word = |i: usize| format!(" {:.digits$}", f64::from(SRGB[i].0) / 255.0 * white);
    [[0, 1, 2], [3, 4, 5], [0, 0, 0]].map(|color| color.map(word).concat())
}

#[test]
fn colors_of_an_obj_follow_its_coordinates() {
    let [a, b, c] = words(1.0, 17);
    assert_srgb(&obj([&a, &b, &c]), "obj");
    // Alpha and further values are ignored.
    assert_srgb(&obj([&format!("{a} 0.5"), &b, &format!("{c} 1 2")]), "obj with alpha");
    // One additional number is a weight, and two have no meaning.
    assert!(obj([" 1", " 1 1", ""]).colors.is_empty());
    // Vertices without a color are white, whether they come first or last.
    assert_eq!(obj(["", " 0 0 0", ""]).colors, [Vec3::ONE, Vec3::ZERO, Vec3::ONE]);
    // Two vertices in one position keep their colors.
    let text = "v 0 0 0 0 0 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nv 0 0 0 1 1 1\nv -1 0 0\nf 1 2 3\nf 4 3 5\n";
    let mesh = Mesh::parse(text, Path::new("a.obj")).expect("a mesh");
    let colors_of = |i: usize| mesh.triangles[i].map(|corner| mesh.colors[corner as usize]);
    assert_eq!(colors_of(0), [Vec3::ZERO; 3]);
    assert_eq!(colors_of(1), [Vec3::ONE, Vec3::ZERO, Vec3::ONE]);
}

const NAMES: [&str; 3] = ["red", "green", "blue"];

#[test]
fn colors_of_a_ply_are_properties_of_its_vertices() {
    let header = |format: &str, kind: &str, names: [&str; 3]| {
        let color = names.map(|name| format!("property {kind} {name}\n")).concat();
        format!(
            "ply\nformat {format} 1.0\nelement vertex 3\nproperty float x\nproperty float y\n{color}property float z\n\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    for (kind, white, digits) in
        [("uchar", 255.0, 0), ("int", 255.0, 0), ("ushort", 65_535.0, 0), ("float", 1.0, 17), ("double", 1.0, 17)]
    {
        let [a, b, c] = words(white, digits);
        for names in [NAMES, ["r", "g", "b"], ["diffuse_red", "diffuse_green", "diffuse_blue"]] {
            let text = header("ascii", kind, names) + &format!("0 0{a} 0\n1 0{b} 0\n0 1{c} 0\n3 0 1 2\n");
            assert_srgb(&load("a.ply", text.as_bytes()), kind);
        }
    }
    let mut bytes = header("binary_little_endian", "uchar", NAMES).into_bytes();
    for (x, y, color) in [(0.0_f32, 0.0_f32, [0, 1, 2]), (1.0, 0.0, [3, 4, 5]), (0.0, 1.0, [0, 0, 0])] {
        bytes.extend([x, y].into_iter().flat_map(f32::to_le_bytes));
        bytes.extend(color.map(|i: usize| SRGB[i].0));
        bytes.extend(0.0_f32.to_le_bytes());
    }
    bytes.push(3);
    bytes.extend([0_i32, 1, 2].into_iter().flat_map(i32::to_le_bytes));
    assert_srgb(&load("a.ply", &bytes), "bytes");
    // Two of the three channels are not a color.
    let text = header("ascii", "uchar", ["red", "green", "hue"]) + "0 0 1 2 3 0\n1 0 1 2 3 0\n0 1 1 2 3 0\n3 0 1 2\n";
    assert!(load("a.ply", text.as_bytes()).colors.is_empty());
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\nendloop\nendfacet\n";
    assert!(load("a.stl", stl.as_bytes()).colors.is_empty());
}

/// Returns a strip of two triangles with these colors, and the accessor.
fn strip(kind: u32, of: &str, bytes: Vec<u8>, is_normalized: bool) -> (Made, Value) {
    let mut made = Made::default();
    let positions = made.floats(&SQUARE);
    let colors = made.accessor(kind, of, 4, bytes);
    made.accessors[colors]["normalized"] = json!(is_normalized);
    let attributes = json!({ "POSITION": positions, "COLOR_0": colors });
    let primitive = json!({ "attributes": attributes, "mode": 5 });
    (made, json!({ "nodes": [{ "mesh": 0 }], "meshes": [{ "primitives": [primitive] }] }))
}

/// Returns the colors of a glTF file at the corners of the square.
fn at_corners(mesh: &Mesh) -> Vec<Vec3> {
    let corner = |x: [f32; 3]| mesh.vertices.iter().position(|vertex| vertex.position == Vec3::from(x));
    SQUARE.iter().map(|x| mesh.colors[corner(*x).expect("a corner")]).collect()
}

#[test]
fn colors_of_gltf_are_linear() {
    let floats = |all: &[f32]| all.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let shorts = |all: &[u16]| all.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    // The specification clamps values above 1.
    let three = [0.0, 0.25, 1.0, 0.5, 0.5, 0.5, 2.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let expected = [[0.0, 0.25, 1.0], [0.5; 3], [1.0, 0.0, 0.0], [1.0; 3]].map(Vec3::from);
    let (made, rest) = strip(5126, "VEC3", floats(&three), false);
    assert_eq!(at_corners(&load("a.glb", &made.glb(&rest))), expected);
    let four: Vec<f32> = three.chunks(3).flat_map(|color| [color[0], color[1], color[2], 0.125]).collect();
    let (made, rest) = strip(5126, "VEC4", floats(&four), false);
    assert_eq!(at_corners(&load("a.glb", &made.glb(&rest))), expected);
    let whole = [51.0, 102.0, 255.0].map(|x: f32| x / 255.0);
    let (made, rest) = strip(5121, "VEC4", [51, 102, 255, 9].repeat(4), true);
    assert_eq!(at_corners(&load("a.glb", &made.glb(&rest))), [whole.into(); 4]);
    let (made, rest) = strip(5123, "VEC4", shorts(&[13_107, 26_214, 65_535, 9].repeat(4)), true);
    let found = at_corners(&load("a.glb", &made.glb(&rest)));
    assert!(found.iter().all(|color| color.abs_diff_eq(whole.into(), 1e-7)), "{found:?}");
    // A primitive without colors is white next to one with colors.
    let (made, mut rest) = strip(5121, "VEC4", [0, 0, 0, 255].repeat(4), true);
    let primitives = rest["meshes"][0]["primitives"].as_array_mut().expect("primitives");
    primitives.insert(0, json!({ "attributes": { "POSITION": 0 }, "mode": 5 }));
    let mesh = load("a.glb", &made.glb(&rest));
    let of = |i: usize| mesh.triangles[i].map(|corner| mesh.colors[corner as usize]);
    assert_eq!([of(0), of(1), of(2), of(3)], [[Vec3::ONE; 3], [Vec3::ONE; 3], [Vec3::ZERO; 3], [Vec3::ZERO; 3]]);
}

/// Checks that files with any colors can be read, but that materials reject invalid ones.
#[test]
fn colors_that_cannot_be_used_say_why() {
    let lacks = |mesh: &Mesh| mesh.lacks_colors().expect("a reason");
    assert_eq!(lacks(&obj([""; 3])), "this mesh has no vertex colors");
    let bytes = "vertex 1, counted from 0, has the color [255, 128, 0], outside the range from 0 to 1";
    assert_eq!(
        lacks(&obj([" 0 0 1", " 255 128 0", ""])),
        format!("the vertex colors of this mesh cannot be used: {bytes}")
    );
    assert!(lacks(&obj([" 0 0 x", "", ""])).contains("vertex 0, counted from 0, has the color [0, 0, NaN]"));
    assert!(lacks(&obj(["", "", " 0 -1 0"])).contains("vertex 2, counted from 0, has the color [0, -1, 0]"));
    let faces = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n\
                 property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
                 end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9 9 9\n";
    assert!(lacks(&load("a.ply", faces.as_bytes())).ends_with("the file has colors for faces, not for vertices"));
    // Values may be rounded.
    assert_eq!(obj([" 1.000001 0 -1e-9"; 3]).colors, [Vec3::X; 3]);
    let of = "meshes[0].primitives[0].attributes.COLOR_0";
    for (kind, is_normalized, name, value, said) in [
        (5121, false, "count", json!(4), format!("{of} has integer components that are not `normalized`")),
        (5121, true, "count", json!(3), format!("{of} has 3 elements, and there are 4 vertices")),
        (5121, true, "count", json!(4000), "accessors[1] requires 4000 elements of 4 bytes".to_owned()),
        (5121, true, "type", json!("SCALAR"), format!("accessors[1] is of type Scalar, and {of} requires Vec3")),
    ] {
        let (mut made, rest) = strip(kind, "VEC4", vec![9; 16], is_normalized);
        made.accessors[1][name] = value;
        let told = lacks(&load("a.glb", &made.glb(&rest)));
        assert!(told.contains(&said), "{told}\nand not\n{said}");
    }
}

#[test]
fn a_mean_color_counts_areas() {
    // A red triangle, and a blue one with nine times its area.
    let text = "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nv 0 0 0 0 0 1\nv -3 0 0 0 0 1\nv 0 -3 0 0 0 1\nf 1 2 3\nf 4 5 6\n";
    let mesh = Mesh::parse(text, Path::new("a.obj")).expect("a mesh");
    assert!(mesh.mean_color().abs_diff_eq(DVec3::new(0.1, 0.0, 0.9), 1e-12));
    assert_eq!(obj([""; 3]).mean_color(), DVec3::ONE);
}

/// Checks that next-event estimation samples an emitter by its mean radiance, and ignores one with black vertex colors.
#[test]
fn a_lamp_is_as_bright_as_its_vertex_colors() {
    let folder = tempfile::tempdir().expect("a folder");
    let emitters = |color: &str| {
        let text = format!("v 0 0 0 {color}\nv 1 0 0 {color}\nv 0 1 0 {color}\nf 1 2 3\n");
        std::fs::write(folder.path().join("lamp.obj"), text).expect("written");
        let text = "[rays]\nbounding_sphere = { radius = 10 }\nlighting = \"path-tracing\"\n[materials.m]\nkind = \"emissive\"\n\
                    color = { color = [3, 3, 3], vertex_colors = true }\n[[objects]]\nshape = \"mesh\"\n\
                    file = \"lamp.obj\"\nmaterial = \"m\"\n";
        let scene =
            Scene::parse(text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"));
        scene.emitters()
    };
    assert!(emitters("0 0 0").is_empty());
    let [red] = emitters("1 0 0")[..] else { panic!("one emitter") };
    let expected = std::f64::consts::PI * red.radius.powi(2);
    assert!((red.power - expected).abs() < 1e-12 * expected, "{red:?}");
}

/// Parses a scene of two meshes, one with colors; the second object has these keys.
fn scene(diffuse: &str, object: &str) -> Result<Scene, crate::scene::SceneError> {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, color) in [("plain", ""), ("odd", " 2 2 2"), ("colored", " 1 0 0")] {
        let text = format!("v 0 0 0{color}\nv 1 0 0{color}\nv 0 1 0{color}\nf 1 2 3\n");
        std::fs::write(folder.path().join(format!("{name}.obj")), text).expect("written");
    }
    let text = format!(
        "{RAYS}[materials.a]\n[materials.b]\ndiffuse = {diffuse}\n[[objects]]\nshape = \"mesh\"\nfile = \"colored.obj\"\n\
         material = \"a\"\n[[objects]]\n{object}\nmaterial = \"b\"\n"
    );
    Scene::parse(&text, &folder.path().join("scene.toml"), &[])
}

#[test]
fn a_material_that_uses_colors_needs_a_mesh_that_has_them() {
    const USES: &str = "{ vertex_colors = true }";
    let mesh = |name: &str| format!("shape = \"mesh\"\nfile = \"{name}.obj\"");
    scene(USES, &mesh("colored")).unwrap_or_else(|error| panic!("{error}"));
    for (object, line, said) in [
        (mesh("plain"), 13, "the material `b` has `vertex_colors = true`, but this mesh has no vertex colors"),
        (mesh("odd"), 13, "vertex 0, counted from 0, has the color [2, 2, 2], outside the range from 0 to 1"),
        (
            "shape = \"sphere\"".to_owned(),
            12,
            "the material `b` has `vertex_colors = true`, but only meshes have vertex colors",
        ),
    ] {
        let mistakes = mistakes_of(scene(USES, &object));
        let [mistake] = &mistakes[..] else { panic!("{mistakes:?}") };
        assert!(mistake.problem.contains(said), "{mistake}\nand not\n{said}");
        assert_eq!((mistake.line, mistake.column), (line, 12), "{mistake}");
        // Without vertex colors the scene is valid.
        scene("{ vertex_colors = false, color = [1, 1, 1] }", &object).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn check_names_objects_whose_colors_are_not_used() {
    let unused = |diffuse: &str, name: &str| {
        let object = format!("shape = \"mesh\"\nfile = \"{name}.obj\"");
        scene(diffuse, &object).unwrap_or_else(|error| panic!("{error}")).unused_vertex_colors().expect("some")
    };
    let one = "objects[0] has vertex colors that its material does not use: see `vertex_colors`";
    assert_eq!(unused("{ vertex_colors = true }", "colored"), one);
    assert_eq!(unused("[1, 1, 1]", "plain"), one);
    assert!(unused("[1, 1, 1]", "colored").starts_with("objects[0], objects[1] have vertex colors"));
}
