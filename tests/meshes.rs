//! Tests meshes: the hierarchy against brute force, walls without leaks, and traversals that continue in the next pass.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use bentray::gpu::Geometry;
use bentray::program::Program;
use bentray::program::{DeviceProfile, Mode, ProgramOptions};
use bentray::render::{RenderSettings, Status, trace};
use bentray::scene::Scene;
use glam::DVec3;

use crate::support::gpu;

/// A small generator of numbers in [-1, 1), so that the tests are identical in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.next(), self.next(), self.next());
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

const WALLS: &str = "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
    [[objects]]\nshape = \"mesh\"\nfile = \"mesh.obj\"\nmaterial = \"m\"\n";

fn bent_scene(folder: &Path, keys: &str) -> Scene {
    Scene::parse(&format!("{keys}\n{WALLS}"), &folder.join("scene.toml"), &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn with_mesh(obj: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mesh.obj"), obj).unwrap();
    folder
}

/// Returns a cube of half width `half`, each face cut into n × n squares of two triangles.
fn box_obj(half: f64, n: u32) -> String {
    let mut obj = String::new();
    let mut count = 0;
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            for i in 0..n {
                for j in 0..n {
                    for (a, b) in [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)] {
                        let (u, v) = (2.0 * f64::from(a) / f64::from(n) - 1.0, 2.0 * f64::from(b) / f64::from(n) - 1.0);
                        let mut p = [0.0; 3];
                        p[axis] = side * half;
                        p[(axis + 1) % 3] = u * half;
                        p[(axis + 2) % 3] = v * half;
                        writeln!(obj, "v {} {} {}", p[0], p[1], p[2]).unwrap();
                    }
                    writeln!(
                        obj,
                        "f {} {} {}\nf {} {} {}",
                        count + 1,
                        count + 2,
                        count + 3,
                        count + 1,
                        count + 3,
                        count + 4
                    )
                    .unwrap();
                    count += 4;
                }
            }
        }
    }
    obj
}

fn rays_from(x: DVec3, count: usize) -> Vec<[f64; 6]> {
    let mut random = Random(7);
    (0..count)
        .map(|_| {
            let d = random.direction();
            [x.x, x.y, x.z, d.x, d.y, d.z]
        })
        .collect()
}

/// Checks for every law and method that no ray escapes from a closed box of triangles.
#[test]
fn nothing_tunnels_out_of_a_closed_box() {
    let folder = with_mesh(&box_obj(9.0, 5));
    let mut random = Random(3);
    // A flow determines the direction, so rays have many starts instead.
    let starts: Vec<[f64; 6]> =
        (0..3_000).map(|_| [random.next() * 8.0, random.next() * 8.0, random.next() * 8.0, 1.0, 0.0, 0.0]).collect();
    std::fs::write(folder.path().join("starts.csv"), table(&starts)).unwrap();
    std::fs::write(folder.path().join("rays.csv"), table(&rays_from(DVec3::new(5.0, 4.0, 3.0), 3_000))).unwrap();
    let laws = [
        "kind = \"straight\"",
        "kind = \"schwarzschild\"",
        "kind = \"schwarzschild\"\nform = \"geodesic\"",
        "kind = \"sources\"\nsources = [{ position = [1, 0, 0], strength = 1 }, { position = [-3, 0, 0], strength = -1 }]",
        "kind = \"sources\"\nsources = [{ position = [1, 0, 0], strength = 0.5, falloff = { cubic = 6 } }]",
        "kind = \"sources\"\nsources = [{ position = [1, 0, 0], strength = 2, falloff = { yukawa = 0.5 } }]",
        "kind = \"lorenz\"",
        "kind = \"lorenz\"\norder = 2",
        "kind = \"rossler\"",
        "kind = \"rossler\"\norder = 2",
        "kind = \"medium\"\nindex = { kind = \"explosion\", radius = 8, amplitude = 0.3, frequency = 0.5 }",
    ];
    let methods = [
        "method = \"rk4\"",
        "method = \"dormand-prince\"\ntolerance = 1e-3",
        "method = \"euler\"\nstep = 0.3",
        "method = \"rk4\"\nstep = 0.5\nsegment = \"chord\"\nsteps_per_segment = 7",
        "method = \"euler-doubling\"\ndoubling = \"paper\"\ntolerance = 1e-2",
        "method = \"rk4-doubling\"\ntolerance = 1e-3",
        "method = \"snell\"",
    ];
    for (i, law) in laws.into_iter().enumerate() {
        for (k, method) in methods.into_iter().enumerate() {
            // Each law runs with half of the methods, and each method with half of the laws.
            if (i + k) % 2 == 1 || method.contains("snell") && !law.contains("medium") {
                continue;
            }
            let keys =
                format!("[law]\n{law}\n[rays]\n{method}\nmax_segments = 300\nbounding_sphere = {{ radius = 17 }}\n");
            let first_order = (law.contains("lorenz") || law.contains("rossler")) && !law.contains("order");
            let ends = traced_by_the_binary(folder.path(), &keys, if first_order { "starts.csv" } else { "rays.csv" });
            assert_eq!(ends.lines().count(), 3_001, "{keys}");
            let escaped = ends.lines().find(|line| line.contains(",escaped,"));
            assert!(escaped.is_none(), "{keys}: {escaped:?}");
        }
    }
}

