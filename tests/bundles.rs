//! Tests the layers of bundles of light: magnifications of a black hole, and the shapes of bundles in flat space.

use bentray::program::{Layer, ProgramOptions, Schedule};
use bentray::render::{Plane, RenderSettings, Renderer};
use bentray::scene::Scene;
use glam::{DVec2, DVec3};

use crate::oracle::{rows, vector};
use crate::support::{gpu, scene};

fn layers(scene: &Scene, schedule: Schedule, tile_pixels: u64) -> (Vec<f32>, [Vec<f32>; 3]) {
    let options = ProgramOptions { schedule, layers: vec![Layer::Magnification, Layer::Bundle], ..Default::default() };
    let settings = RenderSettings { options, tile_pixels, ..RenderSettings::default() };
    let band = Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap().band;
    let [(_, Plane::Scalar(magnification)), (_, Plane::Vector(shape))] = &band.layers[..] else {
        panic!("other layers: {:?}", band.layers)
    };
    (magnification.clone(), shape.clone())
}

/// Differences over five pixels of 0.002 rad have an error of 1e-6. In 32 bits the steps of a ray add a few 1e-4, and directions are rounded
/// by 1e-7: a part of 1e-4 |μ| of the small differences of a bright image.
#[test]
fn magnifications_in_images_are_those_of_a_black_hole() {
    let mut checked = 0;
    for row in rows(include_str!("tables/magnifications.tsv")) {
        let (eye, ahead, expected) = (vector(row[1]), vector(row[2]), row[3].parse::<f64>().unwrap());
        // A fainter image changes too much within a pixel.
        if expected.abs() < 0.05 {
            continue;
        }
        let [aim, up] = [(eye + ahead), ahead.any_orthonormal_vector()].map(|v| format!("{:?}", v.to_array()));
        let rounded = 1e-3 + 1e-4 * expected.abs();
        for (precision, tolerance, allowed) in [("f32", "1e-6", rounded), ("f64", "1e-12", 3e-6)] {
            let scene = scene(&format!(
                "[image]\nsize = [3, 3]\n[camera]\nposition = {:?}\nlook_at = {aim}\nup = {up}\nfov = {}\nobserver = \"static\"\n\
                 [law]\nkind = \"schwarzschild\"\nmass = 1\n[rays]\nsky_at_infinity = true\nbounding_sphere = {{ radius = 1200 }}\n\
                 method = \"dormand-prince\"\ntolerance = {tolerance}\nmax_segments = 20000\nprecision = \"{precision}\"\n",
                eye.to_array(),
                2.0 * 0.003_f64.atan().to_degrees(),
            ));
            let found = f64::from(layers(&scene, Schedule::Whole, u64::MAX).0[4]);
            assert!((found / expected - 1.0).abs() < allowed, "{} in {precision}: {found} {expected}", row[0]);
            checked += 1;
        }
    }
    assert!(checked > 12, "{checked}");
}

/// In flat space the magnification is 1, and a bundle is as wide as the pixel, also at the edge of the image and in any tile.
#[test]
fn bundles_in_flat_space_are_pixels() {
    let text = "[image]\nsize = [24, 16]\nsamples = S\n[camera]\nposition = [0, 0, 0]\nlook_at = [3, 1, -2]\nfov = 60\n\
                [rays]\nbounding_sphere = { radius = 10 }\n";
    let pixel = 2.0 * 30_f64.to_radians().tan() / 16.0;
    let forward = DVec3::new(3.0, 1.0, -2.0).normalize();
    let right = forward.cross(DVec3::Y).normalize();
    let up = right.cross(forward);
    let of = |samples: &str, schedule, pixels| layers(&scene(&text.replace('S', samples)), schedule, pixels);
    let (magnification, [major, minor, angle]) = of("1", Schedule::Whole, u64::MAX);
    for (i, found) in magnification.iter().enumerate() {
        assert!((found - 1.0).abs() < 1e-4, "{i}: {found}");
        let plane = DVec2::new((i % 24) as f64 + 0.5 - 12.0, 8.0 - (i / 24) as f64 - 0.5) * pixel;
        // The differences are over two pixels.
        let (far, closeness) = (plane.length_squared() + 1.0, 4.0 * pixel * pixel);
        let expected = [pixel / far.sqrt(), pixel / far];
        for (found, expected) in [major[i], minor[i]].into_iter().zip(expected) {
            assert!((f64::from(found) / expected - 1.0).abs() < closeness, "{i}: {found} {expected}");
        }
        if plane.length() > 0.3 {
            // A pixel far from the center is wider across the line to the center.
            let d = (forward + plane.x * right + plane.y * up).normalize();
            let long = (plane.x * up - plane.y * right).normalize();
            let east = DVec3::Y.cross(d).normalize();
            let expected = long.dot(east).atan2(long.dot(d.cross(east)));
            let off = (f64::from(angle[i]) - expected).sin().abs();
            assert!((0.0..3.15).contains(&angle[i]) && off < 0.05, "{i}: {} {expected}", angle[i]);
        }
    }
    let expected = of("3", Schedule::Whole, u64::MAX);
    for (schedule, pixels) in [(Schedule::Paper, 60), (Schedule::Fused, u64::MAX)] {
        assert!(of("1", schedule, pixels) == (magnification.clone(), [major.clone(), minor.clone(), angle.clone()]));
        assert!(of("3", schedule, pixels) == expected);
    }
}
