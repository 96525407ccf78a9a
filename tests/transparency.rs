//! Tests a transparent sky: alpha is one minus the visible fraction of the sky, for every kind of image.

#![allow(clippy::float_cmp)] // each sample of a ball is covered or not

use bentray::output::{film, lost_alpha};
use bentray::program::{ProgramOptions, Schedule};
use bentray::progress::Progress;
use bentray::render::{RenderSettings, Renderer, Rendering};
use bentray::scene::{Scene, Sky};

use crate::support::{gpu, scene};

fn rendered(scene: &Scene, schedule: Schedule) -> Rendering {
    let options = ProgramOptions { schedule, masks: schedule.masks(), ..ProgramOptions::default() };
    let settings = RenderSettings { options, ..RenderSettings::default() };
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap()
}

fn alpha(scene: &Scene) -> Vec<f32> {
    rendered(scene, Schedule::Whole).band.alpha.expect("alpha")
}

/// Returns a scene of an object on the z axis, seen by parallel rays in 4 by 4 units, with additional keys of [rays].
fn before(size: u32, rays: &str, object: &str) -> Scene {
    scene(&format!(
        "sky = \"transparent\"\n[image]\nsize = [{size}, {size}]\n[camera]\nkind = \"orthographic\"\nheight = 4\nposition = [0, 0, 5]\n\
         [rays]\nbounding_sphere = {{ radius = 9 }}\n{rays}\n[materials.shine]\nkind = \"emissive\"\ncolor = [0.5, 1, 2]\n\
         [materials.mirror]\nkind = \"mirror\"\ncolor = [0.25, 0.5, 0.75]\n[materials.matte]\ndiffuse = [0.8, 0.8, 0.8]\n\
         [[objects]]\n{object}\n"
    ))
}

const BALL: &str = "shape = \"sphere\"\nmaterial = \"shine\"";
/// White light leaves it as [1/4, 1/16, 1], so that 7/16 of the sky is visible.
const SLAB: &str = "shape = \"box\"\nmin = [-4, -4, -1]\nmax = [4, 4, 1]\ninterior = { kind = \"constant\", n = 1, absorption = [0.5, 0.25, 1] }";
const PATHS: &str = "lighting = \"path-tracing\"";

/// A disk of radius 1 covers a fraction of each pixel that its samples determine, and multiplies its color by that.
#[test]
fn a_ball_covers_its_disk() {
    for (rays, adaptive) in [("", None), (PATHS, None), ("", Some(0.02))] {
        let mut scene = before(16, rays, BALL);
        (scene.image.samples, scene.image.adaptive) = (64, adaptive);
        let picture = rendered(&scene, Schedule::Whole);
        let alpha = picture.band.alpha.as_ref().expect("alpha");
        // 16 pixels correspond to 4 units.
        for (i, covered) in alpha.iter().enumerate() {
            let [x, y] = [i % 16, i / 16].map(|k| 0.25 * (k as f64 + 0.5) - 2.0);
            let (near, far) = (x.hypot(y) < 1.0 - 0.18, x.hypot(y) > 1.0 + 0.18);
            assert!(!near || *covered == 1.0, "{x} {y}: {covered}");
            assert!(!far || *covered == 0.0, "{x} {y}: {covered}");
            for (channel, light) in picture.band.color.iter().zip([0.5, 1.0, 2.0]) {
                assert!((channel[i] - light * covered).abs() <= 1e-5, "{x} {y}: {} of {covered}", channel[i]);
            }
        }
        // The edge cuts about 50 pixels, whose samples are each wrong by at most half:
        // with stratified samples the error of the sum is less than one pixel in 201.
        let area: f64 = alpha.iter().map(|x| f64::from(*x)).sum::<f64>() / 16.0;
        assert!((area - std::f64::consts::PI).abs() < 0.06, "{rays} {adaptive:?}: {area}");
    }
}

