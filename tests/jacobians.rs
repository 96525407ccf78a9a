//! Tests the Jacobian of rays and optical paths: magnifications against a table, and the others against closed forms in media.

use bentray::measure::{Jacobian, jacobians, optical_paths, refuses_optical_paths};
use bentray::render::RenderSettings;
use bentray::scene::Scene;
use glam::{DMat2, DVec2, DVec3};

use crate::oracle::{rows, vector};
use crate::support::{gpu, scene};

fn found(scene: &Scene, rays: &[[f64; 6]]) -> Vec<Option<Jacobian>> {
    let (found, totals) = jacobians(&gpu(), scene, &RenderSettings::default(), rays).unwrap();
    assert_eq!(totals.rays, rays.len() as u64);
    found.into_iter().map(|(_, jacobian)| jacobian).collect()
}

fn ray(x: DVec3, v: DVec3) -> [f64; 6] {
    [x.x, x.y, x.z, v.x, v.y, v.z]
}

fn across(d: DVec3) -> [DVec3; 2] {
    let first = DVec3::Z.cross(d).normalize();
    [first, d.cross(first)]
}

/// The coordinate direction of light with a local direction d is d, with its radial component times √(1 − 2M/r).
fn seen(x: DVec3, d: DVec3) -> DVec3 {
    let out = x.normalize();
    d + d.dot(out) * ((1.0 - 2.0 / x.length()).sqrt() - 1.0) * out
}

#[test]
fn magnifications_are_those_of_a_black_hole() {
    let hole = |law: &str, more: &str| {
        scene(&format!(
            "[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 1200 }}\nsky_at_infinity = true\nmax_segments = 100000\n{more}\n"
        ))
    };
    let rows = rows(include_str!("tables/magnifications.tsv"));
    let rays: Vec<[f64; 6]> =
        rows.iter().map(|row| ray(vector(row[1]), seen(vector(row[1]), vector(row[2])))).collect();
    let double = "precision = \"f64\"\nmethod = \"planar\"\nscaled_step = 0.01";
    for (scene, bound) in [
        (hole("kind = \"schwarzschild\"\nmass = 1", double), 1e-7),
        (hole("kind = \"schwarzschild\"\nmass = 1", "method = \"dormand-prince\"\ntolerance = 1e-6"), 1e-3),
    ] {
        for (row, jacobian) in rows.iter().zip(found(&scene, &rays)) {
            let expected: f64 = row[3].parse().unwrap();
            let jacobian = jacobian.unwrap();
            let found = jacobian.magnification();
            assert!((found / expected - 1.0).abs() < bound, "{}: {found} {expected}", row[0]);
        }
    }
}

/// Paths in a rod are harmonic across its axis and uniform along it, and end after a fixed τ.
#[test]
fn derivatives_are_those_of_a_gradient_rod() {
    let (n0, g, time): (f64, f64, f64) = (1.6, 0.4, 3.1);
    let rod = scene(&format!(
        "[law]\nkind = \"medium\"\nindex = {{ kind = \"rod\", n0 = {n0}, g = {g} }}\n[rays]\nbounding_sphere = {{ radius = 50 }}\n\
         max_parameter = {time}\nprecision = \"f64\"\nmethod = \"dormand-prince\"\ntolerance = 1e-13\nmax_segments = 20000\n"
    ));
    let starts = [
        (DVec3::new(0.3, -0.2, 0.1), DVec3::new(0.1, 0.2, 1.0)),
        (DVec3::new(-0.5, 0.1, 0.0), DVec3::new(0.4, -0.3, 0.9)),
    ];
    let rays: Vec<[f64; 6]> = starts.iter().map(|(x, d)| ray(*x, *d)).collect();
    let omega = n0 * g;
    for ((x, d), found) in starts.into_iter().zip(found(&rod, &rays)) {
        let (d, found) = (d.normalize(), found.unwrap());
        let n = n0 * (1.0 - g * g * (x.x * x.x + x.y * x.y)).sqrt();
        let (sine, cosine) = (omega * time).sin_cos();
        let harmonic = |across: f64, along: f64, v: DVec3| DVec3::new(across * v.x, across * v.y, along * v.z);
        let still = DVec3::new(-omega * sine * x.x, -omega * sine * x.y, 0.0);
        let velocity = still + harmonic(cosine, 1.0, n * d);
        let (end, speed) = (velocity.normalize(), velocity.length());
        let [starting, ending] = [across(d), across(end)];
        let matrix = |of: &dyn Fn(DVec3) -> DVec3| {
            let columns = starting.map(|a| DVec2::from(ending.map(|b| b.dot(of(a)))));
            DMat2::from_cols(columns[0], columns[1])
        };
        let position = matrix(&|a| harmonic(sine / omega, time, n * a));
        let direction = matrix(&|a| harmonic(cosine, 1.0, n * a) / speed);
        for (found, expected) in [(found.position, position), (found.direction, direction)] {
            let apart = (found - expected).to_cols_array().into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            assert!(apart < 1e-9, "{found} {expected}: {apart}");
        }
    }
}

