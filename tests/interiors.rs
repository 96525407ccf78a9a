//! Transparent objects and mirrors: all schedules agree, meshes agree with the
//! equivalent shapes, and rays are correct in the limiting cases of formulas.

use bentray::gpu::Geometry;
use bentray::program::{BindingKind, Layer, Mode, Program, ProgramOptions, RaySkipping, Schedule};
use bentray::render::{RenderSettings, Renderer, Rendering, Status, Traced, trace};
use bentray::scene::Scene;
use glam::DVec3;

use crate::exactness::unused;
use crate::support::{assert_same_image, gpu, scene, scenes_in};

const ROOM: &str = "[image]\nsize = [40, 30]\n[camera]\nposition = [1, 2, 8]\nfov = 40\n[sky]\ncolor = [0.3, 0.5, 0.8]\n\
    [materials.floor]\nkind = \"emissive\"\ncolor = { checker = [[0.9, 0.3, 0.2], [0.9, 0.9, 0.8]], repeat = [8, 8] }\n\
    [materials.mirror]\nkind = \"mirror\"\ncolor = [0.9, 0.8, 0.7]\n\
    [[objects]]\nshape = \"plane\"\ncenter = [0, -1.5, 0]\nsize = [16, 16]\nmaterial = \"floor\"\n";

fn room(rays: &str, objects: &[&str]) -> String {
    let objects = objects.iter().map(|object| format!("[[objects]]\n{object}\n")).collect::<Vec<_>>().concat();
    format!("[rays]\nbounding_sphere = {{ radius = 25 }}\n{rays}\n{ROOM}{objects}")
}

fn rendered(scene: &Scene, options: ProgramOptions) -> Rendering {
    let settings = RenderSettings { options, ..RenderSettings::default() };
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap()
}

const GLASS: &str = "shape = \"sphere\"\nradius = 1.2\ninterior = 1.5";
const FLAT_MIRROR: &str =
    "shape = \"disk\"\ncenter = [-2, 0, -1]\nnormal = [1, 0, 1]\nradius = 1.3\nmaterial = \"mirror\"";

#[test]
fn all_schedules_give_the_same_picture() {
    let scenes = [
        room("max_splits = 3", &[GLASS, FLAT_MIRROR]),
        room(
            "max_splits = 2\ntolerance = 1e-5",
            &["shape = \"sphere\"\ninterior = { kind = \"gaussian\", a = 1.6, b = 0.2 }"],
        ),
        room(
            "max_splits = 2",
            &[
                "shape = \"sphere\"\nradius = 2\ninterior = { kind = \"inverse-r\" }",
                "shape = \"sphere\"\ncenter = [0.8, 0.3, 0.5]\nradius = 0.5\nmaterial = \"mirror\"",
                "shape = \"cylinder\"\ncenter = [3, 0, 0]\nradius = 0.7\ninterior = { kind = \"rod\", n0 = 1.5, g = 0.5 }",
            ],
        ),
        // These splits need enough rounds for longer passes, and for several batches of them.
        room("max_splits = 8\n", &[GLASS, "shape = \"sphere\"\nradius = 0.6\ninterior = 1"]),
    ];
    // With few segments some rays end on a surface, and stay on the side that they came from.
    for (text, segments) in scenes.iter().flat_map(|text| [(text, 60), (text, 3)]) {
        let mut scene = scene(text);
        scene.rays.max_segments = segments;
        let options = |schedule, masks| ProgramOptions {
            schedule,
            masks,
            layers: Layer::ALL.to_vec(),
            ..ProgramOptions::default()
        };
        let first = rendered(&scene, options(Schedule::Fused, RaySkipping::List));
        for (schedule, masks) in [
            (Schedule::Whole, RaySkipping::List),
            (Schedule::Fused, RaySkipping::Off),
            (Schedule::Segment, RaySkipping::List),
            (Schedule::Paper, RaySkipping::Grid),
        ] {
            let other = rendered(&scene, options(schedule, masks));
            assert_same_image(&other, &first, &format_args!("{schedule:?}, masks {masks:?}\n{text}"));
            assert_eq!(first.totals.by_status, other.totals.by_status);
            assert_eq!(first.totals.segments, other.totals.segments, "{schedule:?}, masks {masks:?}");
        }
    }
}

/// The cube |x|, |y|, |z| ≤ 1, each face of two triangles.
const CUBE: &str = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
    f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

