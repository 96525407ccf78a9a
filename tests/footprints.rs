//! Tests the texture filtering of pixels: colors are means over the footprint,
//! also for bent light, and identical in every schedule and tile.

use std::sync::Arc;

use bentray::program::{Program, ProgramOptions, Schedule};
use bentray::render::{Band, RenderSettings, Renderer};
use bentray::scene::{Picture, Scene};

use crate::support::{gpu, scene};

fn of(scene: &Scene, schedule: Schedule, tile_pixels: u64) -> Band {
    let options = ProgramOptions { schedule, ..ProgramOptions::default() };
    let settings = RenderSettings { options, tile_pixels, ..RenderSettings::default() };
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap().band
}

fn shown(scene: &Scene) -> Band {
    of(scene, Schedule::Fused, u64::MAX)
}

/// Returns a scene with a wall of 4 by 4 that fills the image, seen by parallel rays.
fn wall(size: u32, color: &str) -> Scene {
    scene(&format!(
        "[image]\nsize = [{size}, {size}]\nfootprints = true\n[camera]\nkind = \"orthographic\"\nheight = 4\nposition = [0, 0, 9]\n[rays]\n\
         bounding_sphere = {{ radius = 20 }}\n[materials.m]\nkind = \"emissive\"\ncolor = {color}\n[[objects]]\nshape = \"plane\"\n\
         normal = [0, 0, 1]\nsize = [4, 4]\nmaterial = \"m\"\n"
    ))
}

/// Returns a pseudorandom number from 0 to 1.
fn noise(i: u32) -> f32 {
    let state = i.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 8) as f32 / 16_777_216.0
}

fn picture(size: [u32; 2]) -> Picture {
    let pixels = (0..size[0] * size[1]).map(|i| [noise(3 * i), noise(3 * i + 1), noise(3 * i + 2)]).collect();
    Picture { size, pixels: Arc::new(pixels), name: "noise".to_owned(), notes: Vec::new() }
}

const IMAGE: &str = "{ image = \"data/stars.png\", repeat = [1, 1] }";

/// A pixel that covers 2, 4 or 8 texels in each direction is their mean.
#[test]
fn a_pixel_is_the_mean_of_its_texels() {
    let with = |size: u32, footprints: bool| {
        let mut scene = wall(size, IMAGE);
        scene.pictures[0] = picture([64, 64]);
        scene.image.footprints = footprints;
        shown(&scene)
    };
    let texels = with(64, false);
    for cells in [2, 4, 8_u32] {
        let band = with(64 / cells, true);
        for (channel, all) in band.color.iter().zip(&texels.color) {
            for (i, seen) in (0..).zip(channel) {
                let (x, y) = (i % (64 / cells) * cells, i / (64 / cells) * cells);
                let sum: f32 = (0..cells * cells).map(|k| all[((y + k / cells) * 64 + x + k % cells) as usize]).sum();
                // Texels are stored in 16 bits, and rounded again for each reduced copy.
                assert!((seen - sum / (cells * cells) as f32).abs() < 2e-3, "{cells}, pixel {i}");
            }
        }
    }
}

/// An image whose texels are larger than pixels is bit-identical with and without filtering.
#[test]
fn what_is_magnified_stays_as_it_is() {
    for text in [IMAGE, "[0.2, 0.4, 0.6]"] {
        let mut filtered = wall(48, text);
        if let Some(first) = filtered.pictures.first_mut() {
            *first = picture([40, 30]);
        }
        let mut plain = filtered.clone();
        plain.image.footprints = false;
        assert!(shown(&filtered) == shown(&plain), "{text}");
    }
}

/// Returns the mean of a checker pattern over a box, in 64 bits and by counting.
#[test]
fn checkers_are_means_over_the_pixel() {
    const FINE: u32 = 400;
    for repeat in [5.3, 23.7, 71.9_f64] {
        let size = 24;
        let band =
            shown(&wall(size, &format!("{{ checker = [[1, 1, 1], [0, 0, 0]], repeat = [{repeat}, {repeat}] }}")));
        let worst = (0..size * size).map(|i| {
            let at = |k: u32, pixel: u32| (f64::from(pixel) + (f64::from(k) + 0.5) / f64::from(FINE)) / f64::from(size);
            let sign = |x: f64| 1.0 - 2.0 * ((x * repeat).floor().rem_euclid(2.0));
            let mean = |pixel: u32| (0..FINE).map(|k| sign(at(k, pixel))).sum::<f64>() / f64::from(FINE);
            // v increases upwards.
            let expected = 0.5 + 0.5 * mean(i % size) * mean(size - 1 - i / size);
            (f64::from(band.color[0][i as usize]) - expected).abs()
        });
        // Two edges can be between the counted points, and u has an error of about 1e-6 of 72.
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 2.0 / f64::from(FINE), "{repeat}: {worst}");
    }
}

