//! Adaptive sampling: more samples where the image needs them, identical results in every schedule and tile, and every limit is reported.

use bentray::program::{Layer, ProgramOptions, RaySkipping, Schedule};
use bentray::render::{Adaptive, Plane, RenderSettings, Renderer, Rendering, Window};
use bentray::scene::Scene;

use crate::support::{assert_same_image, gpu, scene};

/// A glass ball and a silver one in front of a checkered wall, in a circular image with nothing outside.
const GLASS: &str = r#"
[image]
size = [20, 15]
samples = 32
adaptive = 0.05
[camera]
kind = "fisheye"
fov = 60
corners = "transparent"
position = [0, 0, 9]
[law]
kind = "straight"
[rays]
bounding_sphere = { radius = 20 }
max_segments = 8
max_splits = 2
[sky]
color = [0.1, 0.2, 0.3]
[materials.silver]
kind = "mirror"
[materials.checkered]
kind = "emissive"
color = { checker = [[1, 0.5, 0.2], [0.1, 0.4, 0.9]] }
[[objects]]
shape = "sphere"
center = [-1.5, 0, 0]
interior = 1.5
[[objects]]
shape = "sphere"
center = [1.5, 0.5, 0]
material = "silver"
[[objects]]
shape = "plane"
center = [0, 0, -5]
normal = [0, 0, 1]
size = [7, 5]
material = "checkered"
"#;

/// A white ball of radius 5 seen by parallel rays, one unit of length per pixel.
const BALL: &str = r#"
[image]
size = [32, 24]
adaptive = 0.02
[camera]
kind = "orthographic"
height = 24
position = [0, 0, 15]
[law]
kind = "straight"
[rays]
bounding_sphere = { radius = 40 }
[materials.white]
kind = "emissive"
color = [1, 1, 1]
[[objects]]
shape = "sphere"
radius = 5.3
center = [0.4, 0.2, 0]
material = "white"
"#;

fn rendered(scene: &Scene, settings: RenderSettings) -> Rendering {
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap()
}

fn with_layers(layers: &[Layer]) -> RenderSettings {
    RenderSettings {
        options: ProgramOptions { layers: layers.to_vec(), ..ProgramOptions::default() },
        ..RenderSettings::default()
    }
}

/// Returns the number of rays of each pixel, and the totals.
fn counts(picture: &Rendering) -> (&[u32], Adaptive) {
    let Some(Plane::Id(samples)) = picture.band.layer(Layer::Samples) else { panic!("no sample layer") };
    (samples, picture.totals.adaptive.expect("an adaptive image"))
}

/// Schedules with and without masks, and a fused pass for every two segments, give bit-identical results.
#[test]
fn adaptive_pictures_do_not_depend_on_the_schedule() {
    let scene = scene(GLASS);
    let one = |schedule, masks, segments| {
        let options = ProgramOptions { schedule, masks, layers: Layer::ALL.to_vec(), ..ProgramOptions::default() };
        rendered(&scene, RenderSettings { options, segments, ..RenderSettings::default() })
    };
    let first = one(Schedule::Fused, RaySkipping::List, 16);
    let (samples, adaptive) = counts(&first);
    assert!(samples.contains(&1) && samples.contains(&17) && samples.contains(&33), "{samples:?}");
    assert!(adaptive.mean() > 2.0 && adaptive.mean() < 25.0, "{adaptive}");
    for (schedule, masks, segments) in [
        (Schedule::Whole, RaySkipping::List, 16),
        (Schedule::Whole, RaySkipping::Off, 16),
        (Schedule::Fused, RaySkipping::List, 2),
        (Schedule::Fused, RaySkipping::Off, 16),
        (Schedule::Segment, RaySkipping::List, 1),
        (Schedule::Fused, RaySkipping::Grid, 4),
        (Schedule::Segment, RaySkipping::Off, 1),
        (Schedule::Paper, RaySkipping::Grid, 1),
        (Schedule::Paper, RaySkipping::Off, 1),
    ] {
        let other = one(schedule, masks, segments);
        assert_same_image(&other, &first, &format_args!("{schedule:?}, {masks:?}, K = {segments}"));
        assert_eq!((&first.totals.by_status, adaptive), (&other.totals.by_status, counts(&other).1), "{schedule:?}");
    }
}

/// Alpha is 1 inside the disk and 0 outside, with intermediate values only on its rim, where there are more samples.
#[test]
fn a_rim_has_more_samples() {
    let picture = rendered(&scene(GLASS), with_layers(&[Layer::Samples]));
    let (samples, _) = counts(&picture);
    let alpha = picture.band.alpha.as_ref().unwrap();
    assert!(alpha.contains(&1.0) && alpha.contains(&0.0));
    let rim: Vec<_> = alpha.iter().zip(samples).filter(|(a, _)| **a > 0.0 && **a < 1.0).collect();
    assert!(rim.len() > 10 && rim.iter().all(|(_, n)| **n > 1), "{rim:?}");
}