#[test]
fn a_closed_mesh_of_glass_is_what_its_shape_is() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("cube.obj"), CUBE).unwrap();
    let picture = |object: &str, camera: &str| {
        let text = room("max_splits = 3", &[object]).replace("position = [1, 2, 8]", camera);
        let scene = Scene::parse(&text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|e| panic!("{e}"));
        rendered(&scene, ProgramOptions::default()).band.color
    };
    let inside = "position = [0.1, 0.2, 0.3]\nlook_at = [0, 0, -5]";
    let turned = "scale = 1.1\nrotate = [10, 25, 5]\ninterior = 1.5";
    let on_the_floor = "scale = 1.1\nrotate = [0, 25, 0]\ntranslate = [0, -0.4, 0]\ninterior = 1.5";
    let outside = "position = [1, 2, 8]";
    for (camera, place) in [(outside, turned), (inside, turned), (outside, on_the_floor)] {
        let mesh = picture(&format!("shape = \"mesh\"\nfile = \"cube.obj\"\n{place}"), camera);
        let cube = picture(&format!("shape = \"box\"\nsize = [2, 2, 2]\n{place}"), camera);
        let pixels = mesh[0].len();
        let agree = (0..pixels).filter(|&i| (0..3).all(|c| (mesh[c][i] - cube[c][i]).abs() < 1e-4)).count();
        assert!(agree * 1000 >= pixels * 990, "{agree} of {pixels} pixels agree, {camera}");
    }
}

/// A mesh with inward winding, and one of two overlapping parts, agree with the boxes that they consist of: for single
/// rays, in images, from inside, and in shadows.
#[test]
fn meshes_are_solid_however_their_files_wind_them() {
    let folder = tempfile::tempdir().unwrap();
    let inward = CUBE.lines().map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
        ["f", a, b, c, d] => format!("f {d} {c} {b} {a}\n"),
        _ => format!("{line}\n"),
    });
    std::fs::write(folder.path().join("inward.obj"), inward.collect::<String>()).unwrap();
    // Two boxes that overlap by half; four faces of each are coplanar with faces of the other.
    let shifted = |by: f64| {
        CUBE.lines().map(move |line| match line.split(' ').collect::<Vec<_>>()[..] {
            ["v", x, y, z] => format!("v {} {y} {z}\n", x.parse::<f64>().unwrap() + by),
            ["f", ..] if by > 0.0 => {
                let corner = |i: &str| (i.parse::<usize>().unwrap() + 8).to_string();
                format!("f {}\n", line.split(' ').skip(1).map(corner).collect::<Vec<_>>().join(" "))
            }
            _ => format!("{line}\n"),
        })
    };
    std::fs::write(folder.path().join("both.obj"), shifted(-0.5).chain(shifted(0.5)).collect::<String>()).unwrap();
    let read =
        |text: &str| Scene::parse(text, &folder.path().join("scene.toml"), &[]).unwrap_or_else(|e| panic!("{e}"));
    let rays = [
        [-5.0, -0.9, -0.45, 1.0, 0.2, 0.1],
        [-5.0, 0.3, 0.2, 1.0, -0.1, 0.03],
        [0.1, 0.2, 0.3, -0.5, 0.3, 0.8],
        [0.9, 0.2, 0.3, 0.1, -0.3, 0.9],
    ];
    for (file, size) in [("inward", "[2, 2, 2]"), ("both", "[3, 2, 2]")] {
        let ends = |object: &str| {
            let scene =
                read(&format!("[rays]\nbounding_sphere = {{ radius = 20 }}\n[[objects]]\n{object}\ninterior = 1.5\n"));
            trace(&gpu(), &scene, &RenderSettings::default(), &rays).unwrap().0
        };
        let mesh = format!("shape = \"mesh\"\nfile = \"{file}.obj\"");
        let cuboid = format!("shape = \"box\"\nsize = {size}");
        let apart = |a: [f64; 3], b: [f64; 3]| DVec3::from(a).distance(b.into());
        for (found, expected) in ends(&mesh).into_iter().zip(ends(&cuboid)) {
            assert_eq!(found.status, expected.status, "{file}");
            // A few rounding errors at 20 units from the center.
            assert!(apart(found.x, expected.x) < 2e-5 && apart(found.v, expected.v) < 2e-6, "{file}: {found:?}");
        }
        let light = "[[lights]]\nkind = \"point\"\nposition = [0.5, 6, 1]\nshadows = \"straight-rays\"\n\
            [materials.white]\n[[objects]]\nshape = \"plane\"\ncenter = [0, -1.4, 0]\nsize = [9, 9]\nmaterial = \"white\"\n";
        for camera in ["position = [1, 2, 8]", "position = [0.9, 0.2, 0.3]\nlook_at = [0, 0, -5]"] {
            let picture = |object: &str| {
                let text = room("max_splits = 3", &[&format!("{object}\ninterior = 1.5")]);
                let scene = read(&(text.replace("position = [1, 2, 8]", camera) + light));
                rendered(&scene, ProgramOptions::default()).band.color
            };
            let (mesh, cuboid) = (picture(&mesh), picture(&cuboid));
            let pixels = mesh[0].len();
            let agree = (0..pixels).filter(|&i| (0..3).all(|c| (mesh[c][i] - cuboid[c][i]).abs() < 1e-3)).count();
            // At the edges rounding decides which face light meets: 98.2 % on a GPU that merges operations.
            assert!(agree * 1000 >= pixels * 975, "{file}: {agree} of {pixels} pixels agree, {camera}");
        }
    }
}

