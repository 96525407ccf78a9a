//! Tests of text files from different programs: byte order marks, encodings, line ends, comments, and unused words.

use std::path::Path;

use super::{SceneError, mistakes_of};
use crate::assets::{Gltf, GridUse, Profile, SampledGrid};
use crate::scene::{Mesh, Scene};

const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 9 9 9\nf 1 2 3 4\n";
const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                   element face 1\nproperty list uchar int vertex_indices\nend_header\n-1 -1 0\n1 -1 0\n1 1 0\n3 0 1 2\n";
const STL: &str =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid\n";
const NRRD: &str = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspacings: 1 1 1\n\nabcdefgh";
const CSV: &str = "height,n\n0,1.5\n4,1.25\n";
const SCENE: &str = "[rays]\nbounding_sphere = { radius = 9 }\n[materials.m]\n";
const GLTF: &str = "{\n  \"asset\": { \"version\": \"2.0\" }\n}\n";

type Read = fn(&Path) -> Result<String, SceneError>;

/// Every reader of text files with a sample file; each returns a description of the contents.
const READERS: [(&str, &str, Read); 7] = [
    ("a.obj", SQUARE, mesh),
    ("a.ply", PLY, mesh),
    ("a.stl", STL, mesh),
    ("a.nrrd", NRRD, |path| {
        let used = GridUse { bare: None, corners: None, scale: 1.0, offset: 0.0, is_index: true };
        Ok(format!("{:?}", SampledGrid::load(path, &used)?.samples))
    }),
    ("a.csv", CSV, |path| Ok(format!("{:?}", Profile::load(path)?))),
    ("a.toml", SCENE, |path| Ok(format!("{:?}", Scene::load(path, &[])?.rays))),
    ("a.gltf", GLTF, |path| Ok(format!("{:?}", Gltf::open(std::fs::read(path).expect("read"), path)?.root.asset))),
];

fn mesh(path: &Path) -> Result<String, SceneError> {
    let mesh = Mesh::load(path)?;
    Ok(format!("{:?} {:?}", mesh.vertices, mesh.triangles))
}

#[test]
fn every_reader_of_text_takes_marks_and_ends_of_lines_and_names_utf_16() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text, read) in READERS {
        let path = folder.path().join(name);
        let read = |bytes: &[u8]| {
            std::fs::write(&path, bytes).expect("written");
            read(&path).map_err(|error| error.to_string())
        };
        let plain = read(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
        let same = [format!("\u{feff}{text}"), text.replace('\n', "\r\n"), text.replace('\n', "\r")];
        for changed in same {
            assert_eq!(read(changed.as_bytes()).as_ref(), Ok(&plain), "{name}: {changed:?}");
        }
        for has_mark in [true, false] {
            let mark = if has_mark { "\u{feff}" } else { "" };
            let words: Vec<u16> = format!("{mark}{text}").encode_utf16().collect();
            let ends = [("LE", u16::to_le_bytes as fn(u16) -> [u8; 2]), ("BE", u16::to_be_bytes)];
            for (end, bytes) in ends {
                let bytes: Vec<u8> = words.iter().flat_map(|word| bytes(*word)).collect();
                let told = read(&bytes).expect_err("an error");
                let said = format!("{name}:1:1: the file is encoded as UTF-16{end}, not as UTF-8");
                assert!(told.contains(&said) && told.contains("help: convert the file to UTF-8"), "{told}");
            }
        }
    }
}

#[test]
fn bytes_behind_a_header_are_taken_as_they_are() {
    // Samples and coordinates with bytes that are also line ends.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.nrrd");
    for line_end in ["\n", "\r\n", "\r"] {
        let header = NRRD.replace("abcdefgh", "").replace('\n', line_end);
        let samples = *b"\n\r\n\r\r\n\n\r";
        std::fs::write(&path, [header.as_bytes(), &samples].concat()).expect("written");
        let used = GridUse { bare: None, corners: None, scale: 1.0, offset: 0.0, is_index: true };
        let grid = SampledGrid::load(&path, &used).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(grid.samples, samples.map(f32::from));
    }
    let path = folder.path().join("a.ply");
    // The number 10 in 16 bits is a line end and a zero.
    let header = PLY.split("-1 -1 0").next().expect("a header").replace("ascii", "binary_little_endian");
    let header = header.replace("float", "short").replace("uchar int", "uchar uchar");
    let corners = [[10_i16, 10, 13], [10, 2570, 13], [10, 10, 3338]];
    let body: Vec<u8> = corners.iter().flatten().flat_map(|x| x.to_le_bytes()).chain([3, 0, 1, 2]).collect();
    for line_end in ["\n", "\r\n", "\r"] {
        let header = header.replace('\n', line_end);
        std::fs::write(&path, [header.as_bytes(), &body].concat()).expect("written");
        let mesh = Mesh::load(&path).unwrap_or_else(|error| panic!("{error}"));
        let places: Vec<[i16; 3]> =
            mesh.vertices.iter().map(|v| (v.position.as_dvec3() + mesh.origin).as_i16vec3().to_array()).collect();
        assert_eq!(places, corners);
    }
}

