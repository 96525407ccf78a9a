//! The noise index and the law of the medium, compared with an independent version of the noise in f64.

use bentray::model::Value::{Float, Uint, Vec3 as V3};
use glam::{DMat3, DVec3, Vec4};

use super::{Errors, Random, U, vectors, wide};
use crate::support::{gpu, probe::Probe};

const CENTER: DVec3 = DVec3::new(0.5, -0.25, 1.0);
const RADIUS: f64 = 3.0;
const AMPLITUDE: f64 = 0.25;
const FREQUENCY: f64 = 1.5;
const OCTAVES: i32 = 3;
const SEED: u32 = 77;

fn probe() -> Probe {
    with_medium(&[
        "segment/ray",
        "state/loops",
        "law/phase_space",
        "law/medium",
        "law/start_by_index",
        "medium/explosion",
        "medium/fractal_noise",
    ])
}

fn with_medium(parts: &[&str]) -> Probe {
    let medium = vec![
        ("center", V3(CENTER)),
        ("radius", Float(RADIUS)),
        ("amplitude", Float(AMPLITUDE)),
        ("frequency", Float(FREQUENCY)),
        ("octaves", Uint(OCTAVES as u32)),
        ("seed", Uint(SEED)),
    ];
    Probe::new(&[parts, &["surface/region_none"]].concat()).list("media", "MEDIA_COUNT", [medium])
}

/// Returns the rotation, with its exact f32 entries.
fn turn() -> DMat3 {
    let f = |a: f32| f64::from(a);
    DMat3::from_cols(
        DVec3::new(f(0.36), f(0.48), f(-0.8)),
        DVec3::new(f(-0.8), f(0.6), 0.0),
        DVec3::new(f(0.48), f(0.64), f(0.6)),
    )
}

const SHIFT: DVec3 = DVec3::new(0.317, 0.731, 0.523);

fn corner(cell: [i64; 3]) -> f64 {
    let c = cell.map(|k| k as u32);
    let seed = c[0].wrapping_mul(0x8da6_b343)
        ^ c[1].wrapping_mul(0xd816_3841)
        ^ c[2].wrapping_mul(0xcb1a_b31f)
        ^ SEED.wrapping_mul(0x9e37_79b1);
    let state = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    f64::from(((word >> 22) ^ word) >> 8) / 8_388_607.5 - 1.0
}

/// Returns the noise by blending the eight corners with weights, without expanded polynomials.
fn noise(p: DVec3) -> f64 {
    let base = p.floor();
    let f = p - base;
    let u = DVec3::from_array(f.to_array().map(|t| t.powi(3) * (6.0 * t * t - 15.0 * t + 10.0)));
    let mut sum = 0.0;
    for k in 0..8_u8 {
        let on = [k & 1, (k >> 1) & 1, (k >> 2) & 1];
        let weight: f64 = (0..3).map(|axis| if on[axis] == 1 { u[axis] } else { 1.0 - u[axis] }).product();
        sum += weight * corner(std::array::from_fn(|axis| base[axis] as i64 + i64::from(on[axis])));
    }
    sum
}

fn index(x: DVec3) -> f64 {
    let d = x - CENTER;
    let q = d.length() / RADIUS;
    if q >= 1.0 {
        return 1.0;
    }
    let sum: f64 =
        (0..OCTAVES).map(|j| 0.5_f64.powi(j) * noise(turn() * (FREQUENCY * 2.0_f64.powi(j) * d) + SHIFT)).sum();
    1.0 + AMPLITUDE * (2.0 * q.powi(3) - 3.0 * q * q + 1.0) * sum
}

/// Returns central differences, whose error is (10⁻⁵)² times third derivatives of at most 10⁴.
fn gradient(x: DVec3) -> DVec3 {
    let h = 1e-5;
    DVec3::from_array(DVec3::AXES.map(|e| (index(x + h * e) - index(x - h * e)) / (2.0 * h)))
}

/// Returns bounds on the errors of the index and of its gradient at a distance r from the center.
///
/// A lattice point errs by 8 U of its size (the product with the rotation, three terms). Along an axis the noise changes by
/// at most 2 · 15/8 per cell (three axes: 6.5), and that slope by 2 · 10/√3 and 4 · (15/8)² across (the norm of the
/// Hessian: 45). The value is a sum of about 30 terms up to 8.
fn bounds(r: f64) -> (f64, f64) {
    let (mut value, mut slope) = (4.0 * U, 1e-5);
    for j in 0..OCTAVES {
        let (frequency, weight) = (FREQUENCY * 2.0_f64.powi(j), AMPLITUDE * 0.5_f64.powi(j));
        let moved = 8.0 * U * (frequency * r + 1.0);
        value += weight * (6.5 * moved + 30.0 * U);
        slope += weight * (frequency * (45.0 * moved + 100.0 * U) + 1.5 / RADIUS * (6.5 * moved + 30.0 * U));
    }
    (value, slope)
}

