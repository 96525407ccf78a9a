//! Tests of meshes and images, and of scenes that reference them.

use super::{Scene, mistakes_of};
use crate::assets::Files;
use crate::model::medium::Grid;
use crate::scene::{Diagnostic, Interior, Mesh, Pattern, Picture, SceneError, Sky, Substance};
use glam::{DMat3, Vec2, Vec3};
use image::{DynamicImage, GrayImage, ImageFormat, Luma, Rgb, Rgb32FImage, RgbImage};
use std::fs;
use std::path::Path;
use std::sync::Arc;

fn mesh(text: &str) -> Mesh {
    Mesh::parse(text, Path::new("a.obj")).unwrap_or_else(|e| panic!("{e}"))
}

fn wrong(text: &str) -> Vec<Diagnostic> {
    match Mesh::parse(text, Path::new("a.obj")) {
        Err(SceneError::Diagnostics(mistakes)) => mistakes,
        other => panic!("{other:?}"),
    }
}

fn area(mesh: &Mesh) -> Vec3 {
    let corner = |i: u32| mesh.vertices[i as usize].position;
    let halves = mesh.triangles.iter().map(|t| {
        let [a, b, c] = t.map(corner);
        (b - a).cross(c - a) / 2.0
    });
    halves.sum()
}

#[test]
fn a_concave_polygon_keeps_its_area_and_sense() {
    // An L of area 3 in the plane z = 1, in both orientations.
    let l = "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n";
    let one = mesh(&format!("{l}f 1 2 3 4 5 6\n"));
    assert_eq!(one.triangles.len(), 4);
    assert!(area(&one).abs_diff_eq(3.0 * Vec3::Z, 1e-6));
    let other = mesh(&format!("{l}f -1 -2 -3 -4 -5 -6\n"));
    assert!(area(&other).abs_diff_eq(-3.0 * Vec3::Z, 1e-6));
    // All triangles have one orientation.
    for t in &one.triangles {
        let single = Mesh::new(one.vertices.clone(), vec![*t]);
        assert!(area(&single).z > 0.0);
    }
}

#[test]
fn normals_come_from_the_file_or_the_face() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nvt 0.5 0.25 0\nvt 0.75\nf 1/1/1 2/2 3\n";
    let m = mesh(text);
    assert_eq!(m.vertices[0].normal, Vec3::new(0.0, 0.6, 0.8));
    assert_eq!(m.vertices[1].normal, Vec3::Z);
    assert_eq!(m.vertices[0].uv, Vec2::new(0.5, 0.25));
    assert_eq!(m.vertices[1].uv, Vec2::new(0.75, 0.0));
    assert_eq!(m.vertices[2].uv, Vec2::ZERO);
}

#[test]
fn other_statements_are_passed_over() {
    let text = "mtllib none.mtl\r\no a # name\r\nv 0 0 0 1 0 0\r\nv 1 0 0 # x\r\nv 0 \\\r\n 1 0\r\nusemtl m\r\ns off\r\n\
                l 1 2 3\r\np 1\r\nf 1 2\r\nf 1 2 3\r\nf 1 1 2\r\n# f 7 8 9 \\\r\nf 3 2 1\r\n";
    assert_eq!(mesh(text).triangles.len(), 2);
}

#[test]
fn mistakes_in_a_mesh_have_its_lines() {
    let v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (text, line, column, excerpt, problem) in [
        ("f 1 2 4", 4, 7, "4", "vertex `4` does not exist"),
        ("f 1 2 0", 4, 7, "0", "vertex `0` does not exist"),
        ("f 1 -4 2", 4, 5, "-4", "vertex `-4` does not exist"),
        ("f 1 2 99999999999999999999", 4, 7, "99999999999999999999", "vertex `99999999999999999999` does not exist"),
        ("f 1/1 2 3", 4, 3, "1/1", "texture coordinate `1` does not exist"),
        ("f 1 2 3//9", 4, 7, "3//9", "normal `9` does not exist"),
        ("f 1 2 //", 4, 7, "//", "a corner requires a vertex"),
        ("v 1 nan 2", 4, 5, "nan", "expected a number, found `nan`"),
        ("v 1 2 1e39", 4, 7, "1e39", "expected a number, found `1e39`"),
        ("\n  vn 1 2", 5, 3, "vn", "`vn` requires 3 numbers, found 2"),
        ("", 1, 1, "", "the mesh has no triangles with an area"),
        ("f 1 2 2", 1, 1, "", "the mesh has no triangles with an area"),
    ] {
        let mistakes = wrong(&format!("{v}{text}"));
        assert_eq!(mistakes.len(), 1);
        let m = &mistakes[0];
        assert_eq!((m.line, m.column, m.excerpt.as_str(), m.problem.as_str()), (line, column, excerpt, problem));
    }
    assert_eq!(wrong(&"f 1 2 3\n".repeat(20)).len(), 10);
}

