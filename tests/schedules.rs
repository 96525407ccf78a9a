//! All schedules, with masks and without, give bit-identical images on a CPU.
//!
//! The binary runs in a separate process for each image, so the comparison covers the output that users get.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::Command;

use bentray::model::control::scaled;
use bentray::program::{Layer, ProgramOptions, Schedule};
use bentray::render::{Plane, RenderSettings, Renderer, Rendering, Status, Window};
use bentray::scene::{Rays, Scene};
use exr::prelude::{ReadChannels, ReadLayers};
use glam::DVec3;

use crate::support::{assert_rounding, gpu, scene, scenes_in, shipped_scenes};

const VARIANTS: [&[&str]; 11] = [
    &["--schedule", "fused"],
    &["--schedule", "whole"],
    &["--schedule", "whole", "--no-early-termination"],
    &["--schedule", "fused", "--segments-per-pass", "3"],
    &["--schedule", "fused", "--no-early-termination"],
    &["--schedule", "fused", "--segments-per-pass", "2", "--no-compaction"],
    &["--schedule", "segment"],
    &["--schedule", "segment", "--no-early-termination"],
    &["--schedule", "segment", "--no-compaction"],
    &["--schedule", "paper"],
    &["--schedule", "paper", "--no-early-termination"],
];

/// One variant of each schedule, and one whose passes are cut short.
const SCHEDULES: [&[&str]; 5] = [VARIANTS[0], VARIANTS[1], VARIANTS[5], VARIANTS[6], VARIANTS[9]];

const SMALL: [&str; 4] = ["--size", "60x45", "--set", "rays.max_segments=120"];

fn rendered(scene: &Path, variant: &[&str], more: &[&str], folder: &Path) -> Vec<u8> {
    let picture = folder.join("picture.exr");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.arg("render").args(["--samples", "1"]).args(more).args(variant);
    command.arg(scene).arg("-o").arg(&picture).env("BENTRAY_CACHE", "");
    let output = command.output().unwrap();
    assert!(output.status.success(), "{variant:?}: {} {}", output.status, String::from_utf8_lossy(&output.stderr));
    std::fs::read(picture).unwrap()
}

/// Compares all variants, including every mask; for most scenes the schedules suffice.
fn assert_all_the_same(scene: &Path, more: &[&str]) {
    assert_same(scene, &VARIANTS, more);
}

/// Returns the numbers of an EXR.
fn values(file: &[u8]) -> Vec<f32> {
    let image = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = image.all_attributes().from_buffered(Cursor::new(file)).unwrap();
    image.layer_data.channel_data.list.iter().flat_map(|channel| channel.sample_data.values_as_f32()).collect()
}

fn assert_same(scene: &Path, variants: &[&[&str]], more: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let first = rendered(scene, variants[0], more, folder.path());
    for variant in &variants[1..] {
        let other = rendered(scene, variant, more, folder.path());
        if first != other {
            let what = format!("{} {more:?}: {variant:?}", scene.display());
            assert_rounding(&values(&other), &values(&first), &what);
        }
    }
}

#[test]
fn shipped_scenes_do_not_depend_on_the_schedule() {
    for scene in shipped_scenes() {
        // A search for the method would take longer than the images.
        let straight = scene.to_string_lossy().contains("straight");
        let method: &[&str] = if straight { &[] } else { &["--set", "rays.method=rk4"] };
        assert_same(&scene, &SCHEDULES, &[&SMALL, method].concat());
    }
}

/// In one scene nine of ten rays end in the first passes and the others continue, each among terminated ones; in the other all continue.
#[test]
fn scattered_survivors_do_not_depend_on_the_schedule() {
    let gpu = gpu();
    for (path, survivors) in scenes_in("scenes/bench").into_iter().zip([1.0..=1.0, 0.08..=0.12]) {
        assert_all_the_same(&path, &["--size", "48x36"]);
        let scene = Scene::load(&path, &["image.size=[160, 120]".parse().unwrap()]).unwrap();
        let totals = Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap().totals;
        let share = totals.count(Status::Escaped) as f64 / totals.rays as f64;
        assert!(survivors.contains(&share), "{}: {share} of the rays continue", path.display());
        assert!(totals.segments as f64 > 100.0 * share * totals.rays as f64, "{totals}");
        assert_eq!(totals.unfollowed(), 0);
    }
}