const LENS: &str = "[image]\nsize = [60, 40]\n[camera]\nposition = [0, 1, 20]\nfov = 60\n[law]\nkind = \"schwarzschild\"\n\
    [rays]\nmethod = \"planar\"\nbounding_sphere = { radius = 60 }\n[sky]\nimage = \"data/stars.png\"\n\
    [materials.m]\nkind = \"emissive\"\ncolor = { checker = [[1, 0.7, 0.3], [0.1, 0, 0.2]], repeat = [90, 90] }\n\
    [[objects]]\nshape = \"plane\"\nsize = [60, 60]\ncenter = [0, -4, 0]\nmaterial = \"m\"\n";

fn lens(samples: u32, footprints: bool) -> Scene {
    let mut scene = scene(LENS);
    scene.pictures[0] = picture([512, 256]);
    (scene.image.samples, scene.image.footprints) = (samples, footprints);
    scene
}

fn distance(a: &Band, b: &Band) -> f64 {
    let squares = a.color.iter().flatten().zip(b.color.iter().flatten()).map(|(a, b)| f64::from(a - b).powi(2));
    (squares.sum::<f64>() / (3 * a.color[0].len()) as f64).sqrt()
}

/// Behind a black hole, on a floor and in the sky, one filtered sample is much closer to the mean of many samples.
#[test]
fn one_sample_is_nearer_to_many() {
    let many = shown(&lens(400, false));
    let [plain, filtered] = [false, true].map(|footprints| distance(&shown(&lens(1, footprints)), &many));
    assert!(filtered < 0.5 * plain, "{filtered} {plain}");
    // With more samples each has a smaller footprint, and both results converge.
    let [plain, filtered] = [false, true].map(|footprints| distance(&shown(&lens(16, footprints)), &many));
    assert!(filtered < plain, "{filtered} {plain}");
}

/// In an adaptive image the corners of pixels, which decide about more samples, are filtered too.
#[test]
fn adaptive_images_are_filtered() {
    let many = shown(&lens(400, false));
    let [plain, filtered] = [false, true].map(|footprints| {
        let mut scene = lens(64, footprints);
        scene.image.adaptive = Some(0.02);
        let found = Renderer::new(&gpu(), &scene, RenderSettings::default()).unwrap().render().unwrap();
        assert!(of(&scene, Schedule::Fused, 800) == found.band);
        (distance(&found.band, &many), found.totals.adaptive.unwrap().mean())
    });
    assert!(filtered.0 < 0.6 * plain.0 && filtered.1 < plain.1, "{filtered:?} {plain:?}");
}

#[test]
fn schedules_and_tiles_do_not_show() {
    let mut sky = lens(1, true);
    sky.objects.clear();
    for scene in [lens(1, true), lens(5, true), sky, through_glass(true)] {
        let expected = shown(&scene);
        for (schedule, pixels) in
            [(Schedule::Whole, u64::MAX), (Schedule::Segment, u64::MAX), (Schedule::Paper, 300), (Schedule::Fused, 300)]
        {
            assert!(of(&scene, schedule, pixels) == expected, "{schedule:?}");
        }
    }
}

/// Returns a glass ball in front of a sky whose texels are larger than pixels, so that filtering does not change them.
fn through_glass(footprints: bool) -> Scene {
    let mut scene = scene(
        "[image]\nsize = [40, 30]\n[camera]\nposition = [0, 0, 9]\nfov = 20\n[rays]\nbounding_sphere = { radius = 20 }\n\
         [sky]\nimage = \"data/stars.png\"\n[[objects]]\nshape = \"sphere\"\ninterior = 1.5\n",
    );
    scene.pictures[0] = picture([8, 4]);
    scene.image.footprints = footprints;
    scene
}

/// The sky is seen along all branches of a path once, though it is filtered after each of them.
#[test]
fn branches_are_seen_once() {
    let [plain, filtered] = [false, true].map(|footprints| shown(&through_glass(footprints)));
    for (a, b) in plain.color.iter().flatten().zip(filtered.color.iter().flatten()) {
        // At its edge, the ball compresses the sky to less than a pixel per texel.
        assert!((a - b).abs() < 0.35, "{a} {b}");
    }
    let off = distance(&plain, &filtered);
    assert!(off < 0.02, "{off}");
}

/// Without textures to average, the program is identical to that without filtering.
#[test]
fn nothing_is_modelled_for_plain_colors() {
    let program = |text: &str, footprints: bool| {
        let mut scene = wall(8, text);
        scene.image.footprints = footprints;
        let geometry = bentray::gpu::Geometry::new(&scene);
        Program::new(&scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent()).unwrap()
    };
    assert!(program("[1, 1, 1]", true).runs_as(&program("[1, 1, 1]", false)));
    assert!(!program(IMAGE, true).runs_as(&program(IMAGE, false)));
}
