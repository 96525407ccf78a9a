//! Tests of generated normals: smooth where faces meet at a small angle, sharp at edges.

use std::fmt::Write as _;

use glam::{DVec2, DVec3, Vec3};

use super::{good, marked};
use crate::assets::MeshRequest;
use crate::scene::Mesh;

/// Returns a sphere of n rings and 2n sectors, with vertices repeated for every face as in STL.
fn globe(n: u32) -> String {
    let mut text = String::new();
    let point = |i: u32, j: u32| {
        let turn = |part: u32| DVec2::from_angle(std::f64::consts::PI * f64::from(part) / f64::from(n));
        let (down, round) = (turn(i), turn(j % (2 * n)));
        // The poles have exactly one position.
        match i {
            0 => DVec3::Y,
            _ if i == n => DVec3::NEG_Y,
            _ => DVec3::new(down.y * round.x, down.x, -down.y * round.y),
        }
    };
    let mut count = 0;
    for (i, j) in (0..n).flat_map(|i| (0..2 * n).map(move |j| (i, j))) {
        for (k, l) in [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)] {
            let p = point(k, l);
            writeln!(text, "v {:.7} {:.7} {:.7}", p.x, p.y, p.z).expect("written");
        }
        writeln!(text, "f {} {} {} {}", count + 1, count + 2, count + 3, count + 4).expect("written");
        count += 4;
    }
    text
}

fn mesh(text: &str, crease: f64) -> Mesh {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("a.obj"), text).expect("written");
    let scene = format!(
        "[rays]\nbounding_sphere = {{ radius = 9 }}\n[materials.m]\n[[objects]]\nshape = \"mesh\"\nfile = \"a.obj\"\nmaterial = \"m\"\n\
         crease = {crease}\n"
    );
    std::fs::write(folder.path().join("scene.toml"), scene).expect("written");
    let scene = crate::scene::Scene::load(&folder.path().join("scene.toml"), &[]).unwrap_or_else(|e| panic!("{e}"));
    scene.objects[0].shape.mesh().map(|mesh| (**mesh).clone()).expect("a mesh")
}

/// Checks normals on a unit sphere. The axis of a triangle's circumscribed circle of radius r is its normal, and every corner is at the
/// angle asin r from it. A mean of such normals is at most as far from the corner as the farthest.
#[test]
fn a_globe_is_smooth() {
    let text = globe(24);
    let smooth = mesh(&text, MeshRequest::CREASE);
    let mut bound = 0.0_f64;
    for triangle in &smooth.triangles {
        let [a, b, c] = triangle.map(|i| smooth.vertices[i as usize].position.as_dvec3());
        let area = (b - a).cross(c - a).length() / 2.0;
        bound = bound.max((a.distance(b) * b.distance(c) * c.distance(a) / (4.0 * area)).asin());
    }
    assert!(bound < 0.1, "{bound}");
    for vertex in &smooth.vertices {
        let off = vertex.normal.as_dvec3().angle_between(vertex.position.as_dvec3());
        assert!(off <= bound + 1e-6, "{off} {bound} at {}", vertex.position);
    }
    // One vertex per position: 23 rings of 48, and the poles.
    assert_eq!(smooth.vertices.len(), 23 * 48 + 2);
    // Flat faces: four corners per face, three at the poles.
    assert_eq!(mesh(&text, 0.0).vertices.len(), 48 * (22 * 4 + 2 * 3));
    // Adjacent faces of a ring differ by 7.5 degrees at the equator.
    assert!(mesh(&text, 5.0).vertices.len() > smooth.vertices.len());
}

#[test]
fn a_cube_is_sharp_until_it_is_told_not_to() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\n\
                f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let sharp = mesh(text, MeshRequest::CREASE);
    assert_eq!(sharp.vertices.len(), 24);
    assert!(sharp.vertices.iter().all(|v| [Vec3::X, Vec3::Y, Vec3::Z].contains(&v.normal.abs())));
    assert_eq!(mesh(text, 89.9).vertices, sharp.vertices);
    // Three right angles meet at every corner.
    let round = mesh(text, 91.0);
    assert_eq!(round.vertices.len(), 8);
    for vertex in &round.vertices {
        let out = (vertex.position - Vec3::splat(0.5)).normalize();
        assert!(vertex.normal.abs_diff_eq(out, 1e-6), "{vertex:?}");
    }
}

#[test]
fn edges_that_are_sharp_divide_what_is_smooth() {
    // A roof of four slopes, with angles of 20 degrees between neighbors except for the middle two, which differ by 40.
    let mut text = String::new();
    let (mut x, mut y) = (0.0, 0.0);
    for slope in [None, Some(40.0), Some(20.0), Some(-20.0), Some(-40.0_f64)] {
        if let Some(slope) = slope {
            (x, y) = (x + slope.to_radians().cos(), y + slope.to_radians().sin());
        }
        writeln!(text, "v {x} {y} 0\nv {x} {y} 1").expect("written");
    }
    for i in 0..4 {
        writeln!(text, "f {} {} {} {}", 2 * i + 1, 2 * i + 2, 2 * i + 4, 2 * i + 3).expect("written");
    }
    let roof = mesh(&text, 30.0);
    // Five edges, with the ridge counted twice.
    assert_eq!(roof.vertices.len(), 12);
    let slopes = |x: f32| {
        let here = roof.vertices.iter().filter(|v| (v.position.x - x).abs() < 1e-4 && v.position.z == 0.0);
        let mut all: Vec<f32> = here.map(|v| v.normal.x.atan2(v.normal.y).abs().to_degrees().round()).collect();
        all.sort_by(f32::total_cmp);
        all
    };
    let ridge = 40.0_f32.to_radians().cos() + 20.0_f32.to_radians().cos();
    assert_eq!(slopes(ridge), [20.0, 20.0]);
    assert_eq!(slopes(40.0_f32.to_radians().cos()), [30.0]);
}

/// Checks that many faces at one vertex and one edge take no longer than an equal number elsewhere.
#[test]
fn a_fan_at_one_vertex_is_quick() {
    let mut text = "v 0 0 0\nv 0 0 1\n".to_owned();
    for i in 0..100_000 {
        let (s, c) = (f64::from(i) * 1e-4).sin_cos();
        writeln!(text, "v {c} {s} 0\nf 1 2 {}", i + 3).expect("written");
    }
    let started = std::time::Instant::now();
    assert_eq!(mesh(&text, 30.0).triangles.len(), 100_000);
    assert!(started.elapsed().as_secs() < 20, "{:?}", started.elapsed());
}

#[test]
fn a_crease_is_an_angle_of_a_mesh() {
    let top = "[rays]\nbounding_sphere = { radius = 30 }\n[materials.m]\n";
    let mesh = "[[objects]]\nshape = \"mesh\"\nmaterial = \"m\"\nfile = \"scenes/stability/sheet.obj\"\n";
    assert!(marked(&format!("{top}{mesh}crease = «181»\n")).problem.contains("an angle from 0 to 180 degrees"));
    let sphere = "[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n«crease» = 3\n";
    assert!(marked(&format!("{top}{sphere}")).help.contains("mesh"));
    // One file with two settings is two meshes.
    let scene = good(&format!("{top}{mesh}crease = 0\n{mesh}"));
    let [one, other] = [0, 1].map(|i| scene.objects[i].shape.mesh().expect("a mesh"));
    assert!(!std::sync::Arc::ptr_eq(one, other));
}
