//! Acceleration structures: a hierarchy, a grid and brute force find bit-identical first hits on every arc.

use std::fmt::Write as _;
use std::path::Path;

use bentray::gpu::{AccelStructure, Geometry, PreviousGeometry};
use bentray::program::{Analysis, DeviceProfile, Program, ProgramError, ProgramOptions, Schedule, Search};
use bentray::render::{RenderSettings, Renderer, Status, Traced, trace};
use bentray::scene::Scene;

use crate::shaders::Random;
use crate::support::gpu;

/// Returns a random point whose coordinates are at most `reach` from 0.
fn point(random: &mut Random, reach: f64) -> [f64; 3] {
    [0; 3].map(|_| random.within(-reach, reach))
}

/// Returns separate triangles, small and large, some of them twice in one position.
fn triangles(random: &mut Random, count: usize) -> String {
    let mut obj = String::new();
    for i in 0..count {
        let (middle, size) = (point(random, 6.0), if i % 9 == 0 { 3.0 } else { 0.6 });
        let corners = [0; 3].map(|_| {
            let off = point(random, size);
            [0, 1, 2].map(|k| middle[k] + off[k])
        });
        for _ in 0..=u32::from(i % 7 == 0) {
            for [x, y, z] in corners {
                writeln!(obj, "v {x} {y} {z}").unwrap();
            }
            obj += "f -3 -2 -1\n";
        }
    }
    obj
}

/// Every shape that is stored in lists.
const SHAPES: [&str; 6] = ["sphere", "ellipsoid", "box", "cylinder", "plane", "disk"];

/// Returns `of_each` objects of every shape, about `about` large, in positions that overlap.
fn shapes(random: &mut Random, of_each: usize, about: f64) -> String {
    let mut text = String::new();
    for i in 0..of_each {
        for shape in SHAPES {
            let (place, angles) = (point(random, 6.0), point(random, 180.0));
            let size = about * (2.0 / 3.0 + 2.0 / 3.0 * random.unit());
            let kind = if shape == "ellipsoid" { "sphere" } else { shape };
            let scale =
                if shape == "sphere" { format!("{size}") } else { format!("[{size}, {}, {}]", size * 1.5, size * 2.0) };
            let hole = if shape == "disk" && i % 2 == 0 { "inner_radius = 0.4\n" } else { "" };
            write!(
                text,
                "[[objects]]\nshape = \"{kind}\"\ntranslate = {place:?}\nrotate = {angles:?}\nscale = {scale}\n{hole}\
                 material = \"m\"\n"
            )
            .unwrap();
        }
    }
    text
}

const MATERIAL: &str = "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n";

fn starts(random: &mut Random, count: usize) -> Vec<[f64; 6]> {
    let ray = |random: &mut Random| {
        let (from, [u, v, w]) = (point(random, 9.0), point(random, 1.0));
        [from[0], from[1], from[2], u, v, w + 1e-3]
    };
    (0..count).map(|_| ray(random)).collect()
}

/// Laws with different arcs: lines, short arcs, long arcs in many pieces, and chords over many steps.
const RAYS: [&str; 4] = [
    "[law]\nkind = \"straight\"\n[rays]\n",
    "[law]\nkind = \"schwarzschild\"\ncenter = [0, 0, 14]\n[rays]\nmethod = \"rk4\"\n",
    "[law]\nkind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 3 }]\n[rays]\nmethod = \"rk4\"\nscaled_step = 0.5\narc_tolerance = 1e-3\n",
    "[law]\nkind = \"lorenz\"\norder = 2\nsigma = 0.1\nrho = 0.28\nbeta = 0.027\n[rays]\nmethod = \"rk4\"\nstep = 0.1\nsegment = \"chord\"\nsteps_per_segment = 4\n",
];

/// Returns the ends of the rays under one of `RAYS`, with one structure and schedule.
fn ends(
    folder: &Path,
    keys: &str,
    objects: &str,
    accelerate: &str,
    schedule: Schedule,
    rays: &[[f64; 6]],
) -> Vec<Traced> {
    let text = format!(
        "{keys}max_segments = 60\nbounding_sphere = {{ radius = 17 }}\nacceleration = \"{accelerate}\"\n{MATERIAL}{objects}"
    );
    let scene = Scene::parse(&text, &folder.join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"));
    let settings = RenderSettings {
        options: ProgramOptions { schedule, ..ProgramOptions::default() },
        ..RenderSettings::default()
    };
    trace(&gpu(), &scene, &settings, rays).unwrap().0
}

/// Compares every structure with brute force under every law, and returns the number of tested arcs over all laws.
fn arcs_agree(folder: &Path, objects: &str, rays: &[[f64; 6]], structures: &[(&str, Schedule)]) -> f64 {
    let mut arcs = 0.0;
    for keys in RAYS {
        let brute = ends(folder, keys, objects, "none", Schedule::Fused, rays);
        let met = brute.iter().filter(|end| end.status == Status::Hit).count();
        assert!(met > rays.len() / 5, "{met} hits: {keys}");
        arcs += brute.iter().map(|end| end.segments).sum::<f64>();
        for &(accelerate, schedule) in structures {
            let found = ends(folder, keys, objects, accelerate, schedule, rays);
            let different = brute.iter().zip(&found).filter(|(a, b)| a != b).count();
            let first = brute.iter().zip(&found).find(|(a, b)| a != b);
            assert_eq!(different, 0, "{accelerate}, {schedule:?}: {first:?}\n{keys}");
        }
    }
    println!("{arcs} segments");
    arcs
}

/// Checks at least 100,000 random arcs.
#[test]
fn every_structure_finds_the_same_first_hit() {
    let mut random = Random::new(5);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("loose.obj"), triangles(&mut random, 90)).unwrap();
    let objects =
        shapes(&mut random, 14, 0.3) + "[[objects]]\nshape = \"mesh\"\nfile = \"loose.obj\"\nmaterial = \"m\"\n";
    let rays = starts(&mut random, 15_000);
    let structures =
        [("bvh", Schedule::Fused), ("grid", Schedule::Fused), ("auto", Schedule::Fused), ("grid", Schedule::Segment)];
    let arcs = arcs_agree(folder.path(), &objects, &rays, &structures);
    assert!(arcs > 1e5, "{arcs} segments");
}

