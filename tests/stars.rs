//! Tests stars: their flux under any motion and bending, and equal images in every schedule, tile and order of the catalog.

use std::f64::consts::PI;
use std::sync::Arc;
use std::time::Duration;

use bentray::gpu::Geometry;
use bentray::program::{Program, ProgramOptions, Schedule};
use bentray::render::{Band, Preview, RenderError, RenderSettings, Renderer, Rendering, Watch};
use bentray::scene::{Catalog, Scene, Star, Stars};
use glam::{DMat3, DVec3};

use crate::oracle::{rows, vector};
use crate::support::{gpu, scene};

/// The illuminance of a star of magnitude 0, in lux.
const UNIT: f64 = 2.54e-6;

fn star(direction: DVec3) -> Star {
    Star { direction: direction.normalize(), magnitude: 0.0, kelvins: 0.0 }
}

fn with_stars(mut scene: Scene, stars: Vec<Star>) -> Scene {
    let catalog = Arc::new(Catalog { name: String::new(), stars, may_be_hours: false });
    scene.stars[0] =
        Some(Stars { catalog, intensity: 1.0, limit: f64::INFINITY, rotation: DMat3::IDENTITY, size: 4e-6 });
    scene
}

/// Returns the directions of a spiral lattice, which covers the sphere evenly.
fn lattice(count: u32) -> Vec<Star> {
    let direction = |i: u32| {
        let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
        let (sin, cos) = (PI * (3.0 - 5_f64.sqrt()) * f64::from(i)).sin_cos();
        DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
    };
    (0..count).map(|i| star(direction(i))).collect()
}

fn rendered(scene: &Scene, schedule: Schedule, tile_pixels: u64) -> Rendering {
    let options = ProgramOptions { schedule, ..ProgramOptions::default() };
    let settings = RenderSettings { options, tile_pixels, ..RenderSettings::default() };
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap()
}

fn band(scene: &Scene) -> Band {
    rendered(scene, Schedule::Whole, u64::MAX).band
}

/// Returns the light of each pixel times its solid angle, in units of a star's flux.
fn fluxes(scene: &Scene, solid_angle: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let (band, width) = (band(scene), scene.image.size[0] as usize);
    let center = |at: usize| at as f64 + 0.5;
    let flux = |(i, light): (usize, &f32)| f64::from(*light) * solid_angle(center(i % width), center(i / width)) / UNIT;
    band.color[1].iter().enumerate().map(flux).collect()
}

/// Returns the solid angle of a pixel of a pinhole camera.
fn pinhole([width, height]: [u32; 2], fov: f64) -> impl Fn(f64, f64) -> f64 {
    let pixel = 2.0 * (0.5 * fov.to_radians()).tan() / f64::from(height);
    let [x0, y0] = [width, height].map(|side| 0.5 * f64::from(side));
    move |x, y| pixel * pixel * (1.0 + ((x - x0) * pixel).powi(2) + ((y - y0) * pixel).powi(2)).powf(-1.5)
}

/// Returns the solid angle of a pixel of a panorama.
fn panorama([width, height]: [u32; 2]) -> impl Fn(f64, f64) -> f64 {
    let [across, down] = [2.0 * PI / f64::from(width), PI / f64::from(height)];
    move |_, y| across * down * (y * down).sin()
}

const FLAT: &str = "[image]\nsize = [96, 54]\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\nfov = 40\n\
    [rays]\nbounding_sphere = { radius = 10 }\n";

