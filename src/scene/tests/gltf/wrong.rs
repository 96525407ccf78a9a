//! Tests of error messages for invalid glTF files.

use proptest::prelude::*;
use serde_json::{Value, json};

use super::{glb, load, square};

#[test]
fn what_is_wrong_is_named_as_the_file_names_it() {
    let (made, rest) = square();
    let whole = made.json(&rest);
    let changed = |path: &str, value: Value| {
        let mut all = whole.clone();
        all["meshes"][0]["primitives"][0]["mode"] = json!(4);
        *all.pointer_mut(path).unwrap_or_else(|| panic!("{path}")) = value;
        load("a.glb", &glb(&all.to_string(), &made.bytes)).expect_err("an error").to_string()
    };
    let many = 4_000_000_000_u64;
    for (path, value, said) in [
        ("/asset/version", json!("1.0"), "glTF 1.0 is not supported; use glTF 2.0"),
        ("/buffers/0/byteLength", json!(many), "buffers[0] declares 4000000000 bytes, and has 60"),
        (
            "/bufferViews/0/byteLength",
            json!(many),
            "bufferViews[0] has 4000000000 bytes from byte 0, and the buffer has 60",
        ),
        ("/bufferViews/0/byteOffset", json!(u64::MAX), "bufferViews[0] has 48 bytes from byte 18446744073709551615"),
        ("/bufferViews/0/buffer", json!(1), "bufferViews[0] refers to buffers[1], and there are 1, counted from 0"),
        (
            "/accessors/0/count",
            json!(many),
            "accessors[0] requires 4000000000 elements of 12 bytes, 12 apart, from byte 0, and bufferViews[0] has 48",
        ),
        ("/accessors/0/count", json!(u64::MAX), "accessors[0] requires 18446744073709551615 elements"),
        ("/accessors/0/bufferView", json!(7), "accessors[0] refers to bufferViews[7]"),
        ("/accessors/0/componentType", json!(5124), "accessors[0] has an invalid `type` or `componentType`"),
        (
            "/accessors/0/type",
            json!("VEC2"),
            "accessors[0] is of type Vec2, and meshes[0].primitives[0].attributes.POSITION requires Vec3",
        ),
        (
            "/accessors/0",
            json!({ "count": many, "componentType": 5126, "type": "VEC3" }),
            "accessors[0] has 4000000000 elements and no buffer view, and the file has",
        ),
        (
            "/accessors/0/count",
            json!(3),
            "meshes[0].primitives[0]: index 5 is 3, and there are 3 vertices, counted from 0",
        ),
        ("/meshes/0/primitives/0/mode", json!(1), "the mesh has no triangles with an area; it has line primitives (1)"),
        ("/meshes/0/primitives/0/mode", json!(9), "meshes[0].primitives[0] has an invalid `mode`"),
        ("/meshes/0/primitives/0/indices", json!(5), "meshes[0].primitives[0].indices refers to accessors[5]"),
        ("/meshes/0/primitives/0/attributes", json!({}), "meshes[0].primitives[0] has no POSITION"),
        ("/meshes/0/primitives/0/attributes", json!({ "POSITION": 0, "NORMAL": 1 }), "accessors[1] is of type Scalar"),
        ("/nodes/0/mesh", json!(3), "nodes[0] refers to meshes[3], which does not exist"),
        ("/nodes/0", json!({ "mesh": 0, "scale": [1e38, 1, 1], "translation": [0, 0, 0] }), "vertex 1 is at "),
    ] {
        let told = changed(path, value);
        assert!(told.contains(said), "{told}\nand not\n{said}");
    }
    let with = |key: &str, value: Value| {
        let mut all = whole.clone();
        all[key] = value;
        load("a.glb", &glb(&all.to_string(), &made.bytes)).expect_err("an error").to_string()
    };
    let loops = json!([{ "mesh": 0, "children": [1] }, { "children": [0] }]);
    assert!(with("nodes", loops.clone()).contains("the mesh has no triangles"), "no node is a root");
    let mut all = whole.clone();
    (all["nodes"], all["scenes"]) = (loops, json!([{ "nodes": [0] }]));
    let told = load("a.glb", &glb(&all.to_string(), &made.bytes)).expect_err("an error").to_string();
    assert!(told.contains("nodes[0] is used twice, but nodes must form a tree"), "{told}");
    let told = with("extensionsRequired", json!(["KHR_texture_transform", "KHR_draco_mesh_compression"]));
    assert!(told.contains("the required extension `KHR_draco_mesh_compression` is not supported"), "{told}");
    assert!(with("extensionsRequired", json!(["EXT_meshopt_compression"])).contains("`EXT_meshopt_compression`"));

    // A location is a line in a text file and an offset in a binary file.
    let told = load("a.gltf", b"{\n  \"asset\": { \"version\": 2 }\n}").expect_err("an error").to_string();
    assert!(told.contains("a.gltf:2:25: not valid glTF: invalid type: integer `2`, expected a string"), "{told}");
    let file = glb(&whole.to_string(), &made.bytes);
    let cut = load("a.glb", &file[..100]).expect_err("an error").to_string();
    assert!(
        cut.contains(&format!("at byte 8: the header declares {} bytes, and the file has 100", file.len())),
        "{cut}"
    );
    let mut forged = file.clone();
    forged[12..16].copy_from_slice(&(many as u32).to_le_bytes());
    let told = load("a.glb", &forged).expect_err("an error").to_string();
    assert!(told.contains("at byte 12: a chunk declares 4000000000 bytes, and "), "{told}");
    // Only padding may follow.
    assert!(load("a.glb", &[&file[..], b"\0\n"].concat()).is_ok());
    let told = load("a.glb", &[&file[..], b"more"].concat()).expect_err("an error").to_string();
    assert!(
        told.contains(&format!("the header declares {} bytes, and the file has {}", file.len(), file.len() + 4)),
        "{told}"
    );
    let mut external = whole;
    external["buffers"][0]["uri"] = json!("none.bin");
    let told = load("a.gltf", external.to_string().as_bytes()).expect_err("an error").to_string();
    assert!(told.contains("buffers[0] refers to `") && told.contains("none.bin`, which cannot be read"), "{told}");
}

proptest! {
    /// Checks that the reader survives arbitrary changes of bytes and truncation.
    #[test]
    fn damaged_files_do_not_panic(edits in prop::collection::vec((0.0..1.0, any::<u8>()), 0..4), kept in 0.0..1.5_f64) {
        let (made, rest) = square();
        let mut bytes = made.glb(&rest);
        for (place, byte) in edits {
            let place = (place * bytes.len() as f64) as usize;
            bytes[place] = byte;
        }
        bytes.truncate((kept * bytes.len() as f64) as usize);
        match load("a.glb", &bytes) {
            Err(error) => prop_assert!(!error.to_string().is_empty()),
            Ok(mesh) => prop_assert!(mesh.triangles.iter().flatten().all(|i| (*i as usize) < mesh.vertices.len())),
        }
    }
}
