//! Tests of meshes that are too large for a device: they are rejected as soon as their size is known, and the rest of the file is not read.

use std::fs;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use serde_json::json;

use super::gltf::Made;
use crate::assets::{Capacity, Held};
use crate::scene::{Files, Scene};

const SCENE: &str = "[rays]\nbounding_sphere = { radius = 9 }\n[materials.m]\n[[objects]]\nshape = \"mesh\"\nmaterial = \"m\"\nfile = \"NAME\"\n";

/// Loads a scene of this mesh for a device with a limit of five triangles; also returns how often the limit was requested.
fn load(name: &str, bytes: &[u8], always: u64) -> (Result<Scene, String>, u32) {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join(name), bytes).expect("written");
    let scene = folder.path().join("scene.toml");
    fs::write(&scene, SCENE.replace("NAME", name)).expect("written");
    let asked = Arc::new(AtomicU32::new(0));
    let counted = Arc::clone(&asked);
    let capacity = Capacity::new(always, move || {
        counted.fetch_add(1, Ordering::Relaxed);
        Some(Held { device: "this device".to_owned(), triangles: 5 })
    });
    let loaded = Scene::load_with(&mut Files::default().holding(capacity), &scene, &[], None);
    (loaded.map_err(|error| error.to_string()), asked.load(Ordering::Relaxed))
}

fn obj(faces: usize) -> String {
    format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", "f 1 2 3\n".repeat(faces))
}

fn ascii_stl(facets: usize) -> String {
    format!("solid\n{}", "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n".repeat(facets))
}

fn ply(elements: &str) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement {elements}\n\
         property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
    )
}

fn glb(triangles: usize) -> Vec<u8> {
    let mut made = Made::default();
    let positions = made.floats::<3>(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].repeat(triangles));
    let meshes = json!([{ "primitives": [{ "attributes": { "POSITION": positions } }] }]);
    made.glb(&json!({ "nodes": [{ "mesh": 0 }], "meshes": meshes }))
}

#[test]
fn a_mesh_that_a_device_cannot_hold_is_rejected_where_its_size_is_known() {
    // The bytes of this file are NaNs.
    let stl = [&[b' '; 80][..], &6_u32.to_le_bytes(), &[0xff; 300]].concat();
    // No error after the sixth triangle is found, and the elements that a header declares need not exist.
    for (name, bytes, found) in [
        ("a.obj", (obj(6) + "oops\n").into_bytes(), "6"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 4\nf 1 2 3 4\noops\n".to_vec(), "6"),
        ("a.stl", (ascii_stl(6) + "oops\n").into_bytes(), "6"),
        ("a.stl", stl, "6"),
        ("a.ply", ply("face 3001250").into_bytes(), "3001250"),
        ("a.ply", (ply("tristrips 1") + "8 0 1 2 0 1 2 0 1\n").into_bytes(), "6"),
        ("a.glb", glb(6), "6"),
    ] {
        let (loaded, asked) = load(name, &bytes, 0);
        let said = format!("the mesh has {found} or more triangles, and this device supports at most 5; ");
        let error = loaded.expect_err(name);
        assert!(error.contains("cannot use the mesh `") && error.contains(&said), "{name}: {error}");
        assert!(error.contains("scene.toml:7:8: ") && asked == 1, "{name}, asked {asked} times: {error}");
    }
}

#[test]
fn a_small_mesh_asks_for_no_device() {
    for (name, bytes) in [("a.obj", obj(5).into_bytes()), ("a.stl", ascii_stl(5).into_bytes()), ("a.glb", glb(5))] {
        for (always, asks) in [(5, 0), (4, 1)] {
            let (loaded, asked) = load(name, &bytes, always);
            assert!(loaded.is_ok() && asked == asks, "{name}: {:?}, asked {asked} times", loaded.err());
        }
    }
}