#[test]
fn index_and_gradient() {
    let mut random = Random::new(31);
    let places = vectors(&mut random, 4000, 1e-4, RADIUS);
    let inputs: Vec<[Vec4; 2]> =
        places.iter().map(|d| [(CENTER.as_vec3() + *d).extend(0.0), random.vector(0.1, 10.0).extend(0.0)]).collect();
    let body = "let here = Phase(p0.xyz, p1.xyz);
        let rate = law_derivative(here);
        let start = law_start(p0.xyz, p1.xyz);
        let settled = law_projected(here);
        put(0u, explosion(p0.xyz));
        put(1u, vec4f(rate[1], law_scale(here)));
        put(2u, vec4f(start[1], 0.0));
        put(3u, vec4f(settled[1], 0.0));";
    let out = probe().run::<2, 4>(&gpu(), body, &inputs);
    let names = ["medium index", "medium gradient", "medium rate", "medium start", "medium scale"];
    let [mut values, mut slopes, mut rates, mut starts, mut scales] = names.map(Errors::of);
    for (input, output) in inputs.iter().zip(&out) {
        let (x, v) = (wide(input[0]), wide(input[1]));
        let r = (x - CENTER).length();
        let (n, slope) = (index(x), gradient(x));
        let (value_bound, slope_bound) = bounds(r);
        values.check(output[0].w, n, value_bound, input);
        slopes.check3(output[0], slope, slope_bound, input);
        rates.check3(output[1], n * slope, n * slope_bound + value_bound * slope.length() + U * slope.length(), input);
        starts.check3(output[2], n * v.normalize(), value_bound + 6.0 * U, input);
        assert_eq!(output[3].truncate(), input[1].truncate());
        let cell = (0.5_f64.powi(OCTAVES - 1) / FREQUENCY).min(RADIUS);
        let scale = cell.max(r - RADIUS) / v.length();
        scales.check(output[1].w, scale, 10.0 * U * (scale + r / v.length()), input);
    }
    for errors in [values, slopes, rates, starts, scales] {
        errors.report();
    }
}

/// On both sides of every kind of lattice face the index and its gradient agree as far as their distance allows.
#[test]
fn noise_is_smooth_across_its_lattice() {
    let mut random = Random::new(32);
    let mut pairs = Vec::new();
    for _ in 0..3000 {
        let octave = 2.0_f64.powi((random.unit() * f64::from(OCTAVES)) as i32);
        let mut p = DVec3::from_array([0; 3].map(|_| random.within(-3.0, 3.0)));
        let axis = (random.unit() * 3.0) as usize;
        p[axis] = p[axis].round();
        let away = 1e-4 * DVec3::AXES[axis];
        let sides = [p - away, p + away].map(|p| CENTER + turn().inverse() * (p - SHIFT) / (FREQUENCY * octave));
        pairs.push(sides.map(DVec3::as_vec3));
    }
    let inputs: Vec<[Vec4; 2]> = pairs.iter().map(|pair| pair.map(|x| x.extend(0.0))).collect();
    let body = "put(0u, explosion(p0.xyz)); put(1u, explosion(p1.xyz));";
    let out = probe().run::<2, 2>(&gpu(), body, &inputs);
    let (mut values, mut slopes) = (Errors::of("index across faces"), Errors::of("gradient across faces"));
    for ([a, b], [below, above]) in inputs.iter().zip(&out) {
        let apart = (wide(*a) - wide(*b)).length();
        let (value_bound, slope_bound) = bounds(RADIUS);
        // Slopes of value and gradient, as in `bounds`: summed over the octaves, plus the slopes of ξ (1.5/R, 6/R²).
        let steepest = AMPLITUDE * (6.5 * FREQUENCY * f64::from(OCTAVES) + 2.0 * 1.5 / RADIUS);
        let bend =
            AMPLITUDE * (45.0 * FREQUENCY.powi(2) * 7.0 + 3.0 * 6.5 * FREQUENCY * 3.0 / RADIUS + 12.0 / RADIUS.powi(2));
        values.check(below.w, f64::from(above.w), 2.0 * value_bound + steepest * apart, (a, b));
        slopes.check3(*below, wide(*above), 2.0 * slope_bound + bend * apart, (a, b));
    }
    values.report();
    slopes.report();
}