/// A star that moves over the pixels has one flux, and is where its direction says.
#[test]
fn a_moving_star_does_not_twinkle() {
    let scene = scene(FLAT);
    let (size, solid_angle) = (scene.image.size, pinhole(scene.image.size, 40.0));
    let pixel = 2.0 * 20_f64.to_radians().tan() / 54.0;
    for step in 0..100 {
        let [x, y] = [40.03 + 0.0337 * f64::from(step), 20.61 + 0.0211 * f64::from(step)];
        let direction = DVec3::new((x - 48.0) * pixel, (27.0 - y) * pixel, -1.0);
        let all = fluxes(&with_stars(scene.clone(), vec![star(direction)]), &solid_angle);
        let sum: f64 = all.iter().sum();
        assert!((sum - 1.0).abs() < 1e-3, "{step}: {sum}");
        let mean = |of: &dyn Fn(usize) -> f64| all.iter().enumerate().map(|(i, flux)| flux * of(i)).sum::<f64>() / sum;
        let width = size[0] as usize;
        let center = [mean(&|i| (i % width) as f64 + 0.5), mean(&|i| (i / width) as f64 + 0.5)];
        assert!((center[0] - x).abs() < 0.01 && (center[1] - y).abs() < 0.01, "{step}: {center:?}");
    }
}

/// Near a black hole, the primary and secondary images of a star have the flux of the closed form, up to the edge of the Einstein ring.
#[test]
fn magnified_stars_have_their_flux() {
    let scene = scene(
        "[image]\nsize = [192, 108]\n[camera]\nposition = [0, 0, 20]\nlook_at = [0, 0, 0]\nfov = 120\nobserver = \"static\"\n\
         [law]\nkind = \"schwarzschild\"\n[rays]\nmethod = \"planar\"\nbounding_sphere = { radius = 100 }\nsky_at_infinity = true\n",
    );
    let solid_angle = pinhole(scene.image.size, 120.0);
    let mut worst = 0.0_f64;
    for row in rows(include_str!("tables/star_steps.tsv")) {
        let (direction, expected) = (vector(row[0]), row[1].parse::<f64>().unwrap());
        let sum: f64 = fluxes(&with_stars(scene.clone(), vec![star(direction)]), &solid_angle).iter().sum();
        worst = worst.max((sum / expected - 1.0).abs());
    }
    assert!(worst < 1e-2, "{worst}");
}

/// Every star of a panorama is found once: the sum of their fluxes is their number. A moving observer sees the flux g² of each.
#[test]
fn a_panorama_has_every_star_once() {
    let text = |more: &str, size: &str| {
        scene(&format!(
            "[image]\nsize = {size}\n[camera]\nkind = \"panorama\"\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\n{more}\n\
             [rays]\nbounding_sphere = {{ radius = 10 }}\n"
        ))
    };
    let sum = |scene: Scene, stars: Vec<Star>| {
        let solid_angle = panorama(scene.image.size);
        fluxes(&with_stars(scene, stars), solid_angle).iter().sum::<f64>()
    };
    for size in ["[256, 128]", "[301, 157]"] {
        let found = sum(text("", size), lattice(3600));
        assert!((found / 3600.0 - 1.0).abs() < 1e-4, "{size}: {found}");
    }
    let v = 0.5;
    let moving = |redshift: bool| {
        text(&format!("observer = \"boosted\"\nvelocity = [{v}, 0, 0]\nredshift = {redshift}"), "[512, 256]")
    };
    for star in lattice(7) {
        // The direction is that in which the star is at rest.
        let cosine = star.direction.x;
        let g = (1.0 + v * cosine) / (1.0_f64 - v * v).sqrt();
        for (redshift, expected) in [(false, g.powi(-2)), (true, g * g)] {
            let found = sum(moving(redshift), vec![star]);
            assert!((found / expected - 1.0).abs() < 1e-3, "{redshift} {cosine}: {found} {expected}");
        }
    }
}

const LENS: &str = "[image]\nsize = [60, 40]\n[camera]\nposition = [0, 1, 20]\nfov = 60\n[law]\nkind = \"schwarzschild\"\n\
    [rays]\nmethod = \"planar\"\nbounding_sphere = { radius = 60 }\n[sky]\nimage = \"data/stars.png\"\n\
    [materials.m]\nkind = \"emissive\"\ncolor = [0.2, 0.1, 0]\n\
    [[objects]]\nshape = \"sphere\"\nradius = 2\ncenter = [4, 0, 6]\nmaterial = \"m\"\n";

