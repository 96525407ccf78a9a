//! Tests of glTF geometry: nodes, meshes and accessors.

mod import;
mod wrong;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::{DVec3, Vec2, Vec3};
use serde_json::{Value, json};

use crate::assets::{Gltf, MeshPart, MeshRequest, NodeName};
use crate::scene::{Files, Mesh, Scene, SceneError};

/// A file under construction: its binary data and the views of it.
#[derive(Default)]
pub(super) struct Made {
    bytes: Vec<u8>,
    views: Vec<Value>,
    pub accessors: Vec<Value>,
}

impl Made {
    fn view(&mut self, bytes: impl IntoIterator<Item = u8>) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        self.views.push(json!({ "buffer": 0, "byteOffset": start, "byteLength": self.bytes.len() - start }));
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.len() - 1
    }

    pub fn accessor(&mut self, kind: u32, of: &str, count: usize, bytes: impl IntoIterator<Item = u8>) -> usize {
        let view = self.view(bytes);
        self.accessors.push(json!({ "bufferView": view, "componentType": kind, "type": of, "count": count }));
        self.accessors.len() - 1
    }

    pub fn floats<const N: usize>(&mut self, all: &[[f32; N]]) -> usize {
        let bytes = all.iter().flatten().flat_map(|x| x.to_le_bytes());
        self.accessor(5126, ["SCALAR", "VEC2", "VEC3"][N - 1], all.len(), bytes)
    }

    /// Returns the JSON with these nodes, meshes and other properties.
    fn json(&self, rest: &Value) -> Value {
        let mut all = json!({
            "asset": { "version": "2.0" },
            "buffers": [{ "byteLength": self.bytes.len() }],
            "bufferViews": self.views,
            "accessors": self.accessors,
        });
        for (key, value) in rest.as_object().expect("an object") {
            all[key] = value.clone();
        }
        all
    }

    pub fn glb(&self, rest: &Value) -> Vec<u8> {
        glb(&self.json(rest).to_string(), &self.bytes)
    }
}

fn glb(json: &str, bytes: &[u8]) -> Vec<u8> {
    let mut json = json.to_owned();
    while !json.len().is_multiple_of(4) {
        json.push(' ');
    }
    let words = |all: &[u32]| all.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let length = 28 + json.len() + bytes.len();
    let head = [b"glTF".to_vec(), words(&[2, length as u32, json.len() as u32]), b"JSON".to_vec()].concat();
    [head, json.into_bytes(), words(&[bytes.len() as u32]), b"BIN\0".to_vec(), bytes.to_vec()].concat()
}

fn load(name: &str, bytes: &[u8]) -> Result<Mesh, SceneError> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("written");
    Mesh::load(&path)
}

fn good(bytes: &[u8]) -> Mesh {
    load("a.glb", bytes).unwrap_or_else(|error| panic!("{error}"))
}

fn places(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let place = |i: u32| (mesh.origin + mesh.vertices[i as usize].position.as_dvec3()).as_vec3();
    mesh.triangles.iter().map(|t| t.map(place)).collect()
}

fn one_node(primitives: &Value) -> Value {
    json!({ "nodes": [{ "mesh": 0 }], "meshes": [{ "primitives": primitives }] })
}

/// The corners of a square.
pub(super) const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];

/// Returns a square of two triangles.
fn square() -> (Made, Value) {
    let mut made = Made::default();
    let positions = made.floats(&SQUARE);
    let indices = made.accessor(5123, "SCALAR", 6, [0_u16, 1, 2, 2, 1, 3].iter().flat_map(|i| i.to_le_bytes()));
    let rest = one_node(&json!([{ "attributes": { "POSITION": positions }, "indices": indices }]));
    (made, rest)
}

#[test]
fn triangles_strips_and_fans_are_the_same_square() {
    let (made, rest) = square();
    let expected = good(&made.glb(&rest));
    assert_eq!(expected.triangles.len(), 2);
    assert!(expected.vertices.iter().all(|v| v.normal == Vec3::Z));
    let area = |mesh: &Mesh| {
        let sum = places(mesh).into_iter().map(|[a, b, c]| (b - a).cross(c - a) / 2.0).fold(Vec3::ZERO, |a, b| a + b);
        assert!(mesh.vertices.iter().all(|v| v.normal == Vec3::Z));
        sum
    };
    let (mut made, _) = square();
    let fan = made.accessor(5121, "SCALAR", 4, [0, 1, 3, 2]);
    let wide = made.accessor(5125, "SCALAR", 4, [0_u32, 1, 2, 3].iter().flat_map(|i| i.to_le_bytes()));
    for primitive in [
        json!({ "attributes": { "POSITION": 0 }, "mode": 5 }),
        json!({ "attributes": { "POSITION": 0 }, "mode": 5, "indices": wide }),
        json!({ "attributes": { "POSITION": 0 }, "mode": 6, "indices": fan }),
    ] {
        let mesh = good(&made.glb(&one_node(&json!([primitive]))));
        assert_eq!(area(&mesh), Vec3::Z, "{primitive}");
        assert_eq!(mesh.vertices.len(), 4);
    }
}