/// Checks large objects, few enough to be written out in the shaders.
#[test]
fn lists_written_out_are_the_same_lists() {
    let mut random = Random::new(9);
    let folder = tempfile::tempdir().unwrap();
    let objects = shapes(&mut random, 2, 2.0);
    let rays = starts(&mut random, 4000);
    arcs_agree(folder.path(), &objects, &rays, &[("auto", Schedule::Fused), ("bvh", Schedule::Segment)]);
}

fn program_of(scene: &Scene, geometry: &Geometry) -> Result<Program, ProgramError> {
    let options = ProgramOptions { device: DeviceProfile::cpu(8), ..ProgramOptions::default() };
    Program::new(scene, &geometry.analysis, &options, geometry.extent())
}

/// Checks that the structure is the requested one, and that a few shapes are a list if the scene requests none.
#[test]
fn the_structure_follows_the_scene() {
    let scene = |law: &str, accelerate: &str, of_each| {
        let text = format!(
            "[law]\nkind = \"{law}\"\n[rays]\nbounding_sphere = {{ radius = 17 }}\nacceleration = \"{accelerate}\"\n\
             {MATERIAL}{}",
            shapes(&mut Random::new(6), of_each, 0.3)
        );
        Scene::parse(&text, Path::new("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"))
    };
    let all = SHAPES.len();
    // A mask of near shapes has a limited number of bits in addition to the structure. Brute force has no masks, nor have a few shapes that
    // straight rays meet.
    for (law, accelerate, of_each, search, kinds, near) in [
        ("schwarzschild", "auto", 2, Search::Hierarchy, 0, true),
        ("schwarzschild", "auto", 6, Search::Hierarchy, 0, false),
        ("schwarzschild", "auto", 40, Search::Hierarchy, all, true),
        ("straight", "auto", 2, Search::Hierarchy, 0, false),
        ("straight", "auto", 40, Search::Hierarchy, all, true),
        ("straight", "bvh", 1, Search::Hierarchy, all, true),
        ("straight", "grid", 1, Search::Grid, all, true),
        ("schwarzschild", "none", 40, Search::List, 0, false),
        ("straight", "none", 600, Search::List, all, false),
    ] {
        let named = format!("{law}, {accelerate}, {of_each} of each");
        let scene = scene(law, accelerate, of_each);
        let geometry = Geometry::new(&scene);
        let Analysis { structure, .. } = &geometry.analysis;
        assert_eq!((structure.search, structure.solids.len()), (search, kinds), "{named}");
        let parts = program_of(&scene, &geometry).unwrap().passes[0].1.parts().join(" ");
        let part = format!("segment/structure/{}", search.name());
        assert_eq!(parts.contains(&part), kinds > 0, "{named}: {parts}");
        assert_eq!(parts.contains("segment/near_balls"), structure.near, "{named}: {parts}");
        assert_eq!((structure.near, structure.written_out), (near, accelerate == "auto"), "{named}");
    }
}

/// Writes twenty heaps of triangles, next to which rays pass, and a wall behind them.
fn heaps(each: usize) -> tempfile::TempDir {
    let mut obj = String::new();
    for i in 0..20 * each {
        let z = (i / each) as f64 + 1e-6 * (i % each) as f64;
        writeln!(obj, "v -5 -5 {z}\nv 5 -5 {z}\nv -5 5 {z}\nf -3 -2 -1").unwrap();
    }
    obj += "v -9 -9 -3\nv 9 -9 -3\nv 9 9 -3\nv -9 9 -3\nf -4 -3 -2 -1\n";
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("heaps.obj"), obj).unwrap();
    folder
}

