//! Tests of PLY and STL: their meshes equal those of OBJ, and their errors are reported.

use std::fmt::Write as _;
use std::path::Path;

use glam::{Vec2, Vec3};
use proptest::prelude::*;

use crate::scene::{Mesh, SceneError};

/// Loads a file with this name.
fn load(name: &str, bytes: &[u8]) -> Result<Mesh, SceneError> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("written");
    Mesh::load(&path)
}

fn good(name: &str, bytes: &[u8]) -> Mesh {
    load(name, bytes).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns the text of the error without the folder.
fn wrong(name: &str, bytes: &[u8]) -> String {
    let text = load(name, bytes).expect_err("an error").to_string();
    let (front, rest) = text.split_once(name).unwrap_or_else(|| panic!("{text}"));
    let front = front.rsplit_once('/').map_or(front, |(front, _)| front);
    format!("{}{name}{rest}", front.split('`').next().filter(|_| front.contains('`')).unwrap_or_default())
}

/// Returns the triangles as positions, so that meshes can be compared regardless of the order of vertices.
fn places(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let place = |i: u32| (mesh.origin + mesh.vertices[i as usize].position.as_dvec3()).as_vec3();
    mesh.triangles.iter().map(|t| t.map(place)).collect()
}

/// The points of a house: a square of four corners, and a roof of three.
const POINTS: [[f32; 3]; 5] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.5], [0.0, 2.0, 0.5], [1.0, 3.0, -1.0]];
const FACES: [&[u32]; 2] = [&[0, 1, 2, 3], &[3, 2, 4]];

fn obj() -> Mesh {
    let mut text = String::new();
    for [x, y, z] in POINTS {
        writeln!(text, "v {x} {y} {z}").expect("written");
    }
    for face in FACES {
        let corners: Vec<String> = face.iter().map(|i| (i + 1).to_string()).collect();
        writeln!(text, "f {}", corners.join(" ")).expect("written");
    }
    Mesh::parse(&text, Path::new("house.obj")).unwrap_or_else(|error| panic!("{error}"))
}

fn ply_header(format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment a house\nelement vertex 5\nproperty float x\nproperty double y\nproperty float z\n\
         property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    )
}

fn ply_text() -> String {
    let mut text = ply_header("ascii");
    for [x, y, z] in POINTS {
        writeln!(text, "{x} {y} {z} 255").expect("written");
    }
    for face in FACES {
        let corners: Vec<String> = face.iter().map(u32::to_string).collect();
        writeln!(text, "{} {}", face.len(), corners.join(" ")).expect("written");
    }
    text
}

fn ply_bytes(is_big: bool) -> Vec<u8> {
    let mut bytes = ply_header(if is_big { "binary_big_endian" } else { "binary_little_endian" }).into_bytes();
    let mut put = |mut value: Vec<u8>| {
        if is_big {
            value.reverse();
        }
        bytes.extend(value);
    };
    for [x, y, z] in POINTS {
        put(x.to_le_bytes().to_vec());
        put(f64::from(y).to_le_bytes().to_vec());
        put(z.to_le_bytes().to_vec());
        put(vec![255]);
    }
    for face in FACES {
        put(vec![face.len() as u8]);
        for i in face {
            put(i.to_le_bytes().to_vec());
        }
    }
    bytes
}