#[test]
fn nodes_place_their_meshes() {
    let (mut made, _) = square();
    let normals = made.floats(&[[0.0, 0.6, 0.8]; 4]);
    let primitive = json!([{ "attributes": { "POSITION": 0, "NORMAL": normals }, "indices": 1 }]);
    // The parent rotates by a right angle around x, and the child translates, scales and mirrors.
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let rest = json!({
        "scene": 1,
        "scenes": [{ "nodes": [2] }, { "nodes": [0] }],
        "nodes": [
            { "rotation": [half, 0, 0, half], "children": [1] },
            { "name": "mirrored", "mesh": 0, "translation": [5, 0, 0], "scale": [-1, 2, 1] },
            { "mesh": 0 },
        ],
        "meshes": [{ "primitives": primitive }],
    });
    let mesh = good(&made.glb(&rest));
    assert_eq!(mesh.triangles.len(), 2, "the other scene is not shown");
    // (x, y, 0) becomes (5 − x, 2y, 0), then (5 − x, 0, 2y).
    let [a, b, c] = places(&mesh)[0];
    let expected = [Vec3::new(5.0, 0.0, 0.0), Vec3::new(5.0, 0.0, 2.0), Vec3::new(4.0, 0.0, 0.0)];
    for (found, expected) in [a, b, c].into_iter().zip(expected) {
        assert!(found.abs_diff_eq(expected, 1e-6), "{found} {expected}");
    }
    // The orientation remains counterclockwise seen from the tip of the normals.
    let across = (b - a).cross(c - a);
    let normal = mesh.vertices[0].normal;
    assert!(across.dot(normal) > 0.0, "{across} {normal}");
    // The normal (0, 0.6, 0.8) is (0, 0.3, 0.8) after y is halved, and rotates to (0, −0.8, 0.3).
    assert!(normal.abs_diff_eq(Vec3::new(0.0, -0.8, 0.3).normalize(), 1e-6), "{normal}");
}

#[test]
fn texture_coordinates_are_those_that_the_colour_uses() {
    let (mut made, _) = square();
    let first = made.floats(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
    let second = made.accessor(5121, "VEC2", 4, [255, 0, 0, 0, 255, 255, 0, 255]);
    made.accessors[second]["normalized"] = json!(true);
    let attributes = json!({ "POSITION": 0, "TEXCOORD_0": first, "TEXCOORD_1": second });
    let with = |texture: Value| {
        let mut rest = one_node(&json!([{ "attributes": attributes, "indices": 1, "material": 0 }]));
        rest["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorTexture": texture } }]);
        good(&made.glb(&rest)).vertices.iter().map(|v| v.uv).collect::<Vec<_>>()
    };
    // Here v is counted from below.
    assert_eq!(with(json!({ "index": 0 }))[..3], [Vec2::new(0.0, 1.0), Vec2::new(1.0, 1.0), Vec2::new(0.0, 0.0)]);
    assert_eq!(with(json!({ "index": 0, "texCoord": 1 }))[0], Vec2::new(1.0, 1.0));
    let moved = json!({ "offset": [0.5, 0.25], "scale": [2, 4] });
    let moved = with(json!({ "index": 0, "extensions": { "KHR_texture_transform": moved } }));
    assert_eq!(moved[1], Vec2::new(2.5, 0.75));
    // The example of the extension: a counterclockwise right angle around the lower left corner of the image, in its upper left part.
    let turned = json!({ "offset": [0, 1], "rotation": std::f32::consts::FRAC_PI_2, "scale": [0.5, 0.5] });
    let turned = with(json!({ "index": 0, "extensions": { "KHR_texture_transform": turned } }));
    assert!(turned[1].abs_diff_eq(Vec2::new(0.0, 0.5), 1e-6), "{turned:?}");
}