/// Chords of several steps, for which `paper` rotates three slots; controllers with memory; ṫ as a part of the state.
#[test]
fn methods_do_not_depend_on_the_schedule() {
    let hole = shipped_scenes().into_iter().find(|path| path.ends_with("fig4e_schwarzschild.toml")).unwrap();
    let methods: [&[&str]; 4] = [
        &["--set", "rays.segment=chord", "--set", "rays.steps_per_segment=5"],
        &["--set", "rays.method=rk4-doubling", "--set", "rays.max_parameter=90"],
        &[
            "--set",
            "rays.method=euler-doubling",
            "--set",
            "rays.doubling=paper",
            "--set",
            "rays.tolerance=1e-3",
            "--set",
            "rays.segment=chord",
        ],
        &["--set", "law.form=geodesic", "--set", "rays.method=euler", "--set", "rays.step=0.5"],
    ];
    for method in methods {
        assert_same(&hole, &SCHEDULES, &[&SMALL, method].concat());
    }
}

/// Curves in closed form, forces by arc length, the Gröller iteration, custom surface laws, and shadows of both kinds.
#[test]
fn what_is_grollers_does_not_depend_on_the_schedule() {
    let scenes = scenes_in("scenes/groller");
    let of = |name: &str| scenes.iter().find(|path| path.ends_with(name)).unwrap();
    let helix = "law={ kind = \"parametric\", x = \"cos(2*t)\", y = \"t\", z = \"sin(2*t)\", t = [0, 28] }";
    let centre = "law={ kind = \"sources\", sources = [{ position = [0, 7, 2], strength = -0.8 }] }";
    let by_length = centre.replace("sources = [", "parameter = \"length\", sources = [");
    let fan = "materials.water={ kind = \"ray-splitter\", rays = [[\"dx\", \"-dy\", \"dz\", \"0.6\"], [\"dx\", \"dy\", \"dz\", \"0.4\"]] }";
    let steps = "rays.scaled_step=0.1";
    let all: [(&str, &[&str]); 6] = [
        ("towers.toml", &[centre, steps, "lights.0.shadows=curved-rays"]),
        ("towers.toml", &[centre, steps, fan]),
        ("towers.toml", &[&by_length, steps]),
        ("towers.toml", &[centre, "rays.method=groeller", "rays.step=0.5", "rays.max_segments=200"]),
        ("towers.toml", &[fan, "rays.max_splits=2"]),
        ("twelve.toml", &[helix]),
    ];
    for (name, keys) in all {
        let size = ["--size", "32x24", "--set", "rays.max_segments=150"];
        let sets: Vec<&str> = keys.iter().flat_map(|key| ["--set", key]).chain(size).collect();
        assert_same(of(name), &SCHEDULES, &sets);
    }
    // If terminated rays keep running for thousands of segments a device may stop a lane before all of its pixels are finished.
    let long = ["--size", "40x30", "--set", centre, "--set", steps];
    let folder = tempfile::tempdir().unwrap();
    let [first, other] =
        [VARIANTS[0], VARIANTS[2]].map(|variant| rendered(of("towers.toml"), variant, &long, folder.path()));
    assert!(first == other);
}

/// A black hole in front of a checkered wall, with a ball next to it: some rays fall in, some hit the wall or the ball, some escape.
const HOLE: &str = r#"
[image]
size = [32, 24]
[camera]
position = [0, 1, 14]
[law]
kind = "schwarzschild"
[rays]
bounding_sphere = { radius = 30 }
max_segments = 80
method = "rk4"
[sky]
color = [0.1, 0.2, 0.3]
[materials.checkered]
kind = "emissive"
color = { checker = [[1, 0.5, 0.2], [0.1, 0.4, 0.9]] }
[[objects]]
shape = "sphere"
center = [5, 1, -2]
radius = 2
material = "checkered"
[[objects]]
shape = "plane"
center = [0, 0, -15]
normal = [0, 0, 1]
size = [24, 18]
material = "checkered"
"#;

fn hole(folder: &Path) -> PathBuf {
    let path = folder.join("hole.toml");
    std::fs::write(&path, HOLE).unwrap();
    path
}

