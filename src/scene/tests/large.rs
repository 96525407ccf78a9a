//! Tests of meshes far from the origin of their file, such as map coordinates: small details stay in place.

use std::fmt::Write as _;

use glam::{DVec3, Vec3};
use serde_json::json;

use super::gltf::Made;
use crate::scene::import::import;
use crate::scene::{Gltf, Mesh, Scene};

/// A position in UTM coordinates, in meters.
const PLACE: DVec3 = DVec3::new(448_262.123, 5_411_932.678, 96.54321);
/// The corners of a triangle around the position.
const CORNERS: [DVec3; 3] = [DVec3::new(-1.0, -1.0, 0.0), DVec3::new(1.0, -1.0, 0.25), DVec3::new(0.015_625, 1.0, 0.0)];

fn places() -> [DVec3; 3] {
    CORNERS.map(|corner| PLACE + corner)
}

fn obj() -> Vec<u8> {
    // An unused point has no effect.
    let mut text = "v 0 0 0\n".to_owned();
    for DVec3 { x, y, z } in places() {
        writeln!(text, "v {x} {y} {z}").expect("written");
    }
    (text + "f 2 3 4\n").into_bytes()
}

fn stl() -> Vec<u8> {
    let mut text = "solid a\nfacet normal 0 0 1\nouter loop\n".to_owned();
    for DVec3 { x, y, z } in places() {
        writeln!(text, "vertex {x} {y} {z:e}").expect("written");
    }
    (text + "endloop\nendfacet\nendsolid a\n").into_bytes()
}

fn ply(format: &str) -> Vec<u8> {
    let header = format!(
        "ply\nformat {format} 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n\
         property list uchar int vertex_indices\nend_header\n"
    );
    let numbers = places().into_iter().flat_map(|place| place.to_array());
    let body = match format {
        "ascii" => {
            let lines = places().map(|DVec3 { x, y, z }| format!("{x} {y} {z}\n"));
            format!("{}3 0 1 2\n", lines.concat()).into_bytes()
        }
        "binary_big_endian" => {
            let faces = [3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2];
            numbers.flat_map(f64::to_be_bytes).chain(faces).collect()
        }
        _ => numbers.flat_map(f64::to_le_bytes).chain([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]).collect(),
    };
    [header.into_bytes(), body].concat()
}

/// Returns the triangle in a node at the position.
fn glb(node: &serde_json::Value) -> Vec<u8> {
    let mut made = Made::default();
    made.floats(&CORNERS.map(|corner| corner.as_vec3().to_array()));
    let mut node = node.clone();
    node["mesh"] = json!(0);
    made.glb(&json!({ "nodes": [node], "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }] }))
}

/// Returns the corners of a scene's only object, in scene coordinates.
fn corners(scene: &Scene) -> Vec<DVec3> {
    let object = &scene.objects[0];
    let mesh = object.shape.mesh().expect("a mesh");
    mesh.vertices.iter().map(|vertex| object.transform.0.transform_point3(vertex.position.as_dvec3())).collect()
}

/// Ten times the error of a 64-bit number at that position, plus the error of a 32-bit number within two units of it.
const NEAR: f64 = 10.0 * (5.5e6 * f64::EPSILON + 2.0 * 1.2e-7);

#[test]
fn a_mesh_far_away_that_is_moved_to_the_origin_is_where_it_belongs() {
    let folder = tempfile::tempdir().expect("a folder");
    let [x, y, z] = PLACE.to_array();
    let turn = json!([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]);
    for (name, bytes, keys) in [
        ("a.obj", obj(), ""),
        ("a.stl", stl(), ""),
        ("a.ply", ply("ascii"), ""),
        ("b.ply", ply("binary_little_endian"), ""),
        ("c.ply", ply("binary_big_endian"), ""),
        ("a.glb", glb(&json!({ "translation": [x, y, z] })), ""),
        ("b.glb", glb(&json!({ "matrix": turn })), "node = 0\n"),
        ("c.glb", glb(&json!({ "translation": [x, y, z] })), "node = 0\nprimitive = 0\n"),
    ] {
        std::fs::write(folder.path().join(name), bytes).expect("written");
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = 9 }}\n[materials.m]\n[[objects]]\nshape = \"mesh\"\nfile = \"{name}\"\n{keys}\
             material = \"m\"\ntranslate = [{}, {}, {}]\n",
            -x, -y, -z
        );
        let scene =
            Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|e| panic!("{name}: {e}"));
        for (found, expected) in corners(&scene).into_iter().zip(CORNERS) {
            assert!(found.abs_diff_eq(expected, NEAR), "{name}: {found} and not {expected}");
        }
    }
}

#[test]
fn positions_of_32_bits_stay_exact_about_another_origin() {
    let corners = [[1000.1_f32, 0.3, -7.0], [1001.7, 0.3, -7.0], [1000.1, 1.1, -7.7]];
    let lines = corners.map(|[x, y, z]| format!("v {x} {y} {z}\n"));
    let text = format!("{}f 1 2 3\n", lines.concat());
    let mesh = Mesh::parse(&text, std::path::Path::new("a.obj")).unwrap_or_else(|error| panic!("{error}"));
    // The y axis keeps the file's origin, which is close.
    assert!(mesh.origin.x > 1000.0 && mesh.origin.y == 0.0 && mesh.origin.z < -7.0, "{}", mesh.origin);
    for (vertex, corner) in mesh.vertices.iter().zip(corners) {
        assert_eq!((mesh.origin + vertex.position.as_dvec3()).as_vec3(), Vec3::from(corner));
    }
}

#[test]
fn an_imported_scene_keeps_the_digits_of_far_places() {
    let folder = tempfile::tempdir().expect("a folder");
    let [x, y, z] = PLACE.to_array();
    let path = folder.path().join("a.glb");
    let bytes = glb(&json!({ "translation": [x, y, z] }));
    std::fs::write(&path, &bytes).expect("written");
    let file = Gltf::open(bytes, &path).unwrap_or_else(|error| panic!("{error}"));
    let imported = import(&file, &folder.path().join("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    let scene = Scene::parse(&imported.text, &folder.path().join("scene.toml"), &[])
        .unwrap_or_else(|error| panic!("{}\n{error}", imported.text));
    let middle = PLACE + DVec3::new(0.0, 0.0, 0.125);
    assert!(scene.rays.bounding_sphere.center.abs_diff_eq(middle, 1e-6), "{}", imported.text);
    for (found, expected) in corners(&scene).into_iter().zip(places()) {
        assert!(found.abs_diff_eq(expected, NEAR), "{found} and not {expected}");
    }
}

#[test]
fn a_medium_in_a_mesh_is_about_the_origin_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("a.obj"), obj()).expect("written");
    let [x, y, z] = PLACE.to_array();
    let text = format!(
        "[rays]\nbounding_sphere = {{ radius = 9 }}\n[materials.m]\n[[objects]]\nshape = \"mesh\"\nfile = \"a.obj\"\nmaterial = \"m\"\n\
         translate = [{}, {}, {}]\n",
        -x, -y, -z
    );
    let scene = Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"));
    let object = &scene.objects[0];
    let center = object.shape.surroundings(&object.transform).center;
    assert!(center.abs_diff_eq(-PLACE, NEAR), "{center}");
}