/// Outside of a Luneburg lens rays are straight, and inside x'' = −x; all rays from a point of its surface leave it parallel.
#[test]
fn light_from_a_point_of_a_luneburg_lens_is_parallel() {
    let lens = scene(
        "[law]\nkind = \"medium\"\nindex = { kind = \"luneburg\", radius = 1 }\n[rays]\nbounding_sphere = { radius = 1 }\nprecision = \"f64\"\n\
         method = \"dormand-prince\"\ntolerance = 1e-12\n",
    );
    let start = DVec3::new(-0.8, 0.6, 0.0) * (1.0 - 1e-9);
    let found = found(&lens, &[ray(start, DVec3::new(0.6, -0.5, 0.4))])[0].unwrap();
    assert!(found.direction.determinant().abs() < 1e-6 && found.magnification().abs() > 1e6, "{found:?}");
}

/// A ray that is captured has no derivative.
#[test]
fn captured_rays_have_no_derivative() {
    let scene = scene(
        "[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 40 }\nprecision = \"f64\"\nmethod = \"planar\"\nscaled_step = 0.1\n",
    );
    let x = DVec3::new(-10.0, 0.0, 0.0);
    let found = found(&scene, &[ray(x, DVec3::Y), ray(x, DVec3::X)]);
    assert!(found[0].is_some() && found[1].is_none());
}

fn optical(text: &str, rays: &[[f64; 6]]) -> Vec<[f64; 2]> {
    let found = optical_paths(&gpu(), &scene(text), &RenderSettings::default(), rays).unwrap();
    found.into_iter().map(|path| [path.length, path.optical]).collect()
}

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}: {:e}", found / expected - 1.0);
}

/// Inside a Luneburg lens x = x₀ cos τ + v₀ sin τ and n² = 2 − r², so that ∫ n² dτ = (2 − (r₀² + v₀²)/2) τ − … in closed form. Light from a
/// point of the surface has the same optical path to every point of the plane wave.
#[test]
fn optical_paths_are_those_of_a_luneburg_lens() {
    let lens = "[law]\nkind = \"medium\"\nindex = { kind = \"luneburg\", radius = 1 }\n[rays]\nbounding_sphere = { radius = 1 }\n";
    let source = DVec3::new(-1.0, 0.0, 0.0);
    let start = source * (1.0 - 1e-12);
    let turns = [0.2, 0.5, 0.9].map(|turn: f64| DVec3::new(turn.cos(), turn.sin() * 0.6, turn.sin() * 0.8));
    let rays: Vec<[f64; 6]> = turns.iter().map(|d| ray(start, *d)).collect();
    for (d, [_, found]) in turns.into_iter().zip(optical(lens, &rays)) {
        // x = −cos τ + d_x sin τ and the distance from the axis is sin τ times that of d: the ray leaves at τ = π/2 in d.
        let until = std::f64::consts::FRAC_PI_2;
        // r² = cos² τ + sin² τ − 2 d_x sin τ cos τ = 1 − d_x sin 2τ, and n² = 1 + d_x sin 2τ.
        near(found, until + d.x);
    }
}

