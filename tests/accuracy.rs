//! Tests the promises on accuracy: tables at infinity, measured errors that are correct, methods that are chosen well, and no
//! error that passes unnoticed.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use bentray::chart::{Outcome, StabilityCase, default_settings};
use bentray::measure::{ErrorStats, ReferenceSolution, all_methods, calibrate, calibrate_for, verify};
use bentray::model::control::embedded;
use bentray::output::csv::read_rays;
use bentray::program::Mode;
use bentray::render::{RenderSettings, Renderer, Starts, Status, Traced, Tracer, trace};
use bentray::scene::{Override, Scene};
use glam::DVec3;

use crate::shaders::Random;
use crate::support::{gpu, scene};

fn at_infinity(law: &str, method: &str) -> Scene {
    let (kind, rest) = law.split_once(";[[").map_or((law, String::new()), |(kind, rest)| (kind, format!("[[{rest}")));
    let lines = |text: &str| text.replace(';', "\n");
    let rays = format!(
        "[rays]\nmax_segments = 20000\nbounding_sphere = {{ radius = 50 }}\nsky_at_infinity = true\n{method}\n"
    );
    scene(&format!("[law]\n{}\n{}\n{rays}", lines(kind), lines(&rest)))
}

/// Returns the angle between the direction +x, in which a ray was sent, and its end, towards the center below it.
fn turned(ray: &Traced) -> f64 {
    -ray.v[1].atan2(ray.v[0])
}

/// Returns the difference of two angles, without whole turns.
fn off(a: f64, b: f64) -> f64 {
    ((a - b + PI).rem_euclid(TAU) - PI).abs()
}

#[test]
fn deflections_at_infinity() {
    let gpu = gpu();
    let rows = include_str!("tables/infinity.tsv").lines().filter(|line| !line.starts_with('#'));
    let rows: Vec<Vec<&str>> = rows.map(|line| line.split('\t').collect()).collect();
    let number = |text: &str| text.parse::<f64>().unwrap();
    for (method, floor, factor) in [
        ("method = \"planar\"\nscaled_step = 0.1", 2e-5, 40.0),
        ("method = \"dormand-prince\"\ntolerance = 1e-6", 2e-5, 40.0),
        ("method = \"dormand-prince\"\ntolerance = 1e-12\nprecision = \"f64\"", 1e-9, 1e-6 / 6e-8),
    ] {
        for rows in rows.chunk_by(|a, b| a[1] == b[1]) {
            let method =
                if rows[0][1].contains("kerr") { method.replace("planar", "separated") } else { method.into() };
            let scene = at_infinity(rows[0][1], &method);
            let rays: Vec<_> = rows.iter().map(|r| [-900.0, number(r[2]), 0.0, number(r[3]), 0.0, 0.0]).collect();
            let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
            for (row, end) in rows.iter().zip(ends) {
                assert_eq!(end.status, Status::Escaped, "{}", row[0]);
                let error = off(turned(&end), number(row[4]));
                let bound = (factor * number(row[5])).max(floor);
                assert!(error <= bound, "{} by {method}: off by {error:e}, bound {bound:e}", row[0]);
            }
        }
    }
}

/// Scattering by an inverse-square center has a closed form, 2 atan(M / (b
/// v²)). The verification of a coarse method measures exactly this error.
#[test]
fn measured_errors_are_the_true_ones() {
    let gpu = gpu();
    let law = "kind=\"sources\";[[law.sources]];position=[0,0,0];strength=1";
    let scene = at_infinity(law, "method = \"rk4\"\nscaled_step = 0.2");
    let impacts: Vec<f64> = (0..200).map(|i| f64::from(0.5_f32 + 0.1 * i as f32)).collect();
    let rays: Vec<_> = impacts.iter().map(|b| [-900.0, *b, 0.0, 1.0, 0.0, 0.0]).collect();
    let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
    let truth = ReferenceSolution::new(&gpu, &scene, 1e-13, Starts::Given(&rays)).unwrap();
    assert_eq!(truth.unresolved(), 0);
    let measured = ErrorStats::new(&ends, &[], &truth).angle;
    let mut exact: Vec<f64> =
        ends.iter().zip(&impacts).map(|(end, b)| off(turned(end), 2.0 * (1.0 / b).atan())).collect();
    exact.sort_by(f64::total_cmp);
    for (name, measured, exact) in [("median", measured.median, exact[99]), ("max", measured.max, exact[199])] {
        println!("{name}: measured {measured:e}, exact {exact:e}");
        assert!(measured < 1.1 * exact && exact < 1.1 * measured, "{name}: {measured:e} for {exact:e}");
    }
}