/// The mean with one random branch per sample is correct: the noise of this number of samples is a few thousandths.
#[test]
fn random_branches_have_the_mean_of_all() {
    let mean = |rays: &str, samples: u32| {
        let mut scene = scene(&room(rays, &[GLASS, FLAT_MIRROR]));
        scene.image.size = [12, 9];
        scene.image.samples = samples;
        let color = rendered(&scene, ProgramOptions::default()).band.color;
        color.map(|channel| f64::from(channel.iter().sum::<f32>()) / channel.len() as f64)
    };
    let (all, random) = (mean("max_splits = 8", 16), mean("max_splits = \"stochastic\"", 400));
    for (a, b) in all.iter().zip(&random) {
        assert!((a - b).abs() < 4e-3, "{all:?} {random:?}");
    }
}

fn traced(text: &str, rays: &[[f64; 6]]) -> Vec<Traced> {
    trace(&gpu(), &scene(text), &RenderSettings::default(), rays).unwrap().0
}

/// The closed form finds the first intersection of a spiral with a ball, like many small steps in 64 bits.
#[test]
fn spirals_meet_what_is_in_their_way() {
    let text = |rays: &str| {
        format!(
            "[rays]\nbounding_sphere = {{ radius = 12 }}\nmax_segments = 4000\n{rays}\n[materials.m]\nkind = \"emissive\"\n\
             color = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\nradius = 4\ninterior = {{ kind = \"inverse-r\" }}\n\
             [[objects]]\nshape = \"sphere\"\ncenter = [-1.2, 0.4, 0.3]\nradius = 0.7\nmaterial = \"m\"\n\
             [[objects]]\nshape = \"sphere\"\ncenter = [0.5, 2.6, -0.6]\nradius = 0.5\nmaterial = \"m\"\n"
        )
    };
    let golden = |i: u32| {
        let y = 1.0 - (2.0 * f64::from(i) + 1.0) / 300.0;
        let (sin, cos) = (2.399_963 * f64::from(i)).sin_cos();
        DVec3::new((1.0 - y * y).sqrt() * cos, y, (1.0 - y * y).sqrt() * sin)
    };
    let start = DVec3::new(1.1, 0.2, 0.7);
    // Only the closed form can follow tighter spirals.
    let open = |d: &DVec3| d.dot(start.normalize()).abs() > 0.06;
    let rays: Vec<[f64; 6]> =
        (0..300).map(golden).filter(open).map(|d| [start.x, start.y, start.z, d.x, d.y, d.z]).collect();
    let closed = traced(&text(""), &rays);
    let stepped = traced(&text("method = \"dormand-prince\"\ntolerance = 1e-9\nprecision = \"f64\""), &rays);
    let mut met = 0;
    for ((ray, a), b) in rays.iter().zip(&closed).zip(&stepped) {
        // A ray that winds into the center in steps never reaches it.
        let b_status = if b.status == Status::Exhausted { Status::Captured } else { b.status };
        assert_eq!((a.status, a.object), (b_status, b.object), "{ray:?}");
        met += u32::from(a.status == Status::Hit);
        if a.status == Status::Hit {
            assert!(a.distance_to(b) < 2e-4, "{ray:?}: {:?} and {:?}", a.x, b.x);
        }
    }
    assert!(met > 15, "{met}");
}

