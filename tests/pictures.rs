//! Whole pictures: what they cost on the device, tiles, sampling, and a few references.

use std::path::Path;
use std::process::Command;

use bentray::gpu::{Geometry, memory};
use bentray::program::{Choice, Layer, Program, Schedule};
use bentray::render::{Picture, Renderer, Settings, Status};
use bentray::scene::Scene;

use crate::support::{gpu, scene, shipped_scenes};

const HOLE: &str = "[image]\nsize = [96, 64]\n[camera]\nposition = [0, 2, 15]\n[law]\nkind = \"schwarzschild\"\n\
    [rays]\nbound = { radius = 30 }\n[sky]\nimage = \"data/stars.png\"\n\
    [materials.m]\ndiffuse = { checker = [[1, 0.2, 0.1], [0.9, 0.9, 0.9]] }\n\
    [[objects]]\nshape = \"sphere\"\ncenter = [5, 0, -3]\nradius = 2\nmaterial = \"m\"\n\
    [[lights]]\nkind = \"point\"\nposition = [10, 10, 20]\n";

/// At most 100 bytes a pixel, whatever the number of segments; layers and other schedules cost what `memory` says.
#[test]
fn state_on_the_device_is_small() {
    for path in shipped_scenes() {
        let mut scene = Scene::load(&path, &[]).unwrap();
        let geometry = Geometry::new(&scene);
        let bytes = |scene: &Scene, choice: &Choice| {
            let program = Program::new(scene, choice, geometry.nodes.len(), geometry.triangles.len()).unwrap();
            memory(&program, choice.slots(scene)).bytes_per_pixel()
        };
        let plain = bytes(&scene, &Choice::default());
        assert!(plain <= 100, "{}: {plain} bytes a pixel", path.display());
        let layered = bytes(&scene, &Choice { layers: Layer::ALL.to_vec(), ..Choice::default() });
        // Depth, object, status and steps at 4 bytes, two vectors at 16; the steps and rejections that are counted for them.
        assert_eq!(layered - plain, 4 * 4 + 2 * 16 + 2 * 4, "{}", path.display());
        scene.rays.max_segments = 100_000;
        assert_eq!(bytes(&scene, &Choice::default()), plain);
        let paper = bytes(&scene, &Choice { schedule: Schedule::Paper, ..Choice::default() });
        assert!(paper <= 100, "{}: {paper} bytes a pixel", path.display());
    }
}

fn rendered(scene: &Scene, settings: Settings) -> Picture {
    let gpu = gpu();
    Renderer::new(&gpu, scene, settings).unwrap().picture().unwrap()
}

/// Tiles of any size give the same picture, samples and layers with it.
#[test]
fn tiles_do_not_show() {
    let mut scene = scene(HOLE);
    scene.image.samples = 3;
    let choice = Choice { layers: Layer::ALL.to_vec(), ..Choice::default() };
    let whole = rendered(&scene, Settings { choice: choice.clone(), ..Settings::default() });
    for tile_pixels in [64, 1000] {
        let tiled = rendered(&scene, Settings { choice: choice.clone(), tile_pixels, ..Settings::default() });
        assert!(whole.band == tiled.band, "tiles of {tile_pixels} pixels");
        assert_eq!(whole.totals.fates, tiled.totals.fates);
        assert_eq!(whole.totals.steps, tiled.totals.steps);
    }
}

/// Every ray is counted once, by how it ended.
#[test]
fn every_ray_is_counted() {
    let mut scene = scene(HOLE);
    scene.image.samples = 2;
    let picture = rendered(&scene, Settings::default());
    assert_eq!(picture.totals.rays, 2 * 96 * 64);
    for status in [Status::Hit, Status::Escaped, Status::Captured] {
        assert!(picture.totals.count(status) > 100, "{}", picture.totals);
    }
    assert_eq!(picture.totals.unfollowed(), 0);
}

/// Multi-jittered samples converge: sixteen come nearer to sixty-four than four do.
#[test]
fn samples_converge() {
    let mut scene = scene(HOLE);
    let mut with = |samples: u32| {
        scene.image.samples = samples;
        rendered(&scene, Settings::default()).band.color.concat()
    };
    let (few, more, many) = (with(4), with(16), with(64));
    let error = |a: &[f32]| -> f64 { a.iter().zip(&many).map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>().sqrt() };
    assert!(error(&more) < 0.7 * error(&few), "{} against {}", error(&more), error(&few));
}

/// The shadow of a hole seen from r = 20 by an observer at rest has the radius of the closed form,
/// sin θ = 3√3 M √(1 − 2M/r)/r, to a pixel.
#[test]
fn the_shadow_has_its_size() {
    for (frame, sin2) in [
        ("static", 27.0 * (1.0 - 2.0 / 20.0) / 400.0),
        // Coordinate directions: sin² θ = 27M²/(r² + 54M³/r).
        ("coordinate", 27.0 / (400.0 + 54.0 / 20.0)),
    ] {
        // Vertical, for 3 rows; the picture is then as wide as it is far.
        let fov = (2.0 * (1.5_f64 / 401.0).atan()).to_degrees();
        let text = format!(
            "[image]\nsize = [401, 3]\n[camera]\nposition = [0, 0, 20]\nfov = {fov}\nframe = \"{frame}\"\n\
             [law]\nkind = \"schwarzschild\"\n[rays]\nbound = {{ radius = 50 }}\n[sky]\ncolor = [1, 1, 1]\n"
        );
        let scene = scene(&text);
        let picture = rendered(&scene, Settings::default());
        let row = &picture.band.color[0][401..802];
        let dark = row.iter().filter(|v| **v == 0.0).count() as f64;
        let angle: f64 = f64::asin(f64::sqrt(sin2));
        let expected = 2.0 * angle.tan() * 401.0;
        assert!((dark - expected).abs() <= 2.0, "{frame}: {dark} dark pixels, {expected} expected");
    }
}

/// The picture that the README opens with is the one that `make render` makes: compared small, in what the eye sees (sRGB
/// values, whose steps look about alike), with room for the samples' noise.
#[test]
fn the_readme_shows_what_is_rendered() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let reference = image::open(root.join("scenes/pictures/black_hole.png")).unwrap().to_rgb8();
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("picture.png");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bentray"));
    command.args(["render", "--size", "480x270", "--samples", "4", "--device", "llvmpipe"]);
    command.arg(root.join("scenes/black_hole.toml")).arg("-o").arg(&picture).env("NODEVICE_SELECT", "1");
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let rendered = image::open(picture).unwrap().to_rgb8();
    let small = |picture: &image::RgbImage| image::imageops::thumbnail(picture, 96, 54);
    let (a, b) = (small(&reference), small(&rendered));
    let off = a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b))).collect::<Vec<_>>();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    let far = off.iter().filter(|d| **d > 40.0).count();
    assert!(
        mean < 4.0 && far < off.len() / 100,
        "off by {mean} of 255 on average, by more than 40 in {far} of {}",
        off.len()
    );
}