/// The memory of controls (an error, a rate that is evaluated again), steps by acceleration, by curvature and over chords,
/// and all of this in 64 bits, where buffers store the state. (With an even number of steps, which end in the third slot.)
#[test]
fn what_is_kept_between_passes_is_all_that_matters() {
    let folder = tempfile::tempdir().unwrap();
    let scene = hole(folder.path());
    let settings = [
        "method=dormand-prince",
        "method=dormand-prince segment=chord steps_per_segment=4",
        "method=dormand-prince segment=chord steps_per_segment=4 precision=f64 law.form=geodesic",
        "method=bogacki-shampine segment=chord steps_per_segment=2 precision=f64",
        "method=dormand-prince law.kind=straight",
        "method=leapfrog curvature_step=4 precision=f64",
        "method=rkn4 step=0.6 segment=chord steps_per_segment=3",
        "method=rk4 step=0.1 max_parameter=17.03 segment=chord steps_per_segment=3",
        "method=rk4 step=0.5 segment=chord steps_per_segment=17",
    ];
    for setting in settings {
        let keys: Vec<String> = setting
            .split(' ')
            .map(|key| if key.starts_with("law.") { key.to_owned() } else { format!("rays.{key}") })
            .collect();
        let more: Vec<&str> = keys.iter().flat_map(|key| ["--set", key.as_str()]).collect();
        assert_same(&scene, &SCHEDULES, &more);
    }
}

/// Stereo pairs, disks with nothing around them, and panoramas.
#[test]
fn cameras_do_not_depend_on_the_schedule() {
    let folder = tempfile::tempdir().unwrap();
    let scene = hole(folder.path());
    let pair = "camera.stereo={ separation = 0.5, convergence = 9 }";
    let disk = ["camera.kind=fisheye", "camera.fov=500", "camera.corners=transparent", "image.samples=3", pair];
    let around = [
        "camera.kind=panorama",
        "camera.observer=static",
        "camera.stereo={ separation = 0.5, layout = \"top-bottom\" }",
    ];
    for keys in [&disk[..], &around] {
        let more: Vec<&str> = keys.iter().flat_map(|key| ["--set", key]).collect();
        assert_all_the_same(&scene, &more);
    }
}

/// Paths of more steps than a pass has loop iterations: if `whole` cannot
/// finish them `fused` continues, tile by tile, and nothing is counted twice.
#[test]
fn what_outlives_a_pass_is_followed_on() {
    let gpu = gpu();
    let scene = scene(&HOLE.replace("max_segments = 80", "max_segments = 200000\nscaled_step = 1e-4"));
    let tiled = |schedule: Schedule| {
        let options =
            ProgramOptions { schedule, layers: vec![Layer::Status, Layer::Steps], ..ProgramOptions::default() };
        RenderSettings { options, tile_pixels: 300, ..RenderSettings::default() }
    };
    let render = |schedule: Schedule| {
        let mut renderer = Renderer::new(&gpu, &scene, tiled(schedule)).unwrap();
        assert_eq!(renderer.program().features.schedule, schedule);
        [renderer.render().unwrap(), renderer.render().unwrap()]
    };
    let [[fused, _], [whole, again]] = [Schedule::Fused, Schedule::Whole].map(render);
    assert!(fused.totals.steps > 20_000 * fused.totals.rays, "{}", fused.totals);
    assert_eq!(fused.totals.unfollowed(), 0, "{}", fused.totals);
    // Modified settings are also passed on.
    let coarse = Scene { rays: Rays { control: scaled::with(0.1), ..scene.rays.clone() }, ..scene.clone() };
    let mut renderer = Renderer::new(&gpu, &coarse, tiled(Schedule::Whole)).unwrap();
    renderer.retune(scene.rays.control, scene.rays.max_segments).unwrap();
    let retuned = renderer.render().unwrap();
    for picture in [whole, again, retuned] {
        assert!(picture.band == fused.band, "the images differ");
        let counts = |r: &Rendering| (r.totals.rays, r.totals.steps, r.totals.segments, r.totals.by_status.clone());
        assert_eq!(counts(&picture), counts(&fused));
    }
}