/// The same ten thousand steps in 32 bits and in 64. Rounding of positions, which are near 10, is about 6e-7 per step and of either sign,
/// so that it accumulates to 6e-5. Rounding of step sizes in τ always has one sign, and would move every end back by 2e-3 along its path.
#[test]
fn a_long_flow_ends_when_it_should() {
    let gpu = gpu();
    let ends = |precision: &str| {
        let text = format!(
            "[law]\nkind = \"rossler\"\n[rays]\nbounding_sphere = {{ radius = 500 }}\nmax_parameter = 20\nmax_segments = 20000\n\
             method = \"rk4\"\nstep = 0.002\nprecision = \"{precision}\"\n"
        );
        let starts = [[1.0, 1.0, 0.0], [2.0, -3.0, 0.0], [-4.0, 2.0, 0.1]].map(|[x, y, z]| [x, y, z, 1.0, 0.0, 0.0]);
        trace(&gpu, &scene(&text), &RenderSettings::default(), &starts).unwrap().0
    };
    for (single, double) in ends("f32").iter().zip(&ends("f64")) {
        assert_eq!((single.status, double.status), (Status::Ended, Status::Ended));
        let apart = DVec3::from(single.x).distance(DVec3::from(double.x));
        println!("{apart:e} apart after {} steps", single.steps);
        assert!(single.steps >= 10_000 && apart < 3e-4, "{apart:e} apart after {} steps", single.steps);
    }
}

const HOLE: &str = "[image]\nsize = [96, 72]\n[camera]\nposition = [0, 2, 20]\n[law]\nkind = \"schwarzschild\"\n[rays]\n\
                    bounding_sphere = { radius = 100 }\n";

#[test]
fn a_calibrated_scene_is_as_accurate_as_was_asked() {
    let gpu = gpu();
    let asked = scene(&format!("{HOLE}accuracy = \"0.05px\"\n"));
    let calibration =
        calibrate(&gpu, &asked, &RenderSettings::default(), None).unwrap().expect("the scene names no method");
    println!("{calibration}");
    assert!(calibration.reached());
    // The result does not depend on time.
    assert_eq!(calibrate(&gpu, &asked, &RenderSettings::default(), None).unwrap(), Some(calibration.clone()));
    let chosen = calibration.applied(&asked);
    let found = verify(&gpu, &chosen, &RenderSettings::default(), 500).unwrap().found;
    let accuracy = asked.accuracy().unwrap();
    assert!(found.seen.p99 <= accuracy, "{:e} where {accuracy:e} was requested", found.seen.p99);
    // A scene that specifies its method is not changed.
    let named = scene(&format!("{HOLE}method = \"rk4\"\n"));
    assert!(calibrate(&gpu, &named, &RenderSettings::default(), None).unwrap().is_none());
}

/// If a picture shows only intensities, their errors choose the method, however narrow its pixels are.
#[test]
fn a_picture_of_intensities_is_as_accurate_as_was_asked() {
    let gpu = gpu();
    let text = "[image]\nsize = [64, 48]\n[camera]\nposition = [0, -400, 200]\nup = [0, 0, 1]\nfov = 5\nobserver = \"static\"\n\
                [law]\nkind = \"kerr-newman\"\nspin = 0.8\n[rays]\nbounding_sphere = { radius = 500 }\n[radiation]\n\
                frequencies = [0.5, 1.0]\n[[volumes]]\nshape = \"sphere\"\nradius = 30\nflow = \"prograde-orbit\"\n\
                density = \"exp(-((r - 9)/3)^2 - (z/2)^2)\"\nemission = \"n/nu\"\nabsorption = \"0.1*n*nu^-2.5\"\n";
    let asked = scene(text);
    let found = calibrate_for(&gpu, &asked, &RenderSettings::default(), 5000).unwrap().unwrap();
    assert!(found.reached() && (found.accuracy / 1e-3 - 1.0).abs() < 1e-9, "{found}");
    assert!(found.to_string().contains("of their light"), "{found}");
    let verified = verify(&gpu, &found.applied(&asked), &RenderSettings::default(), 500).unwrap();
    let light = verified.found.light.unwrap();
    assert!(light.p99 < 2e-3 && light.median > 0.0, "{found}\n{verified}");
    // An angle is still an angle.
    let found = calibrate_for(
        &gpu,
        &scene(&text.replace("[radiation]", "accuracy = 1e-4\n[radiation]")),
        &RenderSettings::default(),
        5000,
    );
    assert!(found.unwrap().unwrap().to_string().contains(" rad, "));
}

