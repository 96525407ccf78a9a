//! Tests mesh instances: rays hit every copy, and a traversal stops and resumes like any other.

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::path::Path;

use bentray::gpu::Geometry;
use bentray::program::{Analysis, DeviceProfile, Program, ProgramOptions, Schedule};
use bentray::render::{RenderSettings, Renderer, Status, Traced, trace};
use bentray::scene::Scene;

use crate::shaders::Random;
use crate::support::gpu;

const LAWS: [&str; 2] = [
    "[law]\nkind = \"straight\"\n[rays]\n",
    "[law]\nkind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 3 }]\n[rays]\nmethod = \"rk4\"\nscaled_step = 0.5\narc_tolerance = 1e-3\n",
];

/// Returns a bumpy ball with this number of rings.
fn ball(rings: u32) -> String {
    let mut obj = String::new();
    let turns = 2 * rings;
    for i in 0..=rings {
        for j in 0..turns {
            let (theta, phi) = (f64::from(i) / f64::from(rings) * PI, f64::from(j) / f64::from(turns) * TAU);
            let r = 1.0 + 0.1 * (5.0 * theta).sin() * (4.0 * phi).cos();
            let [x, y, z] = [theta.sin() * phi.cos(), theta.cos(), theta.sin() * phi.sin()].map(|x| r * x);
            writeln!(obj, "v {x} {y} {z}").unwrap();
        }
    }
    for i in 0..rings {
        for j in 0..turns {
            let at = |i: u32, j: u32| 1 + i * turns + j % turns;
            writeln!(obj, "f {} {} {} {}", at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)).unwrap();
        }
    }
    obj
}

/// Returns `count` rotated and stretched instances of the ball, a different mesh, and spheres.
fn places(random: &mut Random, count: usize) -> String {
    let mut text = String::from(
        "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
         [[objects]]\nshape = \"mesh\"\nfile = \"floor.obj\"\nmaterial = \"m\"\n",
    );
    for _ in 0..count {
        let [place, turn] = [7.0, 180.0].map(|reach| [0; 3].map(|_| random.within(-reach, reach)));
        let scale = [0; 3].map(|_| random.within(0.2, 0.7));
        write!(
            text,
            "[[objects]]\nshape = \"mesh\"\nfile = \"ball.obj\"\ntranslate = {place:?}\nrotate = {turn:?}\n\
             scale = {scale:?}\nmaterial = \"m\"\n"
        )
        .unwrap();
    }
    for _ in 0..20 {
        let center = [0; 3].map(|_| random.within(-7.0, 7.0));
        write!(text, "[[objects]]\nshape = \"sphere\"\ncenter = {center:?}\nradius = 0.5\nmaterial = \"m\"\n").unwrap();
    }
    text
}

