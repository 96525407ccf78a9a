//! The redshift of light on its path, compared with closed forms and answers to 15 digits.

use bentray::model::black_body;
use bentray::program::{Layer, ProgramOptions, Schedule};
use bentray::render::{Plane, RenderSettings, Renderer, Rendering};
use bentray::scene::Scene;
use glam::DVec3;

use crate::oracle::{rows, vector};
use crate::support::{gpu, scene};

/// Renders a scene with the layers of positions and redshifts.
pub fn rendered(scene: &Scene) -> Rendering {
    let options = ProgramOptions { layers: vec![Layer::Position, Layer::Redshift], ..ProgramOptions::default() };
    let settings = RenderSettings { options, ..RenderSettings::default() };
    Renderer::new(&gpu(), scene, settings).unwrap().render().unwrap()
}

pub fn shifts(picture: &Rendering) -> &[f32] {
    match picture.band.layer(Layer::Redshift) {
        Some(Plane::Scalar(values)) => values,
        _ => panic!("no redshift layer"),
    }
}

/// The sky is brighter by g⁴, for a boosted observer of speed 0.6 in flat space (Doppler formula), and for a static one near a black hole.
#[test]
fn the_sky_is_as_bright_as_its_shift() {
    let flat = "kind = \"metric\"\nline_element = \"-dt^2 + dx^2 + dy^2 + dz^2\"\nscale = \"9\"";
    let moving = "observer = \"boosted\"\nvelocity = [0, 0.6, 0]";
    let hole = "kind = \"kerr-newman\"\nspin = 0.5";
    let charged = "kind = \"reissner-nordstrom\"\ncharge = 0.8\ncosmological_constant = 0.003";
    let near_charged = 1.0 / (1.0 - 0.2 + 0.0064 - 0.1_f64).sqrt();
    let near_hole = 1.0 / (1.0 - 2.0 * 1000.0 / (10_000.0_f64)).sqrt();
    for (law, frame, ahead, g) in [
        (flat, moving, [10, 1, 0], 2.0),
        (flat, moving, [10, -1, 0], 0.5),
        (flat, moving, [11, 0, 0], 0.8),
        (hole, "observer = \"static\"", [10, 0, 1], near_hole),
        (charged, "observer = \"static\"", [10, 1, 1], near_charged),
    ] {
        // In the equator of a rotating black hole Σ = r², and r = 10.
        let x = if law == hole { (100.0_f64 + 0.25).sqrt() } else { 10.0 };
        let picture = rendered(&scene(&format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = [{x:?}, 0, 0]\nfov = 1\n{frame}\nlook_at = {ahead:?}\nup = [1, 1, 1]\n\
             redshift = true\n[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 60 }}\n[sky]\ncolor = [1, 0.5, 0.25]\n"
        )));
        let found = f64::from(shifts(&picture)[0]);
        assert!((found / g - 1.0).abs() < 1e-5, "{frame} towards {ahead:?}: {found}, not {g}");
        for (channel, color) in [1.0, 0.5, 0.25].into_iter().enumerate() {
            let off = f64::from(picture.band.color[channel][0]) / (color * g.powi(4)) - 1.0;
            assert!(off.abs() < 1e-4, "{frame} towards {ahead:?}: off by {off}");
        }
    }
}

/// Between static positions light is redshifted as their clocks require, and for a moving observer by the Doppler formula as well.
#[test]
fn light_is_shifted_as_clocks_and_speeds_say() {
    let clock = |r: f64| (1.0 - 2.0 / r).sqrt();
    let hole = "kind = \"schwarzschild\"";
    let geodesic = "kind = \"schwarzschild\"\nform = \"geodesic\"";
    let wormhole = "kind = \"wormhole\"\nother_mouth = [90, 0, 0]";
    let ball = "[[objects]]\nshape = \"sphere\"\ncenter = [0, 0, 12]\nradius = 0.5\nmaterial = \"a\"\n";
    let rest = "observer = \"static\"";
    for (law, frame, objects, expected) in [
        (hole, rest, "", 1.0 / clock(6.0)),
        (geodesic, rest, "", 1.0 / clock(6.0)),
        (hole, rest, ball, clock(11.5) / clock(6.0)),
        (wormhole, rest, "", 1.0),
        (wormhole, rest, ball, 1.0),
        (wormhole, "observer = \"boosted\"\nvelocity = [0, 0, 0.6]", "", 2.0),
        (wormhole, "observer = \"boosted\"\nvelocity = [0, 0, -0.6]", ball, 0.5),
    ] {
        let scene = scene(&format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 6]\nlook_at = [0, 0, 20]\nfov = 1\n{frame}\n[law]\n{law}\n\
             [rays]\nbounding_sphere = {{ radius = 40 }}\nmethod = \"dormand-prince\"\ntolerance = 1e-6\n\
             [materials.a]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n{objects}"
        ));
        let shift = f64::from(shifts(&rendered(&scene))[0]);
        assert!((shift / expected - 1.0).abs() < 1e-5, "{law} {frame} {objects}: {shift} for {expected}");
    }
}