/// A choice without a search is also correct, for laws that bend rays little or
/// much and with objects in their way; and an expensive image is worth the search.
#[test]
fn a_small_picture_is_as_accurate_as_was_asked() {
    let gpu = gpu();
    let ball = "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\n\
                center = [4, 0, -3]\nradius = 2\n";
    let eye = "[image]\nsize = [80, 60]\n[camera]\nposition = [0, 2, 20]\n";
    let fields = "[law]\nkind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 0.2 }, \
                  { position = [5, 1, 0], strength = -0.1, falloff = { yukawa = 0.3 } }]\n[rays]\nbounding_sphere = { radius = 60 }\n";
    for text in [HOLE.to_owned(), format!("{HOLE}{ball}"), format!("{eye}{fields}"), format!("{eye}{fields}{ball}")] {
        let asked = scene(&text);
        let found =
            calibrate_for(&gpu, &asked, &RenderSettings::default(), 5000).unwrap().expect("the scene names no method");
        println!("{found}");
        assert!(!found.compared && found.reached(), "{text}");
        assert!(found.to_string().contains("not all methods were tried"));
        let verified = verify(&gpu, &found.applied(&asked), &RenderSettings::default(), 2000).unwrap().found;
        let accuracy = asked.accuracy().unwrap();
        assert!(verified.seen.p99 <= accuracy, "{text}: {:e} where {accuracy:e} was requested", verified.seen.p99);
    }
    // A line element, a flow and a medium of the shipped scenes, with steps under a tolerance.
    for name in ["spacetimes/hayward", "fig4b_lorenz", "fig4d_index"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("scenes/{name}.toml"));
        let small: Vec<Override> = vec!["image.size=[96, 72]".parse().unwrap()];
        let asked = Scene::load(&path, &small).unwrap();
        let found = calibrate_for(&gpu, &asked, &RenderSettings::default(), 7000).unwrap().unwrap();
        println!("{name}: {found}");
        let verified = verify(&gpu, &found.applied(&asked), &RenderSettings::default(), 1000).unwrap().found;
        // Twice the reported error, which is measured on other rays and only in 32 bits.
        let said = found.chosen.error.max(found.accuracy);
        assert!(!found.compared && verified.seen.p99 <= 2.0 * said, "{name}: {:e}, not {said:e}", verified.seen.p99);
    }
    let searched = calibrate_for(&gpu, &scene(HOLE), &RenderSettings::default(), 1 << 40).unwrap().unwrap();
    assert!(searched.compared && searched.reached(), "{searched}");
}

/// A chaotic flow reaches no accuracy, and the result reports that.
#[test]
fn a_calibration_says_what_cannot_be_had() {
    let gpu = gpu();
    let flow = scene(
        "[image]\nsize = [32, 24]\n[camera]\nkind = \"orthographic\"\nposition = [0, -12, 25]\nlook_at = [0, 0, 25]\n\
         up = [0, 0, 1]\nheight = 20\n[law]\nkind = \"lorenz\"\n[rays]\nbounding_sphere = { radius = 500 }\nmax_parameter = 18\n\
         max_segments = 20000\naccuracy = 1e-5\n",
    );
    let calibration = calibrate(&gpu, &flow, &RenderSettings::default(), None).unwrap().unwrap();
    println!("{calibration}");
    assert!(!calibration.reached() && calibration.to_string().contains("no method reaches"));
    // On orbits that never end nothing can be measured, whatever errors the methods appear to have.
    let bound = scene(
        "[law]\nkind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 100 }]\n[rays]\nbounding_sphere = { radius = 100 }\n\
         max_segments = 200\n",
    );
    let rays = [[0.0, 3.0, 50.0, 0.0, 0.0, -1.0], [2.0, -5.0, 50.0, 0.0, 0.0, -1.0]];
    let calibration = calibrate(&gpu, &bound, &RenderSettings::default(), Some(&rays)).unwrap().unwrap();
    println!("{calibration}");
    assert!(!calibration.reached() && calibration.rays.endless == rays.len());
    assert!(calibration.to_string().contains("no method can be measured"));
}

