//! Tests `bentray render`: the files decode to the requested image, identically in every run, and stderr has a summary.

use exr::prelude::{FlatSamples, MetaData, read_first_flat_layer_from_file};
use image::{ColorType, DynamicImage, ImageReader, Rgb32FImage};

use super::{BALL, Folder};

/// A black hole with the ball next to it: rays that hit, escape and are captured.
const HOLE: &str =
    "--set law.kind=schwarzschild --set rays.method=rk4 --set law.mass=0.2 --set objects.0.center=[1.5,0,0]";

pub(super) fn decoded(folder: &Folder, name: &str) -> DynamicImage {
    let reader = ImageReader::open(folder.path(name)).unwrap();
    reader.decode().unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The transfer function of IEC 61966-2-1, to 0..=1.
fn srgb(linear: f64) -> f64 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// Returns the largest difference between a PNG's samples and the EXR's after the transfer function, in units of the PNG's last bit.
fn difference(png: &DynamicImage, exr: &Rgb32FImage, top: f64) -> f64 {
    let (png, scale) = (png.to_rgb16(), top / 65_535.0);
    let pairs = png.as_raw().iter().zip(exr.as_raw());
    pairs.map(|(png, exr)| (f64::from(*png) * scale - srgb(f64::from(*exr)) * top).abs()).fold(0.0, f64::max)
}

#[test]
fn pictures_decode_to_the_scene_in_8_16_and_32_bits() {
    let folder = Folder::with(BALL);
    let ran = folder.run("render scene.toml -o a.png -o a.exr --size 17x9").succeeds();
    assert_eq!(ran.out, "");
    ran.says(&["device: "]);
    let (png, exr) = (decoded(&folder, "a.png"), decoded(&folder, "a.exr"));
    assert_eq!(png.color(), ColorType::Rgb8);
    assert_eq!((png.width(), png.height()), (17, 9));
    assert_eq!((exr.width(), exr.height()), (17, 9));
    let linear = exr.into_rgb32f();
    assert_eq!(linear.get_pixel(8, 4).0, [1.0, 0.0, 0.0]);
    assert_eq!(linear.get_pixel(0, 0).0, [0.2, 0.3, 0.4]);
    assert_eq!(png.to_rgb8().get_pixel(8, 4).0, [255, 0, 0]);
    // Rounding alone is half a unit; the rest is the error of the transfer function in f32.
    assert!(difference(&png, &linear, 255.0) <= 0.51);

    folder.run("render scene.toml -o a.png --set output.bit_depth=16").succeeds();
    folder.run("render scene.toml -o a.exr").succeeds();
    let (png, linear) = (decoded(&folder, "a.png"), decoded(&folder, "a.exr").into_rgb32f());
    assert_eq!(png.color(), ColorType::Rgb16);
    assert_eq!((png.width(), png.height()), (16, 12));
    assert!(difference(&png, &linear, 65_535.0) <= 1.0);
    assert_eq!(folder.names(), ["a.exr", "a.png", "scene.toml"]);
}

#[test]
fn exposure_brightens_the_png_and_leaves_the_exr() {
    let folder = Folder::with(BALL);
    folder.run("render scene.toml -o a.exr").succeeds();
    let before = decoded(&folder, "a.exr").into_rgb32f();
    folder.run("render scene.toml -o a.png -o a.exr --set output.exposure=1").succeeds();
    let mut twice = decoded(&folder, "a.exr").into_rgb32f();
    assert_eq!(twice, before);
    twice.iter_mut().for_each(|sample| *sample *= 2.0);
    assert!(difference(&decoded(&folder, "a.png"), &twice, 255.0) <= 0.51);
}

/// The printed command reproduces a render, also if defaults would now differ: it names the method that was found, and
/// renders in one step an image that was rendered in several.
#[test]
fn a_render_says_what_repeats_it() {
    let again = |folder: &Folder, ran: &super::Ran| {
        let line = ran.err.lines().find_map(|line| line.strip_prefix("reproduce with: bentray ")).unwrap().to_owned();
        let files = ["a.png", "a.exr"].map(|name| folder.read(name));
        std::fs::remove_file(folder.path("a.exr")).unwrap();
        folder.run(&line.replace('\'', "")).succeeds();
        assert!(["a.png", "a.exr"].map(|name| folder.read(name)) == files, "{line}");
        line
    };
    let folder = Folder::with(BALL);
    let ran = folder.run("render scene.toml -o a.png -o a.exr --set law.kind=schwarzschild --size 20x10").succeeds();
    assert!(again(&folder, &ran).ends_with("--size 20x10 --method-from a.png"));
    let paths = "--set rays.lighting=path-tracing --samples";
    folder.run(&format!("render scene.toml -o b.exr {paths} 2")).succeeds();
    let ran = folder.run(&format!("render scene.toml -o a.png -o a.exr {paths} 5 --continue b.exr")).succeeds();
    assert!(again(&folder, &ran).ends_with("--samples 5 --method-from a.png"));
}

#[test]
fn the_bytes_are_the_same_every_time_and_on_every_schedule() {
    let folder = Folder::with(BALL);
    let render = |name: &str, more: &str| {
        let ran =
            folder.run(&format!("render scene.toml -o {name}.png -o {name}.exr --samples 2 {HOLE} {more}")).succeeds();
        let totals = ran.err.lines().last().unwrap().to_owned();
        let (_, fates) = totals.split_once(';').unwrap();
        let bytes = [folder.read(&format!("{name}.png")), folder.read(&format!("{name}.exr"))];
        (fates.to_owned(), bytes)
    };
    let first = render("a", "");
    for status in ["hit", "escaped", "captured"] {
        assert!(first.0.contains(status), "{}", first.0);
    }
    let others = [
        "",
        "--no-early-termination",
        "--segments-per-pass 1",
        "--segments-per-pass 3 --no-early-termination",
        "--schedule segment",
        "--schedule segment --no-early-termination",
        "--schedule paper",
        "--schedule paper --no-early-termination",
    ];
    for more in others {
        assert!(first == render("b", more), "{more}");
    }
}

fn channels(folder: &Folder, name: &str) -> Vec<String> {
    let meta = MetaData::read_from_file(folder.path(name), true).unwrap();
    let list = &meta.headers[0].channels.list;
    list.iter().map(|channel| channel.name.to_string()).collect()
}

#[test]
fn exr_layers_are_those_that_were_named() {
    let folder = Folder::with(BALL);
    let cases: [(&str, &str); 4] = [
        ("", "B G R Z id.object id.status normal.X normal.Y normal.Z position.X position.Y position.Z segments steps"),
        ("--layers none", "B G R"),
        ("--layers depth,normal", "B G R Z normal.X normal.Y normal.Z"),
        ("--layers status --layers object", "B G R id.object id.status"),
    ];
    let mut colors = Vec::new();
    for (layers, names) in cases {
        folder.run(&format!("render scene.toml -o a.png -o a.exr --size 8x6 {layers}")).succeeds();
        let names: Vec<&str> = names.split(' ').collect();
        assert_eq!(channels(&folder, "a.exr"), names, "{layers}");
        colors.push((folder.read("a.png"), decoded(&folder, "a.exr").into_rgb32f()));
    }
    assert!(colors.windows(2).all(|pair| pair[0] == pair[1]), "the color depends on the layers");
}

/// Transparent corners have alpha 0, the disk has 1, and its rim the fraction of its area inside; no other image has alpha.
#[test]
fn only_transparent_corners_have_alpha() {
    let folder = Folder::with(BALL);
    let render = |more: &str| {
        let fisheye = "--set camera.kind=fisheye --size 40x32 --samples 4 --layers none --strict";
        folder.run(&format!("render scene.toml -o a.png -o a.exr {fisheye} {more}")).succeeds()
    };
    let ran = render("");
    assert!(ran.err.lines().last().unwrap().contains(" outside "), "{}", ran.err);
    assert!(!ran.err.contains("warning"), "{}", ran.err);
    assert_eq!(
        (decoded(&folder, "a.png").color(), channels(&folder, "a.exr")),
        (ColorType::Rgb8, vec!["B".to_owned(), "G".to_owned(), "R".to_owned()])
    );
    let black = (decoded(&folder, "a.png").into_rgb8(), decoded(&folder, "a.exr").into_rgb32f());
    for bits in [8, 16] {
        render(&format!("--set camera.corners=transparent --set output.bit_depth={bits}"));
        let (png, exr) = (decoded(&folder, "a.png"), decoded(&folder, "a.exr"));
        assert_eq!(png.color(), if bits == 8 { ColorType::Rgba8 } else { ColorType::Rgba16 });
        assert_eq!(channels(&folder, "a.exr"), ["A", "B", "G", "R"]);
        let (png, exr) = (png.into_rgba8(), exr.into_rgba32f());
        let mut partly = 0;
        for (x, y, pixel) in exr.enumerate_pixels() {
            let rho = f64::hypot(f64::from(x) - 19.5, f64::from(y) - 15.5);
            let alpha = pixel.0[3];
            assert!(!(15.2..=16.8).contains(&rho) || [0.0, 0.25, 0.5, 0.75, 1.0].contains(&alpha), "{x} {y}: {alpha}");
            assert!(!(rho > 16.8 && alpha != 0.0 || rho < 15.2 && alpha != 1.0), "{x} {y}: {alpha}");
            assert_eq!(f64::from(png.get_pixel(x, y).0[3]), (f64::from(alpha) * 255.0).round(), "{x} {y}");
            // EXR stores color multiplied by alpha, which equals the color with black corners.
            assert_eq!(pixel.0[..3], black.1.get_pixel(x, y).0, "{x} {y}");
            if alpha == 1.0 && bits == 8 {
                assert_eq!(png.get_pixel(x, y).0[..3], black.0.get_pixel(x, y).0, "{x} {y}");
            }
            if alpha > 0.0 && alpha < 1.0 {
                partly += 1;
                // On the rim a PNG shows the color of the sky unchanged.
                let sky = [0.2, 0.3, 0.4].map(|c| (srgb(c) * 255.0).round() as u8);
                assert_eq!(png.get_pixel(x, y).0[..3], sky, "{x} {y}");
            }
        }
        assert!(partly > 20, "{partly} pixels on the rim");
    }
}

#[test]
fn exr_layers_hold_what_their_names_say() {
    let folder = Folder::with(BALL);
    let ran = folder.run("render scene.toml -o a.exr").succeeds();
    let totals = ran.err.lines().last().unwrap().to_owned();
    let image = read_first_flat_layer_from_file(folder.path("a.exr")).unwrap();
    assert_eq!(image.layer_data.size, exr::math::Vec2(16, 12));
    let samples = |name: &str| -> Vec<f64> {
        let list = &image.layer_data.channel_data.list;
        let channel = list.iter().find(|c| c.name.to_string() == name).unwrap();
        match &channel.sample_data {
            FlatSamples::F32(values) => values.iter().map(|v| f64::from(*v)).collect(),
            FlatSamples::U32(values) => values.iter().map(|v| f64::from(*v)).collect(),
            FlatSamples::F16(_) => panic!("{name} is in 16 bits"),
        }
    };
    let [object, status, steps, segments, depth] = ["id.object", "id.status", "steps", "segments", "Z"].map(samples);
    let position = ["position.X", "position.Y", "position.Z"].map(samples);
    let normal = ["normal.X", "normal.Y", "normal.Z"].map(samples);
    let length = |vector: &[Vec<f64>; 3], i: usize| vector.iter().map(|v| v[i] * v[i]).sum::<f64>().sqrt();
    let hits = object.iter().filter(|id| **id == 0.0).count();
    assert!(hits > 0 && totals.contains(&format!("; hit {hits} escaped {}", 192 - hits)), "{totals}");
    let middle = 6 * 16 + 8;
    for i in 0..object.len() {
        let hit = object[i] == 0.0;
        assert!(hit || object[i] == -1.0);
        // The ball has radius 1, the bounding sphere 10.
        let (radius, normals) = if hit { (1.0, 1.0) } else { (10.0, 0.0) };
        assert!((length(&position, i) - radius).abs() < 1e-5, "{i}");
        assert!((length(&normal, i) - normals).abs() < 1e-5, "{i}");
        assert_eq!(hit, status[i] == status[middle], "{i}");
        assert_eq!(steps[i], 1.0, "{i}");
        assert!(segments[i] > 0.0 && segments[i] <= 1.0, "{i}");
        // Rays are straight, so that the depth is the distance from the camera.
        let far = (0..3).map(|k| (position[k][i] - [0.0, 0.0, 5.0][k]).powi(2)).sum::<f64>().sqrt();
        let expected = if hit { far } else { 1e10 };
        assert!((depth[i] / expected - 1.0).abs() < 1e-6, "{i}: {} instead of {expected}", depth[i]);
    }
}

#[test]
fn the_last_line_sums_up_and_says_which_rays_were_lost() {
    let folder = Folder::with(BALL);
    let ran = folder.run("render scene.toml -o a.png --samples 3 --strict").succeeds();
    let totals = ran.err.lines().last().unwrap();
    assert!(totals.starts_with("576 rays, 576 steps, 576 segments, "), "{totals}");
    assert!(totals.contains(" s in total; "), "{totals}");
    let (_, fates) = totals.split_once("; ").unwrap();
    let words: Vec<&str> = fates.split(' ').collect();
    assert_eq!([words[0], words[2]], ["hit", "escaped"]);
    let counts = [words[1], words[3]].map(|n| n.parse::<u32>().unwrap());
    assert_eq!((counts[0] + counts[1], words.len()), (576, 4), "{totals}");
    assert!(!ran.err.contains("warning"), "{}", ran.err);

    let short = "render scene.toml -o a.png --set rays.method=rk4 --set rays.max_segments=1";
    let warning = "warning: 192 rays (100.00 %) reached rays.max_segments (black in the image, `exhausted` in the \
                   status layer): raise it, or take longer steps";
    let lenient = folder.run(short).succeeds();
    assert!(lenient.err.contains("; exhausted 192\n"), "{}", lenient.err);
    lenient.says(&[warning]);
    let black = folder.read("a.png");
    assert!(decoded(&folder, "a.png").into_rgb8().iter().all(|sample| *sample == 0));
    // The image is written in any case.
    folder.write("a.png", "an old picture");
    let strict = folder.run(&format!("{short} --strict"));
    assert_eq!((strict.code, strict.out.as_str()), (Some(1), ""));
    strict.says(&[warning]);
    assert!(folder.read("a.png") == black);
}