#[test]
fn the_shared_meshes_load() {
    for (name, triangles, smooth) in [("teapot.obj", 992, true), ("bunny.obj", 3674, true)] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/data").join(name);
        let m = Mesh::load(&path).unwrap_or_else(|e| panic!("{e}"));
        assert!(m.triangles.len() <= triangles && m.triangles.len() > triangles * 9 / 10);
        assert_eq!(m.vertices.len() < 2 * triangles, smooth);
    }
}

#[test]
fn pictures_become_linear() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let rgb = RgbImage::from_fn(2, 1, |x, _| Rgb([0, 188, 255 * x as u8]));
    rgb.save(path("8.png")).expect("saved");
    let picture = Picture::load(&path("8.png")).expect("a PNG");
    assert_eq!(picture.size, [2, 1]);
    // sRGB 188 is 0.5029 (IEC 61966-2-1).
    let [r, g, b] = picture.pixels[1];
    assert_eq!((r, b), (0.0, 1.0));
    assert!((g - 0.502_886).abs() < 1e-5, "{g}");
    // 16-bit gray; the content determines the format.
    let grey = image::ImageBuffer::<Luma<u16>, _>::from_pixel(1, 1, Luma([188 * 257]));
    let grey = DynamicImage::ImageLuma16(grey);
    grey.save_with_format(path("grey.exr"), ImageFormat::Png).expect("saved");
    assert_eq!(Picture::load(&path("grey.exr")).expect("a PNG").pixels[..], [[g; 3]]);
    let grey = GrayImage::from_pixel(1, 1, Luma([188]));
    grey.save(path("grey8.png")).expect("saved");
    assert_eq!(Picture::load(&path("grey8.png")).expect("a PNG").pixels[..], [[g; 3]]);
    for name in ["f.exr", "f.hdr"] {
        let float = Rgb32FImage::from_pixel(3, 2, Rgb([0.5, 2.0, 8.0]));
        float.save(path(name)).expect("saved");
        let picture = Picture::load(&path(name)).expect("a float image");
        assert_eq!((picture.size, picture.pixels[5]), ([3, 2], [0.5, 2.0, 8.0]));
    }
}

#[test]
fn bad_pictures_are_refused_with_their_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let nan = Rgb32FImage::from_fn(2, 2, |x, y| Rgb([if (x, y) == (1, 0) { f32::NAN } else { 0.0 }; 3]));
    nan.save(path("nan.exr")).expect("saved");
    RgbImage::new(64, 64).save(path("cut.png")).expect("saved");
    let bytes = fs::read(path("cut.png")).expect("read");
    fs::write(path("cut.png"), &bytes[..bytes.len() / 2]).expect("written");
    fs::write(path("text.png"), "not a picture").expect("written");
    fs::write(path("empty.png"), "").expect("written");
    for (name, problem) in [
        ("nan.exr", "the pixel in column 1, row 0 (counted from 0, top left) is not finite"),
        ("cut.png", "cannot use the image"),
        ("text.png", "cannot use the image"),
        ("empty.png", "cannot use the image"),
        ("none.png", "cannot read"),
    ] {
        let error = Picture::load(&path(name)).expect_err(name).to_string();
        assert!(error.contains(problem) && error.contains(name), "{error}");
    }
}