/// Rays with b < √27 M that move inward fall in, and all others escape: for any position and direction.
#[test]
#[allow(clippy::many_single_char_names)] // the letters of the formulas
fn every_fate_is_right() {
    let gpu = gpu();
    let mut random = Random::new(81);
    let critical = 27.0_f64.sqrt();
    let (mut rays, mut fates) = (Vec::new(), Vec::new());
    while rays.len() < 20_000 {
        let x = random.direction() * random.log(5.0, 1000.0);
        let aimed = -x.normalize() + random.direction() * random.log(1e-3, 1.0);
        let v = if random.unit() < 0.7 { aimed.normalize() } else { random.direction() };
        let (r, l) = (x.length(), x.cross(v).length());
        let inwards = x.dot(v) < 0.0;
        let b = l / ((x.dot(v) / r).powi(2) + (1.0 - 2.0 / r) * (l / r).powi(2)).sqrt();
        if (b / critical - 1.0).abs() > 1e-4 {
            rays.push([x.x, x.y, x.z, v.x, v.y, v.z]);
            fates.push(if inwards && b < critical { Status::Captured } else { Status::Escaped });
        }
    }
    for method in ["planar", "rkn4", "rk4", "dormand-prince", "bogacki-shampine"] {
        let rays_table =
            format!("[rays]\nbounding_sphere = {{ radius = 1001 }}\nmax_segments = 5000\nmethod = \"{method}\"\n");
        let scene = scene(&format!("[law]\nkind = \"schwarzschild\"\n{rays_table}"));
        let (ends, _) = trace(&gpu, &scene, &RenderSettings::default(), &rays).unwrap();
        let wrong = ends.iter().zip(&fates).filter(|(end, fate)| end.status != **fate).count();
        assert_eq!(wrong, 0, "{method}");
    }
}

fn places() -> Vec<(String, Scene, Vec<[f64; 6]>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/stability");
    let mut paths: Vec<_> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    let load = |path: &std::path::PathBuf| {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        (name, Scene::load(path, &[]).unwrap(), read_rays(&path.with_extension("csv"), true).unwrap())
    };
    paths.iter().map(load).collect()
}

#[test]
fn nothing_goes_wrong_in_silence() {
    let gpu = gpu();
    let by_turns = ["euler", "euler-doubling (2004)", "rkn4"];
    for (k, (name, scene, rays)) in places().into_iter().enumerate() {
        let place = StabilityCase::new(&gpu, &name, &scene, &rays).unwrap();
        let methods = ["planar", "dormand-prince", by_turns[k % 3]];
        for outcome in place.outcomes(Some(&methods)).unwrap() {
            let Outcome { right, given_up, over, disagreeing, unresolved, silent, .. } = outcome;
            assert_eq!(silent, 0, "{name}: {outcome:?}");
            assert_eq!(right + given_up + over + disagreeing + unresolved, rays.len(), "{name}: {outcome:?}");
        }
    }
}

/// A controller without its cap jumps over the black hole at every tolerance, and the table reveals this.
#[test]
fn a_controller_without_its_cap_is_found_out() {
    let gpu = gpu();
    let (name, scene, rays) = places().into_iter().find(|(name, ..)| name == "far_start").unwrap();
    let place = StabilityCase::new(&gpu, &name, &scene, &rays).unwrap();
    let methods = all_methods(&scene);
    let pair = methods.iter().find(|method| method.name == "dormand-prince").unwrap();
    let capped = place.outcome(pair, default_settings(pair)).unwrap();
    assert_eq!((capped.silent, capped.right), (0, rays.len()), "{capped:?}");
    let uncapped = [1e-1, 3e-2, 1e-2].map(|tolerance| embedded::with(tolerance, 1e9));
    let found = place.outcome(pair, uncapped).unwrap();
    assert!(found.silent > 0, "{found:?}");
}

/// The ray of a pixel is the same if it is followed alone and if it is followed with the whole image.
#[test]
fn chosen_pixels_are_the_pictures_own() {
    let gpu = gpu();
    let scene = scene(&format!("{HOLE}method = \"rk4\"\n[sky]\ncolor = [1, 1, 1]\n"));
    let picture = Renderer::new(&gpu, &scene, RenderSettings::default()).unwrap().render().unwrap();
    let mut tracer = Tracer::new(&gpu, &scene, RenderSettings::default(), Mode::Pixels).unwrap();
    let pixels: Vec<[u32; 2]> = (0..72).flat_map(|y| (0..96).map(move |x| [95 - x, y])).collect();
    let (rays, _) = tracer.follow(Starts::Pixels(&pixels, 96)).unwrap();
    for ([x, y], ray) in pixels.iter().zip(&rays) {
        let seen = picture.band.color[0][(y * 96 + x) as usize] > 0.5;
        assert_eq!(seen, ray.status == Status::Escaped, "{x} {y}");
    }
}

/// No shipped scene causes a warning.
#[test]
fn no_shipped_scene_is_too_fine_for_32_bits() {
    for path in crate::support::shipped_scenes() {
        let scene = Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(scene.rounded_away(), None, "{}", path.display());
    }
}