/// Narrow images have workgroups of a different shape: a few columns are identical to those of the whole.
#[test]
fn narrow_windows_are_columns_of_the_whole() {
    let (gpu, scene) = (gpu(), scene(HOLE));
    let [width, height] = scene.image.size;
    let of = |schedule, window| {
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        let settings = RenderSettings { options, window, ..RenderSettings::default() };
        Renderer::new(&gpu, &scene, settings).unwrap().render().unwrap().band
    };
    let whole = of(Schedule::Fused, None);
    for schedule in [Schedule::Fused, Schedule::Whole, Schedule::Paper] {
        for (left, columns) in [(0, 1), (width / 2, 3), (width - 5, 5)] {
            let window = Window { origin: [left, 0], size: [columns, height] };
            let part = of(schedule, Some(window));
            for (own, all) in part.color.iter().zip(&whole.color) {
                let row = |y: u32| all[(y * width + left) as usize..][..columns as usize].iter();
                assert!(own.iter().eq((0..height).flat_map(row)), "{schedule:?} {columns}");
            }
        }
    }
}

/// In 16 bits schedules round at different times: `paper` after every step, which for arcs is after every segment.
#[test]
fn in_16_bits_paper_and_segment_round_alike() {
    let folder = tempfile::tempdir().unwrap();
    let scene = hole(folder.path());
    let half = ["--set", "rays.precision=f16"];
    let same = |variants: &[&[&str]]| {
        let pictures = variants.iter().map(|variant| rendered(&scene, variant, &half, folder.path()));
        let pictures: Vec<Vec<u8>> = pictures.collect();
        assert!(pictures.iter().all(|picture| *picture == pictures[0]), "{variants:?} differ");
    };
    // The state between passes is rounded, so identical passes round identically.
    let of = |wanted: &dyn Fn(&&[&str]) -> bool| VARIANTS.into_iter().filter(wanted).collect::<Vec<_>>();
    let is_fused = |variant: &&[&str]| variant.contains(&"fused") || variant.contains(&"whole");
    same(&of(&|variant| is_fused(variant) && !variant.contains(&"--segments-per-pass")));
    same(&of(&|variant| !is_fused(variant)));
}

/// Returns how and where every ray ended in this precision, and the image.
fn ends(precision: &str) -> (Vec<u32>, Vec<DVec3>, Rendering) {
    let gpu = gpu();
    let scene = scene(&HOLE.replace("[rays]", &format!("[rays]\nprecision = \"{precision}\"")));
    let options = ProgramOptions { layers: vec![Layer::Status, Layer::Position], ..ProgramOptions::default() };
    let picture =
        Renderer::new(&gpu, &scene, RenderSettings { options, ..RenderSettings::default() }).unwrap().render().unwrap();
    let [(_, Plane::Id(statuses)), (_, Plane::Vector([x, y, z]))] = &picture.band.layers[..] else {
        panic!("two layers: {:?}", picture.band.layers)
    };
    let places = x.iter().zip(y).zip(z).map(|((x, y), z)| DVec3::new((*x).into(), (*y).into(), (*z).into())).collect();
    (statuses.clone(), places, picture)
}

/// The loss of 16 bits is visible: nearly all rays have the correct status, but other ends, by a few 2⁻¹¹ of the bounding
/// sphere; 32 bits lose thousands of times less.
#[test]
fn precisions_differ_by_their_bits() {
    let (truth, places, exact) = ends("f64");
    for (precision, alike, [least, most]) in [("f16", 0.9, [2e-4, 2e-1]), ("f32", 0.99, [1e-7, 1e-4])] {
        let (statuses, ends, picture) = ends(precision);
        let same = statuses.iter().zip(&truth).filter(|(a, b)| a == b).count() as f64 / truth.len() as f64;
        let mut off: Vec<f64> = (0..ends.len())
            .filter(|&i| statuses[i] == truth[i] && truth[i] != Status::Captured.code())
            .map(|i| ends[i].distance(places[i]))
            .collect();
        off.sort_by(f64::total_cmp);
        let median = off[off.len() / 2];
        println!("{precision}: {:.1} % of the rays end alike, half of them within {median:.1e}", 100.0 * same);
        assert!(same >= alike && median > least && median < most, "{precision}: {same} equal, off by {median:e}");
        assert!(precision != "f16" || picture.band.color != exact.band.color, "16 bits give the same image");
    }
}