#[test]
fn nothing_bends_outside() {
    let mut random = Random::new(33);
    let places = vectors(&mut random, 1000, RADIUS * 1.000_01, 1e5);
    let inputs: Vec<[Vec4; 1]> = places.iter().map(|d| [(CENTER.as_vec3() + *d).extend(0.0)]).collect();
    let out = probe().run::<1, 1>(&gpu(), "put(0u, explosion(p0.xyz));", &inputs);
    for (input, [n]) in inputs.iter().zip(&out) {
        if (wide(input[0]) - CENTER).length() > RADIUS * (1.0 + 8.0 * U) {
            assert_eq!((wide(*n), n.w), (DVec3::ZERO, 1.0), "at {input:?}");
        }
    }
}

/// Checks discrete refraction: straight on, and by Snell's law at the plane of ∇n if the index has changed by more than a threshold.
#[test]
fn snell_steps() {
    const THRESHOLD: f64 = 0.02;
    let mut random = Random::new(34);
    let inputs: Vec<[Vec4; 2]> = vectors(&mut random, 6000, 0.05, 1.2 * RADIUS)
        .iter()
        .map(|d| [(CENTER.as_vec3() + *d).extend(random.log(1e-3, 0.1) as f32), random.vector(0.9, 1.15).extend(0.0)])
        .collect();
    let probe = with_medium(&[
        "segment/ray",
        "state/loops",
        "law/phase_space",
        "medium/explosion",
        "medium/fractal_noise",
        "method/step/snell",
    ])
    .bind("snell", [vec![("threshold", Float(THRESHOLD))]]);
    let body =
        "let next = step_ray(Phase(p0.xyz, p1.xyz), p0.w); put(0u, vec4f(next[0], 0.0)); put(1u, vec4f(next[1], 0.0));";
    let (mut places, mut velocities) = (Errors::of("snell's places"), Errors::of("snell's velocities"));
    let (mut bent, mut reflected, mut straight, mut open) = (0, 0, 0, 0);
    for (input, output) in inputs.iter().zip(&probe.run::<2, 2>(&gpu(), body, &inputs)) {
        let (v, h) = (wide(input[1]), f64::from(input[0].w));
        let x = wide(input[0]) + h * v;
        places.check3(output[0], x, 3.0 * U * (x.length() + h), input);
        let (n, slope) = (index(x), gradient(x));
        let r = (x - CENTER).length();
        // The position has two more roundings than in `index_and_gradient`.
        let (value_bound, slope_bound) = (2.0 * bounds(r).0, 2.0 * bounds(r).1);
        let changed = (n - v.length()).abs() - THRESHOLD;
        let steep = slope.length();
        let normal = slope / steep;
        let along = v.dot(normal);
        let through2 = n * n - (v - along * normal).length_squared();
        let turned = slope_bound / steep;
        // Rounding decides whether to bend, whether the ray is reflected, its direction, or the gradient is too small for a plane.
        if r > RADIUS || changed < -2.0 * value_bound {
            straight += 1;
            if r > RADIUS * 1.000_01 || changed < -2.0 * value_bound {
                assert_eq!(output[1].truncate(), input[1].truncate(), "straight on, at {input:?}");
            }
            continue;
        }
        if changed < 2.0 * value_bound || turned > 1e-2 || through2.abs() < 0.02 || along.abs() < 4.0 * turned {
            open += 1;
            continue;
        }
        let across = v - along * normal;
        let want =
            if through2 > 0.0 { across + along.signum() * through2.sqrt() * normal } else { across - along * normal };
        if through2 > 0.0 {
            bent += 1;
        } else {
            reflected += 1;
        }
        // The normal turns by that angle, which changes the new component along it in proportion to its inverse.
        let bound = 4.0 * (turned + value_bound) * (1.0 + 1.0 / through2.abs().sqrt()) + 16.0 * U;
        velocities.check3(output[1], want, bound, input);
    }
    println!("snell: {bent} bent, {reflected} reflected, {straight} straight, {open} for rounding to decide");
    assert!(bent > 1500 && reflected > 20 && straight > 300 && open < inputs.len() / 5);
    places.report();
    velocities.report();
}
