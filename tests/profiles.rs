//! Tests line profiles, light curves and spectra against closed forms, and the properties of their sums.

use bentray::assets::Emissivity;
use bentray::measure::profile::{self, Emission, Orders};
use bentray::render::RenderSettings;
use glam::DVec3;

use crate::support::{gpu, scene};

/// A glowing star in front of a distant camera, around a black hole of mass 1.
fn star(radius: f64, camera: f64) -> String {
    format!(
        "[image]\nsize = [160, 160]\n[camera]\nposition = [0, 0, {camera}]\nfov = {}\nobserver = \"static\"\n\
         [law]\nkind = \"kerr-newman\"\nspin = 0\n[rays]\nbounding_sphere = {{ radius = 1100 }}\nprecision = \"f64\"\nmethod = \"separated\"\n\
         [materials.glow]\nkind = \"blackbody\"\ntemperature = 4000\n[[objects]]\nshape = \"sphere\"\nmaterial = \"glow\"\nradius = {radius}\n",
        2.0 * (1.4 * radius / camera).atan().to_degrees(),
    )
}

fn disk(opacity: f64, camera: &str) -> String {
    format!(
        "[image]\nsize = [120, 90]\n[camera]\nposition = {camera}\nup = [0, 0, 1]\nfov = 60\nobserver = \"static\"\n\
         [law]\nkind = \"kerr-newman\"\nspin = 0.7\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"separated\"\n\
         [materials.matter]\nkind = \"accretion\"\ntemperature = 1e7\nopacity = {opacity}\n\
         [[objects]]\nshape = \"disk\"\nmaterial = \"matter\"\nnormal = [0, 0, 1]\nradius = 14\ninner_radius = 4\n"
    )
}

fn emissions(text: &str) -> Vec<Emission> {
    let (emissions, totals) = profile::emissions(&gpu(), &scene(text), &RenderSettings::default(), None).unwrap();
    assert_eq!(totals.unfollowed(), 0);
    assert!(!emissions.is_empty());
    emissions
}

fn total(fluxes: &[Orders]) -> f64 {
    fluxes.iter().flatten().sum()
}

fn emissivity(text: &str) -> Emissivity {
    text.parse().unwrap()
}

/// A star of radius R subtends b = R/√(1 − 2M/R) from far away, its light arrives with one g, and light from its center takes
/// D − R + 2M ln((D − 2M)/(R − 2M)). The edge of the star covers parts of pixels, which limits the solid angle.
#[test]
fn a_star_has_the_flux_of_closed_forms() {
    let (r, d): (f64, f64) = (10.0, 1000.0);
    let all = emissions(&star(r, d));
    let [surface, far] = [r, d].map(|r| (1.0 - 2.0 / r).sqrt());
    let (g, sine) = (surface / far, r / surface / d * far);
    let solid_angle = std::f64::consts::TAU * (1.0 - (1.0 - sine * sine).sqrt());
    let found: f64 = all.iter().map(|e| e.weight).sum();
    assert!((found / solid_angle - 1.0).abs() < 3e-3, "{found} {solid_angle}");
    for e in &all {
        // A ray that grazes the star ends near its surface.
        assert!((e.g / g - 1.0).abs() < 3e-5 && e.order == 0 && e.width < 5e-5, "{e:?}");
    }

    let (line, _) = profile::line(&all, &emissivity("2 * mu / mu"), Some([0.0, 1.0]), 50).unwrap();
    let bin = (50.0 * g) as usize;
    assert!((line[bin][0] / 50.0 / (2.0 * found * g.powi(4)) - 1.0).abs() < 1e-5);
    assert!((total(&line) - line[bin][0]).abs() < 1e-12 * line[bin][0]);

    for (frequency, flux) in [1e12, 2e14, 9e14].into_iter().zip(profile::spectrum(&all, &[1e12, 2e14, 9e14])) {
        let expected = found * profile::planck(frequency, g * 4000.0);
        assert!((flux[0] / expected - 1.0).abs() < 1e-5, "{frequency}: {flux:?} {expected}");
    }

    let nearest = all.iter().map(|e| e.time).fold(f64::INFINITY, f64::min);
    let travel = d - r + 2.0 * ((d - 2.0) / (r - 2.0)).ln();
    assert!((nearest - travel).abs() < 1e-2, "{nearest} {travel}");
    let curve = profile::light_curve(&all, &emissivity("t + 2000"), &[0.0, 30.0]).unwrap();
    let mean = all.iter().map(|e| e.weight * e.time).sum::<f64>() / found;
    for (t, flux) in [0.0, 30.0].into_iter().zip(curve) {
        assert!((flux[0] / (found * g.powi(4) * (2000.0 + t - mean)) - 1.0).abs() < 1e-5);
    }
}

/// A camera outside of the bounding sphere sees the same times: light outside takes as long as the straight distance.
#[test]
fn time_runs_from_the_camera() {
    let inside = emissions(&star(10.0, 1000.0).replace("spin = 0", "spin = 0\nmass = 1e-9"));
    let outside = emissions(&star(10.0, 1000.0).replace("spin = 0", "spin = 0\nmass = 1e-9").replace("1100", "20"));
    let nearest = |all: &[Emission]| all.iter().map(|e| e.time).fold(f64::INFINITY, f64::min);
    assert!((nearest(&inside) - 990.0).abs() < 1e-3 && (nearest(&outside) - 990.0).abs() < 1e-3);
}