fn stl_bytes(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = b"solid by some programs, though it is binary".to_vec();
    bytes.resize(80, 0);
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    for triangle in places(mesh) {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flat_map(Vec3::to_array).flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

fn stl_text(mesh: &Mesh) -> String {
    let mut text = "solid house\n".to_owned();
    for triangle in places(mesh) {
        text += "facet normal 0 0 1\r\n  outer loop\n";
        for p in triangle {
            writeln!(text, "    vertex {} {:e} {}", p.x, p.y, p.z).expect("written");
        }
        text += "  endloop\nENDFACET\n";
    }
    text + "endsolid house\n"
}

#[test]
fn all_formats_say_the_same() {
    let expected = obj();
    assert_eq!(expected.triangles.len(), 3);
    let stl = (stl_bytes(&expected), stl_text(&expected));
    let (text, returns) = (ply_text(), ply_text().replace('\n', "\r\n"));
    let files: [(&str, &[u8]); 6] = [
        ("a.ply", text.as_bytes()),
        ("b.PLY", &ply_bytes(false)),
        ("c.ply", &ply_bytes(true)),
        ("d.stl", &stl.0),
        ("e.stl", stl.1.as_bytes()),
        ("f.Ply", returns.as_bytes()),
    ];
    for (name, bytes) in files {
        let mesh = good(name, bytes);
        assert_eq!(places(&mesh), places(&expected), "{name}");
        let normals = |mesh: &Mesh| mesh.vertices.iter().map(|v| v.normal).fold(Vec3::ZERO, |a, b| a + b);
        assert!(normals(&mesh).abs_diff_eq(normals(&expected), 1e-5), "{name}");
    }
}

#[test]
fn what_a_ply_says_of_vertices_and_faces_is_taken() {
    let header = "ply\nformat ascii 1.0\nelement camera 1\nproperty float f\nproperty list uchar float all\nelement face 1\n\
                  property list uchar uint vertex_index\nUVelement vertex 3\nproperty float x\nproperty float y\n\
                  property float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\n\
                  property float t\nend_header\n7 3 1 2 3\n3 0 1 2";
    let vertices = "\n0 0 0 0 3 4 0.5 0.25\n\n1 0 0 0 0 0 0 0\n0 1 0 nan 0 0 1 1\n";
    let mesh = good("a.ply", (header.replace("UV", "") + vertices).as_bytes());
    assert_eq!(mesh.vertices[0].normal, Vec3::new(0.0, 0.6, 0.8));
    assert_eq!(mesh.vertices[0].uv, Vec2::new(0.5, 0.25));
    // Invalid normals are replaced.
    assert_eq!([mesh.vertices[1].normal, mesh.vertices[2].normal], [Vec3::Z; 2]);
    let own = header.replace("UV", "property list uchar float texcoord\n") + " 6 0 1 0.5 0.75 1 0";
    let mesh = good("a.ply", (own + vertices).as_bytes());
    assert_eq!(mesh.vertices[1].uv, Vec2::new(0.5, 0.75));
}

#[test]
fn strips_of_a_ply_are_the_triangles_that_they_are_made_of() {
    let header = |format: &str, kind: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
             element tristrips 2\nproperty list int {kind} vertex_indices\nend_header\n"
        )
    };
    let points = POINTS.map(|[x, y, z]| format!("{x} {y} {z}\n")).concat();
    // A square as one strip, its two triangles again as separate strips, and a strip that is too short, before and after others.
    let text = header("ascii", "int") + &points + "7 0 1 3 2 -1 4 3\n9 -1 0 1 3 -1 3 1 2 -1\n";
    let faces = [[0, 1, 3], [3, 1, 2], [0, 1, 3], [3, 1, 2]];
    let expected: Vec<_> = faces.map(|face| face.map(|i: usize| Vec3::from(POINTS[i]))).to_vec();
    let mesh = good("a.ply", text.as_bytes());
    assert_eq!(places(&mesh), expected);
    assert_eq!(mesh.left_out, [""; 0]);
    // In binary, with unsigned indices.
    let mut bytes = header("binary_little_endian", "uint").into_bytes();
    bytes.extend(POINTS.iter().flatten().flat_map(|x| x.to_le_bytes()));
    let strips: [&[i32]; 2] = [&[0, 1, 3, 2, -1, 4, 3], &[-1, 0, 1, 3, -1, 3, 1, 2, -1]];
    for strip in strips {
        bytes.extend((strip.len() as u32).to_le_bytes());
        bytes.extend(strip.iter().flat_map(|i| i.to_le_bytes()));
    }
    assert_eq!(places(&good("a.ply", &bytes)), expected);
    let told = wrong("a.ply", text.replace("-1 4 3", "-2 4 3").as_bytes());
    assert!(told.starts_with("a.ply:15:11: vertex `-2` does not exist"), "{told}");
    // Edges are counted.
    let edges = ply_text().replace("end_header", "element edge 1\nproperty int vertex1\nend_header") + "7\n";
    assert_eq!(good("a.ply", edges.as_bytes()).left_out, ["elements `edge` (1)"]);
}