/// Checks limiting cases of the formulas: rays through the exact center, along the axis, tangent, and from the surface itself.
#[test]
fn rays_in_their_limits() {
    let lens = |medium: &str| {
        format!("[rays]\nbounding_sphere = {{ radius = 5 }}\n[[objects]]\nshape = \"sphere\"\ninterior = {medium}\n")
    };
    let along_x = [[-4.0, 0.0, 0.0, 1.0, 0.0, 0.0]];
    // Media with the distance from the axis at which a ray touches the sphere, or just misses it if the index jumps.
    for (medium, touching) in [
        ("1.5", 1.00001),
        ("{ kind = \"luneburg\", c = 2 }", 1.0),
        ("{ kind = \"luneburg\", c = 10 }", 1.00001),
        ("{ kind = \"maxwell-fisheye\", n0 = 2 }", 1.0),
        ("{ kind = \"gaussian\", a = 1.4 }", 1.00001),
    ] {
        let text = lens(medium);
        let centre = traced(&text, &along_x)[0];
        assert_eq!(centre.status, Status::Escaped, "{medium}");
        assert!(DVec3::from(centre.x).distance(DVec3::X * 5.0) < 2e-6, "{medium}: {:?}", centre.x);
        // A tangent ray continues unchanged, whether it hits or misses.
        let tangent = traced(&text, &[[-4.0, touching, 0.0, 1.0, 0.0, 0.0]])[0];
        let d = DVec3::from(tangent.v).normalize();
        assert!(tangent.status == Status::Escaped && d.distance(DVec3::X) < 5e-3, "{medium}: {d}");
        // One ray from the surface inward through the sphere, and one from the surface straight outward.
        let [inwards, outwards] = [1.0, -1.0].map(|side| traced(&text, &[[-1.0, 0.0, 0.0, side, 0.0, 0.0]])[0]);
        assert!(DVec3::from(inwards.x).distance(DVec3::X * 5.0) < 2e-6, "{medium}: {:?}", inwards.x);
        assert!(DVec3::from(outwards.x).distance(DVec3::NEG_X * 5.0) < 2e-6, "{medium}: {:?}", outwards.x);
        assert_eq!(outwards.steps, 1, "{medium}");
    }
    let rod = "[rays]\nbounding_sphere = { radius = 20 }\n[[objects]]\nshape = \"cylinder\"\naxis = [1, 0, 0]\nheight = 12\n\
               interior = { kind = \"rod\", n0 = 1.6, g = 0.3 }\n";
    let end = traced(rod, &[[-15.0, 0.0, 0.0, 1.0, 0.0, 0.0]])[0];
    assert!(DVec3::from(end.x).distance(DVec3::X * 20.0) < 1e-5, "{:?}", end.x);
    // Beyond the critical angle no light leaves: inside glass a steep ray is reflected at the first face that it hits.
    let slab =
        "[rays]\nbounding_sphere = { radius = 5 }\n[[objects]]\nshape = \"box\"\nsize = [8, 1, 1]\ninterior = 1.5\n";
    let total = traced(slab, &[[0.0, 0.0, 0.0, 1.0, 0.4, 0.0]])[0];
    assert_eq!(total.status, Status::Escaped);
    assert!(total.x[0] > 3.9 && total.v[0] > 0.0, "guided to the end: {:?} {:?}", total.x, total.v);
}

#[test]
fn nothing_can_be_taken_out_of_the_programs_of_interiors() {
    for path in scenes_in("scenes/thesis") {
        let scene = Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
        let geometry = Geometry::new(&scene);
        for schedule in [Schedule::Paper, Schedule::Segment, Schedule::Fused] {
            for (mode, masks) in [
                (Mode::Picture, RaySkipping::List),
                (Mode::Picture, RaySkipping::Off),
                (Mode::Trace, RaySkipping::Grid),
            ] {
                let options = ProgramOptions { schedule, masks, mode, ..ProgramOptions::default() };
                let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent()).unwrap();
                for (pass, linked, reflection) in &program.passes {
                    let uniform =
                        |kind: &BindingKind| matches!(kind, BindingKind::Uniform(_) | BindingKind::Block { .. });
                    let buffers = reflection.bindings.iter().filter(|binding| uniform(&binding.kind)).count();
                    assert!(buffers <= 3, "{}: pass {} binds {buffers}", path.display(), pass.entry());
                    let unused = unused(linked).unwrap_or_else(|error| panic!("{error}"));
                    assert!(unused.is_empty(), "{}: pass {} has {unused:?}", path.display(), pass.entry());
                }
            }
        }
    }
}