/// Light through an absorbing medium, or from a mirror, would show the sky; matter and black holes hide it.
#[test]
fn alpha_is_what_would_not_be_seen_of_the_sky() {
    let mirror = "shape = \"plane\"\ncenter = [0, 0, -1]\nnormal = [0, 0, 1]\nmaterial = \"mirror\"";
    let matte = mirror.replace("mirror", "matte");
    for (object, rays, seen) in [
        (SLAB, "", 7.0 / 16.0),
        (SLAB, PATHS, 7.0 / 16.0),
        (mirror, "", 0.5),
        (mirror, PATHS, 0.5),
        (&matte, "", 0.0),
        (&matte, PATHS, 0.0),
    ] {
        for adaptive in [None, Some(0.05)] {
            let mut scene = before(4, rays, object);
            (scene.image.samples, scene.image.adaptive) = (16, adaptive);
            for covered in alpha(&scene) {
                assert!((f64::from(covered) - (1.0 - seen)).abs() < 1e-5, "{object} {rays} {adaptive:?}: {covered}");
            }
        }
    }
    // Emissive media are followed like paths: their light needs no sky behind it.
    let glowing = SLAB.replace(
        "absorption = [0.5, 0.25, 1]",
        "absorption = { transmittance = [0.5, 0.25, 1], emission = [1, 0, 0] }",
    );
    let picture = rendered(&before(4, "", &glowing), Schedule::Whole);
    assert!(picture.band.alpha.expect("alpha").iter().all(|x| (x - 9.0 / 16.0).abs() < 1e-5));
    assert!(picture.band.color[0].iter().all(|x| *x > 0.5));
}

/// Glass shows the light that it transmits and reflects: on the axis, all of it.
#[test]
fn clear_glass_covers_nothing() {
    let clear = SLAB.replace("n = 1, absorption = [0.5, 0.25, 1]", "n = 1.5");
    let scene = before(4, "max_splits = 6", &clear);
    // After six splits 0.04⁵ of the light is still between the faces.
    for covered in alpha(&scene) {
        assert!((0.0..1e-4).contains(&covered), "{covered}");
    }
}

/// Rays that fall into a black hole are covered, equally in every schedule.
#[test]
fn holes_are_covered_in_every_schedule() {
    let hole = scene(
        "sky = \"transparent\"\n[image]\nsize = [24, 24]\nsamples = 2\n[camera]\nposition = [0, 0, 20]\nfov = 60\n\
         [law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 30 }\n",
    );
    assert_eq!(hole.sky, Sky::Transparent);
    let whole = rendered(&hole, Schedule::Whole).band;
    let alpha = whole.alpha.as_ref().expect("alpha");
    assert_eq!([alpha[0], alpha[12 * 24 + 12]], [0.0, 1.0]);
    assert!(whole.color.iter().flatten().all(|x| *x == 0.0));
    for schedule in [Schedule::Fused, Schedule::Segment, Schedule::Paper] {
        assert!(rendered(&hole, schedule).band.alpha == whole.alpha, "{schedule:?}");
    }
}

/// A video without alpha shows pixels in front of black: half-covered white is half of the light, sRGB 188.
#[test]
fn films_without_alpha_are_before_black() {
    let folder = tempfile::tempdir().unwrap();
    let [frame, gif, png] = ["a.png", "b.gif", "b.png"].map(|name| folder.path().join(name));
    let pixels = [[255, 255, 255, 128], [255, 0, 0, 0], [9, 99, 199, 255]];
    image::RgbaImage::from_fn(3, 1, |x, _| image::Rgba(pixels[x as usize])).save(&frame).unwrap();
    let frames = [frame];
    assert!(lost_alpha(&gif, &frames).is_some_and(|words| words.contains("blended with black")));
    assert_eq!(lost_alpha(&png, &frames), None);
    film(&gif, &frames, 24.0, &Progress::default()).unwrap();
    let shown = image::open(&gif).unwrap().into_rgba8();
    assert_eq!([0, 2].map(|x| shown.get_pixel(x, 0).0), [[188, 188, 188, 255], [9, 99, 199, 255]]);
    assert_eq!(shown.get_pixel(1, 0)[3], 0);
}