fn traced_by_the_binary(folder: &Path, keys: &str, rays: &str) -> String {
    std::fs::write(folder.join("scene.toml"), format!("{keys}{WALLS}")).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.args(["trace", "scene.toml", "-o", "-", "--rays", rays]);
    command.current_dir(folder).env("BENTRAY_CACHE", "");
    let output = command.output().unwrap();
    assert!(output.status.success(), "{keys}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn table(rays: &[[f64; 6]]) -> String {
    let rows = rays.iter().map(|r| format!("{},{},{},{},{},{}\n", r[0], r[1], r[2], r[3], r[4], r[5]));
    format!("x,y,z,vx,vy,vz\n{}", rows.collect::<String>())
}

/// Returns the nearest hit of a straight line among all triangles, in f64.
#[allow(clippy::many_single_char_names)] // the usual letters of corners and barycentric coordinates
fn brute_force(geometry: &Geometry, x: DVec3, d: DVec3) -> Option<f64> {
    let corner = |i: u32| geometry.vertices[i as usize].position.as_dvec3();
    let hits = geometry.triangles.iter().filter_map(|[a, b, c, _]| {
        let (p, q, r) = (corner(*a) - x, corner(*b) - x, corner(*c) - x);
        let (u, v, w) = (d.dot(p.cross(q)), d.dot(q.cross(r)), d.dot(r.cross(p)));
        let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        let n = (q - p).cross(r - p);
        let t = n.dot(p) / n.dot(d);
        (inside && t > 0.0).then_some(t)
    });
    hits.min_by(f64::total_cmp)
}

#[test]
fn the_hierarchy_finds_what_brute_force_finds() {
    let gpu = gpu();
    let bunny = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/data/bunny.obj");
    let folder = with_mesh(&std::fs::read_to_string(bunny).unwrap());
    let scene = bent_scene(folder.path(), "[rays]\nbounding_sphere = { radius = 30 }");
    let geometry = Geometry::new(&scene);
    let mut random = Random(11);
    let rays: Vec<[f64; 6]> = (0..2000)
        .map(|_| {
            let x = 20.0 * random.direction();
            let d = (4.0 * DVec3::new(random.next(), 1.0 + random.next(), random.next()) - x).normalize();
            [x.x, x.y, x.z, d.x, d.y, d.z].map(|v| f64::from(v as f32))
        })
        .collect();
    let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
    let mut silhouettes = 0;
    for (ray, end) in rays.iter().zip(&ends) {
        let (x, d) = (DVec3::new(ray[0], ray[1], ray[2]), DVec3::new(ray[3], ray[4], ray[5]));
        match (brute_force(&geometry, x, d), end.status) {
            (Some(t), Status::Hit) => {
                let off = DVec3::from(end.x.map(f64::from)).distance(x + t * d);
                // One ray in a thousand may graze an edge that rounding decides.
                silhouettes += usize::from(off > 1e-3);
            }
            (None, Status::Escaped) => {}
            _ => silhouettes += 1,
        }
    }
    assert!(silhouettes <= 2, "{silhouettes} of {} rays differ", rays.len());
    assert!(ends.iter().filter(|end| end.status == Status::Hit).count() > 800);
}

/// A traversal of 30,000 coincident walls exceeds one pass: it is suspended, resumes, and finds the same hit.
#[test]
fn suspended_walks_go_on() {
    let gpu = gpu();
    let mut obj = String::new();
    for i in 0..30_000 {
        // All are in front of the rays and none is hit: the boxes overlap the lines of the rays, but the triangles are next to them.
        let z = 1e-6 * f64::from(i);
        writeln!(obj, "v -5 -5 {z}\nv 5 -5 {z}\nv -5 5 {z}\nf {} {} {}", 3 * i + 1, 3 * i + 2, 3 * i + 3).unwrap();
    }
    let first = 90_000;
    writeln!(
        obj,
        "v -9 -9 -3\nv 9 -9 -3\nv 9 9 -3\nv -9 9 -3\nf {} {} {} {}",
        first + 1,
        first + 2,
        first + 3,
        first + 4
    )
    .unwrap();
    let folder = with_mesh(&obj);
    for keys in [
        "[rays]\nbounding_sphere = { radius = 20 }",
        "[rays]\nmethod = \"euler\"\nstep = 30\nbounding_sphere = { radius = 20 }\nmax_segments = 5",
    ] {
        let scene = bent_scene(folder.path(), keys);
        let geometry = Geometry::new(&scene);
        let device = DeviceProfile::cpu(8);
        let options = ProgramOptions { mode: Mode::Trace, device, ..ProgramOptions::default() };
        let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
        assert!(program.features.suspends);
        let rays: Vec<[f64; 6]> = (0..100).map(|i| [1.0 + 0.03 * f64::from(i), 4.5, 9.0, 0.0, 0.0, -1.0]).collect();
        for schedule in [bentray::program::Schedule::Fused, bentray::program::Schedule::Segment] {
            let settings = RenderSettings {
                options: ProgramOptions { schedule, ..ProgramOptions::default() },
                ..RenderSettings::default()
            };
            let (ends, _) = trace(&gpu, &scene, &settings, &rays).unwrap();
            for end in ends {
                assert_eq!(end.status, Status::Hit, "{keys} {schedule:?}");
                assert!((end.x[2] + 3.0).abs() < 1e-4, "{keys} {schedule:?}: {:?}", end.x);
            }
        }
    }
}

/// Meshes of 100,000 triangles are usable, and the size of the program does not change.
#[test]
fn large_meshes_are_usable() {
    let gpu = gpu();
    let folder = with_mesh(&box_obj(9.0, 92));
    let scene = bent_scene(folder.path(), "[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 17 }");
    assert!(Geometry::new(&scene).triangles.len() > 100_000);
    let (ends, _) =
        trace(&gpu, &scene, &RenderSettings::default(), &rays_from(DVec3::new(5.0, 4.0, 3.0), 5_000)).unwrap();
    assert!(ends.iter().all(|end| matches!(end.status, Status::Hit | Status::Captured)));
}