fn heap_scene(folder: &tempfile::TempDir, accelerate: &str) -> Scene {
    let text = format!(
        "[image]\nsize = [8, 6]\n[camera]\nkind = \"orthographic\"\nposition = [3, 3, 30]\nheight = 1\n\
         [rays]\nmethod = \"euler\"\nstep = 50\nbounding_sphere = {{ radius = 40 }}\nmax_segments = 3\n\
         acceleration = \"{accelerate}\"\n{MATERIAL}[[objects]]\nshape = \"mesh\"\nfile = \"heaps.obj\"\nmaterial = \"m\"\n"
    );
    Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// A traversal that exceeds one pass continues in the next, in traces and in images; images record more passes if there were too few.
#[test]
fn long_walks_go_on_in_every_structure() {
    let gpu = gpu();
    let folder = heaps(3000);
    let rays: Vec<[f64; 6]> = (0..40).map(|i| [2.5 + 0.02 * f64::from(i), 3.0, 30.0, 0.0, 0.0, -1.0]).collect();
    for accelerate in ["bvh", "grid", "none"] {
        let scene = heap_scene(&folder, accelerate);
        let program = program_of(&scene, &Geometry::new(&scene)).unwrap();
        assert!(program.features.suspends, "{accelerate}");
        for schedule in [Schedule::Fused, Schedule::Segment] {
            let options = ProgramOptions { schedule, ..ProgramOptions::default() };
            let settings = RenderSettings { options, ..RenderSettings::default() };
            for end in trace(&gpu, &scene, &settings, &rays).unwrap().0 {
                assert_eq!(end.status, Status::Hit, "{accelerate} {schedule:?}");
                assert!((end.x[2] + 3.0).abs() < 1e-4, "{accelerate} {schedule:?}: {:?}", end.x);
            }
            let totals = Renderer::new(&gpu, &scene, settings).unwrap().render().unwrap().totals;
            assert_eq!((totals.rays, totals.count(Status::Hit)), (48, 48), "{accelerate} {schedule:?}: {totals}");
        }
    }
}

/// The contents of one cell are tested at once. If they exceed the work limit of a pass, as with a small detailed object in
/// a large scene, rays end as failed and are counted.
#[test]
fn a_heap_in_one_cell_fails_in_sight_or_is_met() {
    let gpu = gpu();
    let mut random = Random::new(8);
    let mut obj = String::from("v -5 -5 -3\nv 5 -5 -3\nv 5 5 9\nf -3 -2 -1\n");
    for _ in 0..80_000 {
        for _ in 0..3 {
            let [x, y, z] = point(&mut random, 1e-3);
            writeln!(obj, "v {x} {y} {z}").unwrap();
        }
        obj += "f -3 -2 -1\n";
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("heaps.obj"), obj).unwrap();
    let text = format!(
        "[image]\nsize = [2, 1]\n[camera]\nkind = \"orthographic\"\nposition = [0, 0, 30]\nheight = 1e-3\n\
         [rays]\nmethod = \"euler\"\nstep = 50\nbounding_sphere = {{ radius = 40 }}\nmax_segments = 3\n\
         acceleration = \"grid\"\n{MATERIAL}[[objects]]\nshape = \"mesh\"\nfile = \"heaps.obj\"\nmaterial = \"m\"\n"
    );
    let scene = Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap();
    for schedule in [Schedule::Whole, Schedule::Segment] {
        let settings = RenderSettings {
            options: ProgramOptions { schedule, ..ProgramOptions::default() },
            ..RenderSettings::default()
        };
        let totals = Renderer::new(&gpu, &scene, settings).unwrap().render().unwrap().totals;
        if gpu.profile.loop_budget.is_some() {
            let failed = totals.count(Status::Failed);
            assert!(failed > 0, "{schedule:?}: {totals}");
            assert_eq!((totals.overrun, totals.unfollowed()), (failed, failed), "{schedule:?}: {totals}");
        } else {
            assert_eq!((totals.unfollowed(), totals.overrun), (0, 0), "{schedule:?}: {totals}");
        }
    }
}

/// The structure is rebuilt only if an object moves.
#[test]
fn a_structure_is_kept_while_nothing_moves() {
    let text =
        format!("[rays]\nbounding_sphere = {{ radius = 17 }}\n{MATERIAL}{}", shapes(&mut Random::new(7), 20, 0.3));
    let scene = |text: &str| Scene::parse(text, Path::new("scene.toml"), &[]).unwrap();
    let after = |structure: &AccelStructure, scene: &Scene| {
        let before = PreviousGeometry { structure: Some(structure.clone()), ..PreviousGeometry::default() };
        Geometry::after(before, scene).structure
    };
    let first = Geometry::new(&scene(&text)).structure;
    assert!(first.items.len() == 20 * SHAPES.len() && first.nodes.len() > 20);
    assert_eq!(after(&first, &scene(&text)), first);
    let mut moved = scene(&text);
    moved.objects[0].transform = moved.objects[SHAPES.len()].transform;
    let fresh = Geometry::new(&moved).structure;
    assert!(fresh != first);
    assert_eq!(after(&first, &moved), fresh);
    let grid = text.replace("[rays]", "[rays]\nacceleration = \"grid\"");
    assert_eq!(after(&first, &scene(&grid)), Geometry::new(&scene(&grid)).structure);
}