/// Under laws that depend on t a ray carries its momentum: the redshift between static positions agrees with series of 34
/// and 48 digits, and is equal in all schedules.
#[test]
fn light_shifts_in_time_as_series_say() {
    for row in rows(include_str!("tables/shifts_in_time.tsv")) {
        let [end, way] = [4, 5].map(|i| vector(row[i]));
        let told = 1.0 / row[6].parse::<f64>().unwrap();
        let [origin, ahead] = [vector(row[2]), vector(row[2]) + vector(row[3])].map(|x| x.to_array());
        for (precision, tolerance, bound) in [("f32", 1e-6, 1e-4), ("f64", 1e-12, 1e-7)] {
            let scene = scene(&format!(
                "[image]\nsize = [1, 1]\n[camera]\nposition = {origin:?}\nlook_at = {ahead:?}\nup = [0.3, 0.2, 1]\nfov = 1\n{}\n\
                 [law]\n{}\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"dormand-prince\"\ntolerance = {tolerance}\n\
                 precision = \"{precision}\"\nmax_segments = 5000\n[materials.a]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
                 [[objects]]\nshape = \"disk\"\nmaterial = \"a\"\nradius = 0.02\ncenter = {:?}\nnormal = {:?}\n",
                row[7].replace(';', "\n"),
                row[1].replace(';', "\n"),
                end.to_array(),
                way.to_array(),
            ));
            // Passes are cut identically in both precisions.
            let schedules = if precision == "f32" { &Schedule::ALL[..] } else { &[Schedule::Whole] };
            let seen: Vec<f32> = schedules
                .iter()
                .map(|&schedule| {
                    let options =
                        ProgramOptions { schedule, layers: vec![Layer::Redshift], ..ProgramOptions::default() };
                    let settings = RenderSettings { options, ..RenderSettings::default() };
                    shifts(&Renderer::new(&gpu(), &scene, settings).unwrap().render().unwrap())[0]
                })
                .collect();
            let off = f64::from(seen[0]) / told - 1.0;
            println!("{} in {precision}: {} for {told}", row[0], seen[0]);
            assert!(off.abs() < bound, "{} in {precision}: {} for {told}", row[0], seen[0]);
            assert!(seen.iter().all(|shift| shift.to_bits() == seen[0].to_bits()), "{}: {seen:?}", row[0]);
        }
    }
}

/// In expanding space light is redshifted by the expansion since its emission, and for a moving observer by the Doppler formula as well.
#[test]
fn light_reddens_as_space_grows() {
    let space = "kind = \"metric\"\nline_element = \"-dt^2 + exp(2*H*t)*(dx^2 + dy^2 + dz^2)\"\nscale = \"5\"\n\
                 parameters = { H = 0.05 }\ntime = 3";
    for (frame, doppler) in [("observer = \"static\"", 1.0), ("observer = \"boosted\"\nvelocity = [0.6, 0, 0]", 2.0)] {
        let scene = scene(&format!(
            "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 0]\nlook_at = [1, 0, 0]\nup = [0, 0, 1]\nfov = 1\n{frame}\nredshift = true\n[law]\n{space}\n\
             [rays]\nbounding_sphere = {{ radius = 10 }}\nmethod = \"rk4\"\nscaled_step = 0.05\n[sky]\ncolor = [1, 1, 1]\n"
        ));
        // dx = e^(−Ht) dt: from x = 10 the light has traveled e^(−Ht) − e^(−3H) = 10 H.
        let grown = 1.0 / (1.0 + 0.5 * (0.15_f64).exp());
        let picture = rendered(&scene);
        let found = f64::from(shifts(&picture)[0]);
        assert!((found / (doppler * grown) - 1.0).abs() < 1e-5, "{frame}: {found}, not {}", doppler * grown);
        assert!((f64::from(picture.band.color[0][0]) / found.powi(4) - 1.0).abs() < 1e-5);
    }
}

/// If colors represent black bodies, a sky or a surface with the color of one shows the color at g times its temperature.
#[test]
fn hues_shift_as_those_of_black_bodies() {
    for (kelvin, kept) in [(3000.0, false), (5000.0, false), (9000.0, false), (5000.0, true)] {
        let color = black_body::color(kelvin).0;
        for (ahead, g) in [(1.0, 2.0), (-1.0, 0.5)] {
            for (sky, surface) in [
                (color, ""),
                (DVec3::ZERO, "[[objects]]\nshape = \"sphere\"\ncenter = [0, 0, 0]\nmaterial = \"a\"\nradius = 20\n"),
            ] {
                let hues = if kept { "kept" } else { "black-body" };
                let rgb = color.to_array();
                let picture = rendered(&scene(&format!(
                    "[image]\nsize = [1, 1]\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, {ahead}, 0]\nup = [0, 0, 1]\nfov = 1\nobserver = \"boosted\"\n\
                     velocity = [0, 0.6, 0]\nredshift = true\ncolor_shift = \"{hues}\"\n[rays]\nbounding_sphere = {{ radius = 60 }}\n[sky]\ncolor = {:?}\n\
                     [materials.a]\nkind = \"emissive\"\ncolor = {rgb:?}\n{surface}",
                    sky.to_array()
                )));
                let (shifted, luminance) = black_body::color(kelvin * g);
                let told =
                    if kept { color * g.powi(4) } else { shifted * (luminance - black_body::color(kelvin).1).exp() };
                let found = DVec3::from_array([0, 1, 2].map(|channel| f64::from(picture.band.color[channel][0])));
                assert!(found.distance(told) < 1e-2 * told.length(), "{kelvin} by {g}: {found}, not {told}");
            }
        }
    }
}