fn obj(text: &str) -> Result<Mesh, String> {
    Mesh::parse(text, Path::new("a.obj")).map_err(|error| error.to_string())
}

#[test]
fn a_comment_begins_a_line_or_follows_a_blank() {
    let good = obj(&format!("#v 1 2\n#\n{SQUARE}\t# f 1 2 9\nf 1 2 3 #4\no a#b # c#d\n")).expect("a mesh");
    assert_eq!(good.triangles.len(), 3);
    for (from, to, said) in [
        ("v 1 -1 0", "v 1 -1 -1.#IND00", "a.obj:2:8: expected a number, found `-1.#IND00`"),
        ("v 1 -1 0", "v 1 -1 1.#INF", "a.obj:2:8: expected a number, found `1.#INF`"),
        ("f 1 2 3 4", "f 1 2 3 4#5", "a.obj:6:9: vertex `4#5` does not exist"),
    ] {
        let told = obj(&SQUARE.replace(from, to)).expect_err("an error");
        assert!(told.starts_with(said), "{told}\nand not\n{said}");
    }
}

#[test]
fn an_unknown_statement_of_an_obj_is_a_mistake() {
    for (line, said) in [
        ("  w 1 2 3", "a.obj:7:3: `w` is not an OBJ statement"),
        ("V 1 2 3", "a.obj:7:1: `V` is not an OBJ statement"),
        ("\u{feff}v 1 2 3", "a.obj:7:1: `\u{fffd}v` is not an OBJ statement"),
        ("1 2 3", "a.obj:7:1: `1` is not an OBJ statement"),
        ("call other.obj", "a.obj:7:1: `call` reads another file"),
    ] {
        let told = obj(&format!("{SQUARE}{line}\n")).expect_err("an error");
        assert!(told.starts_with(said), "{told}\nand not\n{said}");
    }
    // Every keyword of the specification is accepted, and geometry that is not drawn is counted.
    let known = "vp 0 0\ncstype bezier\ndeg 3\nbmat u 1\nstep 1\nparm u 0\ntrim 0\nhole 0\nscrv 0\nsp 1\nend\ncon 1\ng a\ns 1\n\
                 mg 0\no a\nbevel on\nc_interp on\nd_interp on\nlod 1\nusemtl a\nmtllib a\nusemap a\nmaplib a\nshadow_obj a\n\
                 trace_obj a\nctech cparm 1\nstech cparma 1 1\ncsh -a\n";
    assert_eq!(obj(&format!("{SQUARE}{known}")).expect("a mesh").left_out, [""; 0]);
    let geometry = "p 1\nl 1 2\nf 1 2\nf 1\nl 2 3\ncurv 0 1 1\ncurv2 1 2\nsurf 0 1 0 1 1\nbzp 1\ncdc 1\n";
    let left_out = obj(&format!("{SQUARE}{geometry}")).expect("a mesh").left_out;
    assert_eq!(left_out, ["free-form curves (3)", "free-form surfaces (2)", "lines (3)", "points (2)"]);
    let told = obj("v 0 0 0\nv 1 0 0\nl 1 2\n").expect_err("an error");
    assert!(told.contains("the mesh has no triangles with an area; it has lines (1)"), "{told}");
}

#[test]
fn a_scene_names_what_its_meshes_have_that_is_not_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(folder.path().join("a.obj"), format!("{SQUARE}l 1 2\n")).expect("written");
    let object = "[[objects]]\nshape = \"mesh\"\nfile = \"a.obj\"\nmaterial = \"m\"\n";
    let scene = |count: usize| Scene::parse(&format!("{SCENE}{}", object.repeat(count)), &path, &[]);
    let warnings = scene(2).unwrap_or_else(|error| panic!("{error}")).warnings();
    let [warning] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(warning.ends_with("a.obj: ignored lines (1); only triangles are drawn"), "{warning}");
    std::fs::write(folder.path().join("a.obj"), format!("{SQUARE}line 1 2\n")).expect("written");
    assert_eq!(mistakes_of(scene(2)).len(), 1);
}