fn scene(folder: &Path, keys: &str, accelerate: &str, objects: &str) -> Scene {
    let text = format!(
        "{keys}max_segments = 60\nbounding_sphere = {{ radius = 17 }}\nacceleration = \"{accelerate}\"\n{objects}"
    );
    Scene::parse(&text, &folder.join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn ends(scene: &Scene, schedule: Schedule, rays: &[[f64; 6]]) -> Vec<Traced> {
    let settings = RenderSettings {
        options: ProgramOptions { schedule, ..ProgramOptions::default() },
        ..RenderSettings::default()
    };
    trace(&gpu(), scene, &settings, rays).unwrap().0
}

fn rays(random: &mut Random, count: usize) -> Vec<[f64; 6]> {
    let ray = |random: &mut Random| {
        let [from, way] = [9.0, 1.0].map(|reach| [0; 3].map(|_| random.within(-reach, reach)));
        [from[0], from[1], from[2], way[0], way[1], way[2] + 1e-3]
    };
    (0..count).map(|_| ray(random)).collect()
}

/// Compares instances with the grid, which copies every mesh. Hits at grazing angles and at edges may differ by rounding.
#[test]
fn a_mesh_that_is_kept_once_is_met_where_its_copies_are() {
    let mut random = Random::new(31);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("ball.obj"), ball(37)).unwrap();
    std::fs::write(folder.path().join("floor.obj"), "v -9 -8 -9\nv 9 -8 -9\nv 9 -8 9\nv -9 -8 9\nf 1 2 3 4\n").unwrap();
    let objects = places(&mut random, 50);
    let rays = rays(&mut random, 800);
    for keys in LAWS {
        let [once, copied] = ["bvh", "grid"].map(|accelerate| scene(folder.path(), keys, accelerate, &objects));
        assert!(Analysis::of(&once).structure.once && !Analysis::of(&copied).structure.once);
        let found = ends(&once, Schedule::Fused, &rays);
        let copies = ends(&copied, Schedule::Fused, &rays);
        let met = found.iter().filter(|end| end.status == Status::Hit).count();
        assert!(met > rays.len() / 8, "{met} hits: {keys}");
        let far = |a: &Traced, b: &Traced| {
            a.status != b.status || a.object != b.object || (0..3).any(|k| (a.x[k] - b.x[k]).abs() > 1e-3)
        };
        let apart: Vec<_> = found.iter().zip(&copies).filter(|(a, b)| far(a, b)).take(4).collect();
        assert!(apart.len() < 4, "{keys}{apart:?}");
        let other = ends(&once, Schedule::Segment, &rays);
        let first = found.iter().zip(&other).find(|(a, b)| a != b);
        assert!(first.is_none(), "{first:?}\n{keys}");
    }
}

/// A heap of separate triangles with many instances in one position: a ray visits far more nodes than a pass has
/// iterations, and hits an object behind them all.
#[test]
fn long_walks_through_meshes_that_are_kept_once_go_on() {
    let mut random = Random::new(32);
    let folder = tempfile::tempdir().unwrap();
    let mut obj = String::new();
    for _ in 0..6000 {
        // All boxes contain the center, and no triangle does.
        let [x, z] = [random.within(1.0, 2.0), random.within(-1.0, 1.0)];
        writeln!(obj, "v {x} -0.8 {z}\nv -0.8 {x} {z}\nv {x} {x} {z}\nf -3 -2 -1").unwrap();
    }
    std::fs::write(folder.path().join("heap.obj"), obj).unwrap();
    std::fs::write(folder.path().join("floor.obj"), "v -9 -9 -3\nv 9 -9 -3\nv 9 9 -3\nv -9 9 -3\nf 1 2 3 4\n").unwrap();
    let mut objects = String::from(
        "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
         [[objects]]\nshape = \"mesh\"\nfile = \"floor.obj\"\nmaterial = \"m\"\n",
    );
    for k in 0..50 {
        let z = 0.01 * f64::from(k);
        write!(
            objects,
            "[[objects]]\nshape = \"mesh\"\nfile = \"heap.obj\"\ntranslate = [0, 0, {z}]\nmaterial = \"m\"\n"
        )
        .unwrap();
    }
    let keys =
        "[camera]\nposition = [0, 0, 14]\nfov = 0.5\n[image]\nsize = [4, 3]\n[law]\nkind = \"straight\"\n[rays]\n";
    let scene = scene(folder.path(), keys, "bvh", &objects);
    let geometry = Geometry::new(&scene);
    let options = ProgramOptions { device: DeviceProfile::cpu(8), ..ProgramOptions::default() };
    let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
    assert!(geometry.analysis.structure.once && program.features.suspends);
    let rays: Vec<[f64; 6]> = (0..10).map(|i| [-0.05 + 0.01 * f64::from(i), 0.0, 14.0, 0.0, 0.0, -1.0]).collect();
    for schedule in [Schedule::Fused, Schedule::Segment, Schedule::Whole] {
        for end in ends(&scene, schedule, &rays) {
            assert!(end.status == Status::Hit && (end.x[2] + 3.0).abs() < 1e-4, "{schedule:?}: {end:?}");
        }
        let settings = RenderSettings {
            options: ProgramOptions { schedule, ..ProgramOptions::default() },
            ..RenderSettings::default()
        };
        let totals = Renderer::new(&gpu(), &scene, settings).unwrap().render().unwrap().totals;
        assert_eq!((totals.rays, totals.count(Status::Hit)), (12, 12), "{schedule:?}: {totals}");
    }
}

/// Neighboring rays that traverse different nodes wait for each other's loops, and this does not use up their common limit
/// of iterations. The objects are needles, of which many are near a ray and few are hit.
#[test]
fn walks_side_by_side_count_together() {
    let mut random = Random::new(1);
    let folder = tempfile::tempdir().unwrap();
    let mut obj = String::new();
    for _ in 0..60_000 {
        let [from, way] = [6.0, 4.0].map(|reach| [0; 3].map(|_| random.within(-reach, reach)));
        for (far, off) in [(0.0, 0.0), (1.0, 0.0), (1.0, 2e-4)] {
            let [x, y, z] = [0, 1, 2].map(|k| from[k] + far * way[k] + off * way[(k + 1) % 3]);
            writeln!(obj, "v {x} {y} {z}").unwrap();
        }
        obj += "f -3 -2 -1\n";
    }
    std::fs::write(folder.path().join("needles.obj"), obj).unwrap();
    let objects = "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
                   [[objects]]\nshape = \"mesh\"\nfile = \"needles.obj\"\nmaterial = \"m\"\n";
    let rays = rays(&mut random, 256);
    let [hierarchy, grid] = ["bvh", "grid"].map(|accelerate| scene(folder.path(), LAWS[1], accelerate, objects));
    let found = ends(&hierarchy, Schedule::Segment, &rays);
    for (name, scene) in [("bvh", hierarchy), ("grid", grid)] {
        let other = ends(&scene, Schedule::Fused, &rays);
        let first = found.iter().zip(&other).find(|(a, b)| a != b);
        assert!(first.is_none(), "{name}: {first:?}");
    }
}