#[test]
fn schedules_tiles_and_orders_do_not_show() {
    for samples in [1, 3] {
        let mut scene = with_stars(scene(LENS), lattice(2000));
        scene.image.samples = samples;
        let expected = band(&scene);
        for (schedule, pixels) in
            [(Schedule::Whole, 500), (Schedule::Segment, u64::MAX), (Schedule::Paper, 500), (Schedule::Fused, 500)]
        {
            assert!(rendered(&scene, schedule, pixels).band == expected, "{samples} {schedule:?}");
        }
        let mut stars = lattice(2000);
        stars.reverse();
        assert!(band(&with_stars(scene, stars)) == expected, "{samples}");
    }
}

/// A grid that is followed again, for another moment or after a preview, adds no light of its own.
#[test]
fn moments_and_previews_do_not_show() {
    struct Looks;
    impl Preview for Looks {
        fn every(&self) -> Duration {
            Duration::ZERO
        }
        fn look(&self, _: &Band, _: u32) -> Result<(), RenderError> {
            Ok(())
        }
    }
    let gpu = gpu();
    for (footprints, stars) in [(false, true), (true, true), (true, false)] {
        let mut own = scene(LENS);
        own.image.samples = 5;
        own.image.footprints = footprints;
        if stars {
            own = with_stars(own, lattice(2000));
        }
        let expected = band(&own);
        let mut renderer = Renderer::new(&gpu, &own, RenderSettings::default()).unwrap();
        let mut previewed = None;
        let watch = Watch { preview: Some(&Looks), ..Watch::default() };
        let mut keep = |band| {
            previewed = Some(band);
            Ok(())
        };
        renderer.render_watched(&mut keep, &watch).unwrap();
        assert!(previewed.unwrap() == expected, "{footprints} {stars}");
        renderer.set_moments(vec![own.clone(); 2]).unwrap();
        assert!(renderer.render().unwrap().band == expected, "{footprints} {stars}");
    }
}

/// The light of stars does not depend on the number of samples, and does not need a second one.
#[test]
fn samples_do_not_change_stars() {
    let light = |samples: u32| {
        let mut scene = with_stars(scene(FLAT), lattice(20_000));
        scene.image.samples = samples;
        band(&scene).color
    };
    let one = light(1);
    for (one, many) in one.iter().flatten().zip(light(8).iter().flatten()) {
        assert!((one - many).abs() <= 1e-6 * one.abs(), "{one} {many}");
    }
}

/// An adaptive image has the stars of any other image, and each of its pixels takes as many samples as without stars.
#[test]
fn adaptive_images_show_stars() {
    let mut plain = scene(LENS);
    plain.objects.clear();
    plain.image.adaptive = Some(0.02);
    plain.image.samples = 64;
    let stars = with_stars(plain.clone(), lattice(2000));
    let (sky, found) = (rendered(&plain, Schedule::Whole, u64::MAX), rendered(&stars, Schedule::Whole, u64::MAX));
    assert_eq!(sky.totals.adaptive.unwrap().capped, found.totals.adaptive.unwrap().capped);
    let mut dark = with_stars(scene(LENS), lattice(2000));
    dark.sky = bentray::scene::Sky::Color(DVec3::ZERO);
    dark.objects.clear();
    let dark = band(&dark);
    let all = found.band.color.iter().flatten().zip(sky.band.color.iter().flatten()).zip(dark.color.iter().flatten());
    for ((found, sky), star) in all {
        assert!((found - sky - star).abs() <= 1e-6 * found, "{found} {sky} {star}");
    }
    assert!(dark.color[0].iter().filter(|star| **star > 0.0).count() > 1000);
    for (schedule, pixels) in [(Schedule::Whole, 500), (Schedule::Segment, u64::MAX), (Schedule::Fused, 500)] {
        assert!(rendered(&stars, schedule, pixels).band == found.band, "{schedule:?}");
    }
    // The grid of stars also measures the footprints of a picture between them.
    let mut filtered = stars.clone();
    filtered.image.footprints = true;
    let again = rendered(&filtered, Schedule::Whole, u64::MAX);
    assert_eq!(again.totals.stars, found.totals.stars);
    assert!(rendered(&filtered, Schedule::Fused, 500).band == again.band);
    filtered.stars = [None, None];
    let sky = rendered(&filtered, Schedule::Whole, u64::MAX);
    let all = again.band.color.iter().flatten().zip(sky.band.color.iter().flatten()).zip(dark.color.iter().flatten());
    for ((found, sky), star) in all {
        assert!((found - sky - star).abs() <= 1e-6 * found, "{found} {sky} {star}");
    }
}

