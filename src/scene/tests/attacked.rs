//! Regression tests of errors that randomly changed files have revealed: data lost without a message, and unreadable messages.

use std::fs;
use std::path::Path;

use image::{Rgb, Rgb32FImage, RgbImage};

use crate::scene::{Mesh, Picture, Scene};

const CORNERS: &str = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

/// Writes a mesh, and returns the number of triangles or the error.
fn mesh(name: &str, bytes: impl AsRef<[u8]>) -> Result<usize, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, bytes).expect("written");
    Mesh::load(&path).map(|mesh| mesh.triangles.len()).map_err(|error| error.to_string())
}

fn ply(format: &str, faces: usize) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face {faces}\n\
         property list uchar uchar vertex_indices\nend_header\n"
    )
}

/// Checks that a header with too small a count is an error, because part of the mesh would be lost.
#[test]
fn a_mesh_that_its_file_goes_on_behind_is_refused() {
    let faces = "3 0 1 2\n3 0 1 3\n";
    assert_eq!(mesh("a.ply", ply("ascii", 2) + CORNERS + faces + "\n \n"), Ok(2));
    let error = mesh("a.ply", ply("ascii", 1) + CORNERS + faces).expect_err("a face is left over");
    assert!(error.contains("a.ply:15:1: `3` follows the last element that the header declares"), "{error}");
    let error = mesh("a.ply", ply("ascii", 2) + CORNERS + faces.trim_end() + " 7").expect_err("a number is left over");
    assert!(error.contains("a.ply:15:9: `7` follows the last element"), "{error}");

    let corners: Vec<u8> =
        CORNERS.split_whitespace().flat_map(|word| word.parse::<f32>().unwrap().to_le_bytes()).collect();
    let bytes = |faces: usize, rest: &[u8]| {
        [ply("binary_little_endian", faces).as_bytes(), &corners, &[3, 0, 1, 2, 3, 0, 1, 3], rest].concat()
    };
    assert_eq!(mesh("a.ply", bytes(2, b"\0\r\n")), Ok(2));
    let error = mesh("a.ply", bytes(1, b"")).expect_err("a face is left over");
    assert!(error.contains("4 bytes follow the last element that the header declares"), "{error}");

    let stl = |count: u32, rest: usize| {
        [&[b' '; 80][..], &count.to_le_bytes(), &triangle(), &triangle(), &vec![7; rest]].concat()
    };
    assert_eq!(mesh("a.stl", stl(2, 0)), Ok(2));
    // Less than one triangle does not count as a lost triangle.
    assert_eq!(mesh("a.stl", stl(2, 49)), Ok(2));
    let error = mesh("a.stl", stl(1, 0)).expect_err("a triangle is left over");
    assert!(error.contains("the header declares 1 triangles of 50 bytes, and 100 bytes follow"), "{error}");
}

/// Returns a triangle of a binary STL.
fn triangle() -> [u8; 50] {
    let mut bytes = [0; 50];
    for (at, value) in [(24, 1_f32), (40, 1.0)] {
        bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
    }
    bytes
}

/// Checks that an open loop is rejected, because it would join two triangles to a hexagon.
#[test]
fn loops_of_an_stl_that_are_not_closed_are_refused() {
    let facet = |end: &str| {
        format!(" facet\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n{end} endfacet\n")
    };
    let whole = facet("  endloop\n");
    assert_eq!(mesh("a.stl", format!("solid\n{whole}{whole}endsolid\n")), Ok(2));
    let error = mesh("a.stl", format!("solid\n{}{whole}endsolid\n", facet(""))).expect_err("a loop is open");
    assert!(error.contains("a.stl:7:2: `endfacet` inside a loop") && error.contains("1 error"), "{error}");
    let open = format!("solid\n{}{whole}endsolid\n", facet("").replace(" endfacet\n", "").replace(" facet\n", ""));
    let error = mesh("a.stl", open).expect_err("a loop is open");
    assert!(error.contains("a.stl:6:2: `facet` inside a loop"), "{error}");
}

/// Checks that each character that a terminal would interpret, reorder or hide is replaced by one visible character, so that carets stay in
/// place.
#[test]
fn files_do_not_control_the_terminal() {
    let scene = "[camera]\nfov = \u{1b}[31m5\u{202e}\0\u{200b}x\n";
    let error = Scene::parse(scene, Path::new("a.toml"), &[]).expect_err("no number").to_string();
    assert!(error.contains("    fov = ␛[31m5\u{fffd}␀\u{fffd}x\n"), "{error:?}");
    // Words that a message quotes, and strings with line ends.
    let error = mesh("a.obj", "v\u{7f}\u{7} 0 0 0\n").expect_err("no statement");
    assert!(error.contains("`v␡␇` is not an OBJ statement"), "{error:?}");
    let scene = "[rays]\nmax_segments = \"a\\nb\\u001b\"\n";
    let error = Scene::parse(scene, Path::new("a.toml"), &[]).expect_err("no number").to_string();
    assert!(error.contains(r#"found the string "a\nb\u{1b}""#), "{error:?}");
    for error in [error, mesh("a.stl", "solid\n\u{9b}2J 0\n").expect_err("no word")] {
        assert!(!error.chars().any(|sign| sign.is_control() && sign != '\n'), "{error:?}");
    }
}

/// Checks that the messages of decoders are translated for users.
#[test]
fn what_is_wrong_with_a_picture_is_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let load = |name: &str, change: &dyn Fn(&mut Vec<u8>)| {
        let path = folder.path().join(name);
        let (width, height) = (64, 32);
        let noise = |x: u32, y: u32| ((x * 7919 + y * 104_729) % 251) as u8;
        if name.ends_with("png") {
            RgbImage::from_fn(width, height, |x, y| Rgb([noise(x, y), noise(y, x), 9])).save(&path).expect("saved");
        } else {
            let noise = |x, y| f32::from(noise(x, y)) / 8.0;
            Rgb32FImage::from_fn(width, height, |x, y| Rgb([noise(x, y), noise(y, x), 0.5]))
                .save(&path)
                .expect("saved");
        }
        let mut bytes = fs::read(&path).expect("read");
        change(&mut bytes);
        fs::write(&path, bytes).expect("written");
        let error = Picture::load(&path).expect_err(name).to_string();
        assert!(
            !["ChunkType", " { ", "buffer", "os error", "invalid:"].iter().any(|words| error.contains(words)),
            "{error}"
        );
        error
    };
    for name in ["a.png", "a.hdr", "a.exr"] {
        let error = load(name, &|bytes| bytes.truncate(bytes.len() * 2 / 3));
        assert!(error.contains("`: the file ends early"), "{error}");
    }
    let chunk = |name: &'static [u8], after: usize| {
        move |bytes: &mut Vec<u8>| {
            let at = bytes.windows(4).position(|four| four == name).expect("a chunk");
            bytes[at + after] ^= 0x20;
        }
    };
    for (name, after, said) in [
        (b"IHDR", 17, "CRC error: expected 0x"),
        (b"IHDR", 17, "while decoding IHDR chunk"),
        (b"IDAT", 9, "the file is damaged: Corrupt deflate stream"),
        (b"IHDR", 1, "the file is damaged: IhDR chunk appeared before IHDR chunk"),
    ] {
        let error = load("a.png", &chunk(name, after));
        assert!(error.contains(said) && !error.contains("Length"), "{error}");
    }
}