/// With the opacity o, light of order k is proportional to o (1 − o)ᵏ. The widths of pixels move light between intervals but lose none.
#[test]
fn orders_dim_by_what_covers_them() {
    let of = |opacity: f64| emissions(&disk(opacity, "[0, -30, 6]"));
    let [thin, thick] = [0.1, 0.6].map(of);
    let cubic = emissivity("r^-3 * (1 + 0.5 * cos(phi))");
    let fluxes = [&thin, &thick].map(|all| {
        let (line, range) = profile::line(all, &cubic, None, 300).unwrap();
        let per_bin = (range[1] - range[0]) / 300.0;
        let flux: Orders = std::array::from_fn(|k| line.iter().map(|orders| orders[k] * per_bin).sum());
        let curve = profile::light_curve(all, &cubic, &[0.0]).unwrap();
        assert!(flux.iter().zip(curve[0]).all(|(a, b)| (a - b).abs() < 1e-9 * b.max(1e-30)), "{flux:?} {curve:?}");
        flux
    });
    for k in 0..2 {
        let expected = (0.6 * 0.4f64.powi(k)) / (0.1 * 0.9f64.powi(k));
        let found = fluxes[1][k as usize] / fluxes[0][k as usize];
        assert!((found / expected - 1.0).abs() < 1e-6, "order {k}: {found} {expected}");
    }
}

/// The line profile of many pixels agrees with that of few.
#[test]
fn profiles_converge() {
    let at = |size: &str| {
        let text = disk(1.0, "[0, -26, 16]").replace("size = [120, 90]", size);
        let (line, _) = profile::line(&emissions(&text), &emissivity("r^-2"), Some([0.3, 1.3]), 25).unwrap();
        line.iter().map(|orders| orders[0]).collect::<Vec<_>>()
    };
    let [fine, coarse] = ["size = [800, 600]", "size = [200, 150]"].map(at);
    let most = fine.iter().copied().fold(0.0, f64::max);
    let apart = fine.iter().zip(&coarse).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 0.02 * most, "{apart} of {most}");
}

/// The temperature of a ring is that of the material, and the hottest ring has the temperature of the scene.
#[test]
fn rings_have_the_temperatures_of_the_disk() {
    let all = emissions(&disk(1.0, "[0, -26, 16]").replace("inner_radius = 4", "inner_radius = 3.5"));
    let hottest = all.iter().filter_map(|e| e.temperature).fold(0.0, f64::max);
    assert!((hottest / 1e7 - 1.0).abs() < 1e-4, "{hottest}");
    let at_hottest = all.iter().max_by(|a, b| a.temperature.unwrap().total_cmp(&b.temperature.unwrap())).unwrap();
    let outer = all.iter().max_by(|a, b| a.radius.total_cmp(&b.radius)).unwrap();
    assert!(at_hottest.radius < 7.0 && outer.temperature.unwrap() < 0.8e7, "{at_hottest:?} {outer:?}");
}

#[test]
fn an_invalid_emissivity_is_an_error_that_names_the_place() {
    let all = emissions(&disk(1.0, "[0, -26, 16]"));
    for (formula, value) in [("1 - r", "-"), ("log(3 - r)", "NaN")] {
        let error = profile::line(&all, &emissivity(formula), None, 10).unwrap_err().to_string();
        assert!(error.starts_with(&format!("the emissivity is {value}")) && error.contains("at r = "), "{error}");
    }
}

/// The solid angles of all pixels add up to that of the view.
#[test]
fn solid_angles_fill_the_view() {
    use bentray::model::camera::{Corners, Fisheye, Panorama, Pinhole, Projection};
    use bentray::scene::Camera;
    use std::sync::Arc;
    let size = [90, 60];
    let fisheye = Fisheye { fov: 140.0, corners: Corners::Black };
    let slopes = [0.5 * 0.9f64.tan() * 2.0 * 1.5, 0.9f64.tan()];
    let rectangle = 4.0 * (slopes[0] * slopes[1] / (1.0 + slopes[0].powi(2) + slopes[1].powi(2)).sqrt()).atan();
    let views: [(Arc<dyn Projection>, f64); 3] = [
        (Arc::new(Pinhole { fov: 1.8f64.to_degrees() }), rectangle),
        (Arc::new(Panorama { fov: [360.0, 180.0] }), 4.0 * std::f64::consts::PI),
        (Arc::new(fisheye), std::f64::consts::TAU * (1.0 - 70f64.to_radians().cos())),
    ];
    for (view, expected) in views {
        let camera = Camera::look_at(DVec3::Z, DVec3::ZERO, DVec3::Y, view.clone()).unwrap();
        let inside = |x: u32, y: u32| {
            let [dx, dy] = [f64::from(x) + 0.5 - 45.0, f64::from(y) + 0.5 - 30.0];
            !view.part().ends_with("fisheye") || dx.hypot(dy) < 30.0
        };
        let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).filter(|(x, y)| inside(*x, *y));
        let found: f64 = pixels.map(|(x, y)| camera.solid_angle(size, [x, y]).unwrap()).sum();
        assert!((found / expected - 1.0).abs() < 5e-3, "{view:?}: {found} {expected}");
    }
}