/// In a gradient rod, ρ² is a sinusoid of 2ωτ; every term has a closed form.
#[test]
fn optical_paths_are_those_of_a_gradient_rod() {
    let (n0, g, time): (f64, f64, f64) = (1.6, 0.4, 7.3);
    let rod = format!(
        "[law]\nkind = \"medium\"\nindex = {{ kind = \"rod\", n0 = {n0}, g = {g} }}\n[rays]\nbounding_sphere = {{ radius = 50 }}\n\
         max_parameter = {time}\n"
    );
    let (x, d) = (DVec3::new(0.3, -0.2, 0.1), DVec3::new(0.1, 0.2, 1.0).normalize());
    let n = n0 * (1.0 - g * g * (x.x * x.x + x.y * x.y)).sqrt();
    let omega = n0 * g;
    // ∫ (a cos ωτ + b sin ωτ)² dτ for each axis.
    let squares: f64 = [(x.x, n * d.x / omega), (x.y, n * d.y / omega)]
        .into_iter()
        .map(|(a, b)| {
            let (sine, cosine) = (2.0 * omega * time).sin_cos();
            0.5 * (a * a + b * b) * time
                + (a * a - b * b) * sine / (4.0 * omega)
                + a * b * (1.0 - cosine) / (2.0 * omega)
        })
        .sum();
    near(optical(&rod, &[ray(x, d)])[0][1], n0 * n0 * (time - g * g * squares));
}

/// Rays in Maxwell's fisheye, n = 2/(1 + r²), are circles; all rays from a point to its image have the optical path π.
#[test]
fn optical_paths_of_a_fisheye_are_half_a_turn() {
    let eye = "[law]\nkind = \"medium\"\nindex = { kind = \"maxwell-fisheye\", n0 = 2, a = 1 }\n[rays]\nbounding_sphere = { radius = 1 }\n";
    let start = DVec3::X * (1.0 - 1e-12);
    let rays = [0.3, 0.8, 1.2].map(|turn: f64| ray(start, DVec3::new(-turn.cos(), turn.sin(), 0.0)));
    for [_, found] in optical(eye, &rays) {
        near(found, std::f64::consts::PI);
    }
}

/// A plate of glass, and the way to the bounding sphere and behind the plate.
#[test]
fn optical_paths_cross_surfaces() {
    let plate =
        "[rays]\nbounding_sphere = { radius = 10 }\n[[objects]]\nshape = \"box\"\nsize = [2, 12, 12]\ninterior = 1.5\n";
    let d = DVec3::new(0.8, 0.6, 0.0);
    let [length, found] = optical(plate, &[ray(DVec3::new(-20.0, -15.0, 0.0), d)])[0];
    // Snell: sin = 0.6/1.5 inside.
    let inside = 2.0 / (1.0f64 - 0.16).sqrt();
    assert!((found - length - 0.5 * inside).abs() < 1e-9, "{found} {length} {inside}");
    // The ray starts 15 before the sphere, and leaves it shifted sideways by the plate.
    let shift = inside * (0.6 * (1.0f64 - 0.16).sqrt() - 0.8 * 0.4);
    let along = inside * (0.8 * (1.0f64 - 0.16).sqrt() + 0.6 * 0.4);
    let outside = 15.0 + 10.0 + (100.0 - shift * shift).sqrt() - along;
    near(length, outside + inside);
}

#[test]
fn only_media_have_optical_paths() {
    let refused = |text: &str| refuses_optical_paths(&scene(text)).is_some();
    assert!(refused("[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 10 }\n"));
    assert!(!refused("[rays]\nbounding_sphere = { radius = 10 }\n"));
}