/// Through glass, a star has an image for each path, and a mirror shows it again.
#[test]
fn branches_show_stars() {
    let sky = scene(
        "[image]\nsize = [96, 54]\n[camera]\nposition = [0, 0, 8]\nlook_at = [0, 0, 0]\nfov = 40\n[rays]\nbounding_sphere = { radius = 20 }\n\
         [[objects]]\nshape = \"box\"\nmin = [-9, -9, -1]\nmax = [9, 9, 1]\ninterior = 1.5\n",
    );
    let solid_angle = pinhole(sky.image.size, 40.0);
    // Straight through a plate, without the light that is reflected twice or more often: (1 − k)² with k = 0.04.
    let found: f64 =
        fluxes(&with_stars(sky.clone(), vec![star(DVec3::new(0.02, 0.01, -1.0))]), &solid_angle).iter().sum();
    assert!((found / 0.923 - 1.0).abs() < 5e-3, "{found}");
    // The first surface reflects 4 % of the light of a star behind the camera, and the second 0.04 · 0.96².
    let found: f64 = fluxes(&with_stars(sky, vec![star(DVec3::new(0.02, 0.01, 1.0))]), &solid_angle).iter().sum();
    assert!((found / (0.04 + 0.04 * 0.96 * 0.96) - 1.0).abs() < 1e-2, "{found}");
}

/// Dense catalogs show the mean light of their stars in wide pixels.
#[test]
fn dense_stars_are_even_light() {
    let scene = scene(
        "[image]\nsize = [24, 12]\n[camera]\nkind = \"panorama\"\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\n\
         [rays]\nbounding_sphere = { radius = 10 }\n",
    );
    let solid_angle = panorama(scene.image.size);
    let rendering = rendered(&with_stars(scene.clone(), lattice(200_000)), Schedule::Whole, u64::MAX);
    assert!(rendering.totals.stars.unwrap().averaged > 0);
    let sum: f64 = fluxes(&with_stars(scene, lattice(200_000)), solid_angle).iter().sum();
    assert!((sum / 200_000.0 - 1.0).abs() < 2e-2, "{sum}");
}

/// Stars are refused if rays cannot show where they are, or how bright.
#[test]
fn impossible_stars_are_mistakes() {
    for (text, problem) in [
        (
            "rays.lighting = \"path-tracing\"\n[materials.m]\nkind = \"phong\"\n[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n",
            "random paths never meet a point",
        ),
        ("rays.precision = \"f16\"\nrays.method = \"rk4\"\n", "more than 16 bits"),
        ("law.kind = \"lorenz\"\n", "a law of light"),
        ("[camera]\nkind = \"orthographic\"\nheight = 1\nposition = [0, 0, 1]\n", "stay parallel"),
        ("[radiation]\nfrequencies = [1]\n[[volumes]]\nshape = \"sphere\"\nemission = 1\n", "[radiation]"),
    ] {
        let text = format!("rays.bounding_sphere = {{ radius = 10 }}\nsky.stars = \"data/stars.csv\"\n{text}");
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/test.toml");
        let error = Scene::parse(&text, &path, &[]).unwrap_err().to_string();
        assert!(error.contains("test.toml:2:13: `stars`") && error.contains(problem), "{error}");
    }
}

#[test]
fn nothing_is_modelled_without_stars() {
    let program = |scene: &Scene| {
        let geometry = Geometry::new(scene);
        Program::new(scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent()).unwrap()
    };
    let plain = scene(FLAT);
    let has = |scene: &Scene| program(scene).passes.iter().any(|(_, linked, _)| linked.source.contains("grid_rays"));
    assert!(!has(&plain));
    assert!(has(&with_stars(plain, lattice(3))));
}