#[test]
fn sparse_and_whole_numbers_are_read() {
    let mut made = Made::default();
    // Bytes with a stride of four.
    let corners = made.view([0_u8, 0, 0, 9, 100, 0, 0, 9, 0, 100, 0, 9]);
    made.views[corners]["byteStride"] = json!(4);
    made.accessors.push(json!({ "bufferView": corners, "componentType": 5121, "type": "VEC3", "count": 3 }));
    let places_of = made.view([2]);
    let values = made.view([0.0_f32, 7.0, 0.0].iter().flat_map(|x| x.to_le_bytes()));
    made.floats(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    made.accessors[1]["sparse"] = json!({
        "count": 1,
        "indices": { "bufferView": places_of, "componentType": 5121 },
        "values": { "bufferView": values },
    });
    let mesh = |positions: usize| good(&made.glb(&one_node(&json!([{ "attributes": { "POSITION": positions } }]))));
    assert_eq!(places(&mesh(0)), [[Vec3::ZERO, 100.0 * Vec3::X, 100.0 * Vec3::Y]]);
    assert_eq!(places(&mesh(1)), [[Vec3::ZERO, Vec3::X, 7.0 * Vec3::Y]]);
}

#[test]
fn buffers_are_in_the_file_beside_it_or_in_the_text() {
    let (made, rest) = square();
    let expected = good(&made.glb(&rest));
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("the bytes.bin"), &made.bytes).expect("written");
    let encoded = format!("data:application/octet-stream;base64,{}", STANDARD.encode(&made.bytes));
    for uri in ["the%20bytes.bin", &encoded] {
        let mut all = made.json(&rest);
        all["buffers"][0]["uri"] = json!(uri);
        let path = folder.path().join("a.gltf");
        std::fs::write(&path, all.to_string()).expect("written");
        assert_eq!(Mesh::load(&path).unwrap_or_else(|error| panic!("{error}")), expected);
        // The list of files that an image depends on is complete.
        let scene = folder.path().join("scene.toml");
        let text = "[rays]\nbounding_sphere = { radius = 9 }\n[materials.m]\n[[objects]]\nshape = \"mesh\"\nfile = \"a.gltf\"\n\
                    material = \"m\"\n";
        std::fs::write(&scene, text).expect("written");
        let mut files = Files::default();
        Scene::load_with(&mut files, &scene, &[], None).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(files.paths().len(), if uri.starts_with("data") { 1 } else { 2 });
    }
}

#[test]
fn parts_are_chosen_by_name_and_number() {
    let (made, _) = square();
    let square = json!({ "attributes": { "POSITION": 0 }, "indices": 1 });
    let points = json!({ "attributes": { "POSITION": 0 }, "mode": 0 });
    let rest = json!({
        "nodes": [
            { "name": "twice", "mesh": 0 },
            { "name": "twice", "mesh": 0, "translation": [0, 0, 1] },
            { "name": "once", "mesh": 1, "translation": [0, 0, 2] },
            { "name": "eye" },
        ],
        "meshes": [{ "primitives": [square] }, { "primitives": [square, points, square] }],
    });
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.glb");
    let file = Gltf::open(made.glb(&rest), &path).unwrap_or_else(|error| panic!("{error}"));
    let ask = |node: Option<NodeName>, primitive: Option<u32>| -> Result<DVec3, String> {
        let (source, place) = file.find(&MeshPart { node, primitive }).map_err(|error| error.to_string())?;
        let mesh = file.read(&source, MeshRequest::CREASE).map_err(|error| error.to_string())?;
        Ok(place.transform_point3(mesh.vertices[0].position.as_dvec3()))
    };
    let named = |name: &str| Some(NodeName::Name(name.to_owned()));
    let number = |number| Some(NodeName::Number(number));
    assert_eq!(ask(named("once"), Some(2)), Ok(2.0 * DVec3::Z));
    assert_eq!(ask(number(1), None), Ok(DVec3::Z));
    assert_eq!(ask(None, None), Ok(DVec3::ZERO));
    for (asked, said) in [
        (ask(named("once"), Some(1)), "the mesh has no triangles with an area; it has point primitives (1)"),
        (ask(named("onze"), None), "the file has no node `onze` with a mesh; use `once`"),
        (ask(named("eye"), None), "the file has no node `eye` with a mesh"),
        (ask(number(9), None), "has no node 9 with a mesh"),
        (ask(named("twice"), None), "several nodes have this name; use one of the numbers 0, 1"),
        (ask(named("once"), Some(3)), "nodes[2] has no primitive 3; it has 3, counted from 0"),
    ] {
        let told = asked.expect_err("an error");
        assert!(told.contains(said), "{told}\nand not\n{said}");
    }
    std::fs::write(&path, made.glb(&rest)).expect("written");
    let scene = |keys: &str| {
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = 9 }}\n[materials.m]\n[[objects]]\nshape = \"mesh\"\nfile = \"a.glb\"\n\
             material = \"m\"\n{keys}\n"
        );
        std::fs::write(folder.path().join("scene.toml"), text).expect("written");
        crate::scene::Scene::load(&folder.path().join("scene.toml"), &[]).map_err(|error| error.to_string())
    };
    scene("node = \"once\"\nprimitive = 0").unwrap_or_else(|error| panic!("{error}"));
    scene("node = 0").unwrap_or_else(|error| panic!("{error}"));
    let warnings = |keys: &str| scene(keys).unwrap_or_else(|error| panic!("{error}")).warnings();
    assert_eq!(warnings("node = 0"), [""; 0]);
    for keys in ["", "node = \"once\""] {
        let told = warnings(keys);
        let is_told = |told: &str| told.ends_with("a.glb: ignored point primitives (1); only triangles are drawn");
        assert!(told.len() == 1 && is_told(&told[0]), "{told:?}");
    }
    assert!(scene("node = \"eye\"").expect_err("an error").contains("scene.toml:8:8: cannot use the mesh"));
    assert!(scene("node = true").expect_err("an error").contains("expected a whole number"));
    let obj = "file = \"scenes/stability/sheet.obj\"\nshape = \"mesh\"\nmaterial = \"m\"\nnode = 0\n";
    let told = super::mistakes_of(super::parse(&format!(
        "[rays]\nbounding_sphere = {{ radius = 30 }}\n[materials.m]\n[[objects]]\n{obj}"
    )));
    assert!(told[0].problem.contains("this format has no nodes: remove `node` and `primitive`"), "{told:?}");
}