#[test]
fn a_scene_loads_each_file_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    RgbImage::new(2, 2).save(path("a.png")).expect("saved");
    RgbImage::new(2, 2).save(path("b.png")).expect("saved");
    fs::write(path("m.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("written");
    let text = "[rays]\nbounding_sphere = { radius = 9 }\n[sky]\nfaces = [\"a.png\", \"b.png\", \"./a.png\", \"a.png\", \"b.png\", \
                \"a.png\"]\nintensity = 2\n[materials.m]\ndiffuse = { image = \"b.png\" }\n[[objects]]\nshape = \"mesh\"\n\
                file = \"m.obj\"\nmaterial = \"m\"\n[[objects]]\nshape = \"mesh\"\nfile = \"m.obj\"\nmaterial = \"m\"\n";
    fs::write(path("scene.toml"), text).expect("written");
    let scene = Scene::load(&path("scene.toml"), &[]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(scene.pictures.len(), 2);
    assert_eq!(scene.sky, Sky::Faces([0, 1, 0, 0, 1, 0], 2.0, DMat3::IDENTITY));
    assert!(matches!(scene.materials[0].color, Pattern::Picture { picture: 1, .. }));

    // An error of a file is reported once: in the file if it has lines, and otherwise at its first reference.
    fs::write(path("m.obj"), "v 0 0 0\nf 1 2 3\n").expect("written");
    fs::write(path("b.png"), "").expect("written");
    let mistakes = mistakes_of(Scene::load(&path("scene.toml"), &[]));
    assert_eq!(mistakes.len(), 2, "{mistakes:?}");
    assert_eq!((mistakes[0].line, mistakes[0].column, mistakes[0].excerpt.as_str()), (4, 19, "\"b.png\""));
    assert_eq!((mistakes[1].file.clone(), mistakes[1].line), (path("m.obj"), 2));
}

/// Checks that frames share files, and that no scene receives another scene's file or a failed one.
#[test]
fn scenes_that_share_their_files_load_each_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    RgbImage::new(2, 2).save(path("a.png")).expect("saved");
    RgbImage::new(4, 2).save(path("b.png")).expect("saved");
    fs::write(path("m.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("written");
    fs::write(path("n.raw"), [1; 8]).expect("written");
    let scene = |sky: &str, offset: f64| {
        format!(
            "[rays]\nbounding_sphere = {{ radius = 9 }}\n[sky]\nimage = \"{sky}\"\n[materials.m]\ndiffuse = {{ image = \"a.png\" }}\n\
             [[objects]]\nshape = \"mesh\"\nfile = \"m.obj\"\nmaterial = \"m\"\n[[objects]]\nshape = \"sphere\"\n\
             interior = {{ kind = \"grid\", file = \"n.raw\", size = [2, 2, 2], type = \"u8\", min = [-1, -1, -1], \
             max = [1, 1, 1], offset = {offset} }}\n"
        )
    };
    let mut files = Files::default();
    let mut load = |text: &str| {
        fs::write(path("scene.toml"), text).expect("written");
        Scene::load_with(&mut files, &path("scene.toml"), &[], None)
    };
    let mut good = |text: &str| load(text).unwrap_or_else(|e| panic!("{e}"));
    let loaded = |scene: &Scene| match (&scene.objects[0].shape, &scene.objects[1].substance) {
        (shape, Substance::TransparentShadows(Interior { medium, .. })) => {
            let mesh = shape.mesh().expect("a mesh");
            let Grid(grid) = medium.downcast().expect("a grid");
            (Arc::clone(mesh), Arc::clone(grid))
        }
        other @ (_, Substance::Opaque(_)) => panic!("{other:?}"),
    };
    let [first, again, other] = [("a.png", 1.0), ("a.png", 1.0), ("b.png", 2.0)].map(|(sky, n)| good(&scene(sky, n)));
    let ((mesh_1, grid_1), (mesh_2, grid_2), (mesh_3, grid_3)) = (loaded(&first), loaded(&again), loaded(&other));
    assert!(Arc::ptr_eq(&mesh_1, &mesh_2) && Arc::ptr_eq(&mesh_1, &mesh_3));
    assert!(Arc::ptr_eq(&grid_1, &grid_2));
    assert!((grid_3.samples[0] - grid_1.samples[0] - 1.0).abs() < 1e-6, "with another use it is another grid");
    assert!(Arc::ptr_eq(&first.pictures[0].pixels, &again.pictures[0].pixels));
    // A scene has its own list of images, in the order of its references.
    assert_eq!(other.pictures.iter().map(|picture| picture.size).collect::<Vec<_>>(), [[4, 2], [2, 2]]);

    // Loaded files stay in the cache, and failed ones are loaded again.
    fs::write(path("m.obj"), "v 0 0 0\nf 1 2 3\n").expect("written");
    good(&scene("a.png", 1.0));
    assert_eq!(mistakes_of(load(&scene("c.png", 1.0))).len(), 1);
    RgbImage::new(2, 2).save(path("c.png")).expect("saved");
    load(&scene("c.png", 1.0)).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn a_jpeg_is_a_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.jpg");
    // A handwritten JPEG of one gray 8 × 8 block: baseline with DC coefficient 0, which is the value 128.
    let mut bytes = vec![0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0];
    bytes.extend([1; 64]);
    bytes.extend([0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0]);
    for table in [0, 0x10] {
        bytes.extend([0xFF, 0xC4, 0, 20, table, 1]);
        bytes.extend([0; 15]);
        bytes.push(0);
    }
    // Twice the one-bit word 0: no change, and the end of the block.
    bytes.extend([0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 63, 0, 0b0011_1111, 0xFF, 0xD9]);
    fs::write(&path, bytes).expect("written");
    let picture = Picture::load(&path).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(picture.size, [8, 8]);
    // sRGB 128 is 0.2158605 (IEC 61966-2-1).
    assert!(picture.pixels.iter().flatten().all(|x| (x - 0.215_860_5).abs() < 1e-6), "{:?}", picture.pixels[0]);
}