#[test]
fn mistakes_in_words_have_their_lines() {
    let text = ply_text();
    for (from, to, said) in [
        ("ply\n", "plx\n", "a.ply:1:1: not a PLY file"),
        ("format ascii 1.0\n", "", "a.ply:1:1: the header specifies no format"),
        ("ascii", "asci", "a.ply:2:8: unknown format `asci`"),
        ("comment a", "coment a", "a.ply:3:1: not a valid header line"),
        ("vertex 5", "vertex -5", "a.ply:4:16: expected a number of elements, found `-5`"),
        ("property float x", "property flot x", "a.ply:5:10: unknown type `flot`"),
        ("property float x", "property float w", "a.ply:1:1: vertices have no property `x`"),
        ("list uchar int", "list float int", "a.ply:10:15: the length of a list must have an integer type"),
        (
            "vertex_indices",
            "vertices",
            "a.ply:1:1: the element `face` has `vertices`, and requires a list `vertex_indices`",
        ),
        (
            "element face",
            "element fase",
            "a.ply:1:1: the file is a point cloud: the header has 5 `vertex`, 2 `fase`, and triangles require `face`",
        ),
        ("face 2", "face 0", "a.ply:1:1: the file is a point cloud: the header has 5 `vertex`, 0 `face`"),
        (
            "element vertex",
            "element vertices",
            "a.ply:1:1: a mesh requires exactly one element `vertex`, and the header has 5 `ver",
        ),
        ("end_header\n", "", "a.ply:11:1: not a valid header line"),
        ("2 0 0 255", "2 x 0 255", "a.ply:13:3: expected a number, found `x`"),
        ("2 0 0 255", "2 0 1e39 255", "a.ply:13:5: expected a number, found `"),
        ("2 0 0 255", "2 0 0", "a.ply:13:6: the line ends"),
        ("2 0 0 255", "2 0 0 255 7", "a.ply:13:11: the header declares no value `7`"),
        ("3 3 2 4", "3 3 2 5", "a.ply:18:7: vertex `5` does not exist"),
        ("3 3 2 4", "3 3 2 -1", "a.ply:18:7: vertex `-1` does not exist"),
        ("3 3 2 4", "3 3 2 0.5", "a.ply:18:7: vertex `0.5` does not exist"),
        ("3 3 2 4", "300 3 2 4", "a.ply:18:1: a list `vertex_indices` has the length 300, and 7 bytes remain"),
        ("3 3 2 4\n", "", "a.ply:18:1: unexpected end of file: the header declares 2 elements `face`"),
    ] {
        assert!(text.contains(from));
        let told = wrong("a.ply", text.replacen(from, to, 1).as_bytes());
        assert!(told.starts_with(said), "{told}\nand not\n{said}");
    }
    let text =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\n  vertex 0 2 0\nendloop\nendfacet\n";
    good("a.stl", text.as_bytes());
    for (from, to, said) in [
        ("solid a\nfacet", "solid a\nfaced", "a.stl:2:1: unknown keyword `faced`"),
        ("  vertex 0 2 0", "  vertex 0 2", "a.stl:6:3: `vertex` requires 3 numbers, found 2"),
        ("  vertex 0 2 0", "  vertex 0 2 inf", "a.stl:6:14: expected a number, found `inf`"),
        ("vertex 2 0 0\n", "", "a.stl:6:1: a loop has 2 vertices"),
    ] {
        assert!(text.contains(from), "{text}");
        let told = wrong("a.stl", text.replacen(from, to, 1).as_bytes());
        assert!(told.starts_with(said), "{told}\nand not\n{said}");
    }
    assert!(wrong("a.stl", &text.as_bytes()[..60]).contains("the file ends inside a loop"));
    assert!(wrong("a.stl", b"solid\nendsolid\n").starts_with("a.stl:1:1: the mesh has no triangles with an area"));
}