#[test]
fn nodes_with_the_same_mesh_share_it() {
    let (made, _) = square();
    let rest = json!({
        "nodes": [
            { "mesh": 0 },
            { "mesh": 0, "translation": [0, 3, 0], "rotation": [0, 0, 0.6, 0.8], "scale": [2, 1, 1] },
            { "mesh": 0, "scale": [-1, 1, 1] },
            { "mesh": 0, "scale": [1, 0, 1] },
        ],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
    });
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("a.glb"), made.glb(&rest)).expect("written");
    let scene = |nodes: &[u32]| {
        let object =
            |node: &u32| format!("[[objects]]\nshape = \"mesh\"\nfile = \"a.glb\"\nmaterial = \"m\"\nnode = {node}\n");
        let objects: String = nodes.iter().map(object).collect();
        let text = format!("[rays]\nbounding_sphere = {{ radius = 9 }}\n[materials.m]\n{objects}");
        Scene::parse(&text, &folder.path().join("scene.toml"), &[])
    };
    let scene_of_three = scene(&[0, 1, 2]).unwrap_or_else(|error| panic!("{error}"));
    let meshes: Vec<_> = scene_of_three.objects.iter().filter_map(|object| object.shape.mesh()).collect();
    assert!(std::sync::Arc::ptr_eq(meshes[0], meshes[1]) && !std::sync::Arc::ptr_eq(meshes[0], meshes[2]));
    // The rotation with the quaternion (z, w) = (0.6, 0.8) takes the x axis to (0.28, 0.96).
    let turned = |p: DVec3| DVec3::new(0.56 * p.x - 0.96 * p.y, 3.0 + 1.92 * p.x + 0.28 * p.y, p.z);
    let [_, map, mirrored] = [0, 1, 2].map(|k| scene_of_three.objects[k].transform.0);
    for vertex in &meshes[0].vertices {
        let p = vertex.position.as_dvec3();
        assert!(map.transform_point3(p).abs_diff_eq(turned(p), 1e-6), "{p}");
        let seen = meshes[2].vertices.iter().map(|vertex| mirrored.transform_point3(vertex.position.as_dvec3()));
        assert!(seen.into_iter().any(|q| q == p * DVec3::new(-1.0, 1.0, 1.0)), "{p}");
    }
    // Inside out, the mesh would be seen from behind.
    let facing = |mesh: &Mesh| {
        let [a, b, c] = mesh.triangles[0].map(|i| mesh.vertices[i as usize].position);
        (b - a).cross(c - a).z > 0.0
    };
    assert_eq!(facing(meshes[0]), facing(meshes[2]));
    let told = scene(&[3]).expect_err("a flat node").to_string();
    assert!(told.contains("no triangles with an area"), "{told}");
}