/// Tiles and crops give the same result as the whole image, including layers.
#[test]
fn adaptive_tiles_do_not_show() {
    let scene = scene(GLASS);
    let whole = rendered(&scene, with_layers(&Layer::ALL));
    for tile_pixels in [64, 150] {
        let tiled = rendered(&scene, RenderSettings { tile_pixels, ..with_layers(&Layer::ALL) });
        assert!(whole.band == tiled.band, "tiles of {tile_pixels} pixels");
        assert_eq!(counts(&whole).1.capped, counts(&tiled).1.capped);
    }
    let window = Window { origin: [7, 4], size: [9, 6] };
    let crop = rendered(&scene, RenderSettings { window: Some(window), ..with_layers(&[Layer::Samples]) });
    for (i, red) in crop.band.color[0].iter().enumerate() {
        let at = (window.origin[1] as usize + i / 9) * 20 + window.origin[0] as usize + i % 9;
        assert_eq!((*red, counts(&crop).0[i]), (whole.band.color[0][at], counts(&whole).0[at]), "pixel {i}");
    }
}

/// Every ray is counted: the samples of the layer, and the corners at the right and bottom edges of the image.
#[test]
fn the_layer_is_what_the_totals_say() {
    let picture = rendered(&scene(BALL), with_layers(&[Layer::Samples]));
    let (samples, adaptive) = counts(&picture);
    let edges = 33 * 25 - 32 * 24;
    assert_eq!(samples.iter().map(|n| u64::from(*n)).sum::<u64>() + edges, adaptive.samples);
    assert_eq!((adaptive.samples, adaptive.pixels), (picture.totals.rays, 32 * 24));
    let uniform = scene(&BALL.replace("adaptive = 0.02", "samples = 3"));
    let picture = rendered(&uniform, with_layers(&[Layer::Samples]));
    assert_eq!(picture.band.layer(Layer::Samples), Some(&Plane::Id(vec![3; 32 * 24])));
    assert_eq!(picture.totals.adaptive, None);
}

/// An empty image takes one ray per pixel.
#[test]
fn a_flat_picture_takes_the_corners_alone() {
    let text =
        BALL.replace("[[objects]]\nshape = \"sphere\"\nradius = 5.3\ncenter = [0.4, 0.2, 0]\nmaterial = \"white\"", "");
    let picture = rendered(
        &scene(&text.replace("[materials", "[sky]\ncolor = [0.2, 0.4, 0.6]\n[materials")),
        with_layers(&[Layer::Samples]),
    );
    let (samples, adaptive) = counts(&picture);
    assert!(samples.iter().all(|n| *n == 1));
    assert_eq!((adaptive.samples, adaptive.capped), (33 * 25, 0));
    assert!(
        picture.band.color.iter().zip([0.2, 0.4, 0.6]).all(|(plane, c)| plane.iter().all(|v| (v - c).abs() < 1e-6))
    );
    assert!(
        picture.totals.to_string().contains("1.07 samples per pixel, all pixels within 0.02"),
        "{}",
        picture.totals
    );
}

/// Only pixels with corners on both sides of the ball's outline take more
/// samples, and the image is as good as one with 16 samples everywhere.
#[test]
fn an_edge_is_refined_and_nothing_else() {
    let adaptive = scene(BALL);
    let picture = rendered(&adaptive, with_layers(&[Layer::Samples]));
    let (samples, sums) = counts(&picture);
    for (i, n) in samples.iter().enumerate() {
        let corners = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| {
            let (x, y) = ((i % 32 + x) as f64 - 16.0, 12.0 - (i / 32 + y) as f64);
            (x - 0.4).hypot(y - 0.2) < 5.3
        });
        let parted = corners.contains(&true) && corners.contains(&false);
        assert_eq!(*n > 1, parted, "pixel {i} took {n}");
    }
    let uniform = |samples: u32| {
        rendered(&scene(&BALL.replace("adaptive = 0.02", &format!("samples = {samples}"))), RenderSettings::default())
    };
    let truth = uniform(1024);
    let off = |picture: &Rendering| -> f64 {
        let pairs = picture.band.color[0].iter().zip(&truth.band.color[0]);
        pairs.map(|(a, b)| f64::from(a - b).powi(2)).sum::<f64>().sqrt()
    };
    let (own, sixteen) = (off(&picture), off(&uniform(16)));
    println!("adaptive off by {own}, 16 samples by {sixteen}; {sums}");
    assert!(own < sixteen && sums.mean() < 6.0, "{own} of {sixteen}, {sums}");
}

/// A pixel that cannot reach the tolerance stops at the maximum number of samples, and this is reported.
#[test]
fn the_cap_is_reported() {
    // Squares far smaller than a pixel: every sample is black or white.
    let noise =
        BALL.replace("color = [1, 1, 1]", "color = { checker = [[1, 1, 1], [0, 0, 0]], repeat = [20011, 20011] }");
    let noise =
        noise.replace("shape = \"sphere\"\nradius = 5.3", "shape = \"plane\"\nsize = [60, 60]\nnormal = [0, 0, 1]");
    let picture = rendered(
        &scene(&noise.replace("adaptive = 0.02", "adaptive = 0.02\nsamples = 16")),
        with_layers(&[Layer::Samples]),
    );
    let (samples, adaptive) = counts(&picture);
    let most = samples.iter().filter(|n| **n == 17).count() as u64;
    println!("{adaptive}");
    assert!(most > 32 * 24 / 2 && adaptive.capped > most / 2 && adaptive.capped <= most, "{most} took all; {adaptive}");
    let words = format!("{} pixels", adaptive.capped);
    assert!(
        picture.totals.to_string().contains(&words) && picture.totals.to_string().contains("not within 0.02 after 16")
    );
}