#[test]
fn mistakes_in_bytes_have_their_places() {
    let ply = ply_bytes(false);
    let header = ply_header("binary_little_endian").len();
    let mut broken = ply.clone();
    broken[header..header + 4].copy_from_slice(&f32::NAN.to_le_bytes());
    let said = format!("cannot use the mesh a.ply`: at byte {header}: expected a number, found `NaN`");
    assert!(wrong("a.ply", &broken).starts_with(&said), "{}", wrong("a.ply", &broken));
    let mut broken = ply.clone();
    let last = ply.len() - 4;
    broken[last] = 5;
    assert!(
        wrong("a.ply", &broken)
            .contains(&format!("at byte {last}: vertex `5` does not exist (the file has 5 vertices, counted from 0)"))
    );
    // Counts that exceed the file are reported with both numbers.
    let forge = |from: &str, to: &str| {
        wrong("a.ply", &[ply_header("binary_little_endian").replace(from, to).as_bytes(), &[0; 100]].concat())
    };
    assert!(
        forge("vertex 5", "vertex 4000000000")
            .contains("4000000000 elements `vertex` of at least 17 bytes, and 100 bytes")
    );
    assert!(
        forge("face 2", "face 4000000000").contains("4000000000 elements `face` of at least 1 bytes, and 15 bytes")
    );
    assert!(
        forge("property uchar red\n", "element odd 4000000000\n")
            .contains("4000000000 elements `odd` have no properties")
    );
    let text = ply_text().replace("vertex 5", "vertex 4000000000");
    assert!(wrong("a.ply", text.as_bytes()).contains("4000000000 elements `vertex` of at least 8 bytes, and "));

    let stl = stl_bytes(&obj());
    let mut forged = vec![0; 100];
    forged[80..84].copy_from_slice(&4_000_000_000_u32.to_le_bytes());
    assert!(
        wrong("a.stl", &forged)
            .contains("at byte 80: the header declares 4000000000 triangles of 50 bytes, and 16 bytes follow")
    );
    assert!(wrong("a.stl", b"nothing").contains("does not begin with `solid`, and has only 7 of the 84"));
    let mut broken = stl;
    broken[96..100].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert!(wrong("a.stl", &broken).contains("at byte 96: a corner is at [inf, "));
}

#[test]
fn faces_of_very_many_corners_are_refused() {
    let corners = |first: u32| (first..first + 10_001).map(|i| i.to_string()).collect::<Vec<_>>().join(" ");
    let points = "0 0 0\n".repeat(10_001);
    let said = "a face has 10001 corners";
    let obj = format!("{}f {}\n", points.replace("0 0 0", "v 0 0 0"), corners(1));
    assert!(wrong("a.obj", obj.as_bytes()).starts_with(&format!("a.obj:10002:1: {said}")));
    let header = ply_header("ascii").replace("vertex 5", "vertex 10001").replace("property uchar red\n", "");
    let ply = format!(
        "{}{points}10001 {}\n",
        header.replace("face 2", "face 1").replace("uchar int", "uint int"),
        corners(0)
    );
    assert!(wrong("a.ply", ply.as_bytes()).contains(said), "{}", wrong("a.ply", ply.as_bytes()));
    let stl = format!("solid\n{}endloop\n", points.replace("0 0 0", "vertex 0 0 0"));
    assert!(wrong("a.stl", stl.as_bytes()).starts_with(&format!("a.stl:10003:1: {said}")));
}

#[test]
fn other_formats_are_refused_by_name() {
    let told = wrong("a.3ds", b"");
    assert!(told.contains("the name of a mesh file must end in .obj, .ply, .stl, .gltf, .glb"), "{told}");
    assert!(load("none", b"").is_err());
}

proptest! {
    /// Checks that the reader survives arbitrary changes of bytes and truncation.
    #[test]
    fn damaged_files_do_not_panic(
        which in 0..5_usize,
        edits in prop::collection::vec((0.0..1.0, any::<u8>()), 0..4),
        kept in 0.0..1.5_f64,
    ) {
        let mesh = obj();
        let mut bytes = match which {
            0 => ply_text().into_bytes(),
            1 => ply_bytes(false),
            2 => ply_bytes(true),
            3 => stl_bytes(&mesh),
            _ => stl_text(&mesh).into_bytes(),
        };
        for (place, byte) in edits {
            let place = (place * bytes.len() as f64) as usize;
            bytes[place] = byte;
        }
        bytes.truncate((kept * bytes.len() as f64) as usize);
        match load(if which < 3 { "a.ply" } else { "a.stl" }, &bytes) {
            Err(error) => prop_assert!(!error.to_string().is_empty()),
            Ok(mesh) => {
                prop_assert!(mesh.triangles.iter().flatten().all(|i| (*i as usize) < mesh.vertices.len()));
                prop_assert!(mesh.vertices.iter().all(|v| (v.normal.length() - 1.0).abs() < 1e-5 && v.position.is_finite()));
            }
        }
    }
}
