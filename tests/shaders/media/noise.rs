//! Tests the noise of T §2.4: 21 Catmull–Rom splines per octave, each in Hermite form.

use glam::DVec3;

use super::{BOUND, Case, Want};

const CENTER: DVec3 = DVec3::new(0.5, -0.25, 1.0);
const N0: f64 = 1.5;
const AMPLITUDE: f64 = 0.25;
const FREQUENCY: f64 = 1.5;
const OCTAVES: i32 = 3;
const SEED: u32 = 77;
/// The four points of a spline along an axis, relative to the one below.
const NEIGHBOURS: [i64; 4] = [-1, 0, 1, 2];

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

/// Returns the spline between the second and the third of four values, with the slopes of chords, or its derivative.
fn spline(p: [f64; 4], t: f64, derivative: bool) -> f64 {
    let (from, to) = (0.5 * (p[2] - p[0]), 0.5 * (p[3] - p[1]));
    if derivative {
        (6.0 * t * t - 6.0 * t) * (p[1] - p[2]) + (3.0 * t * t - 4.0 * t + 1.0) * from + (3.0 * t * t - 2.0 * t) * to
    } else {
        let rest = 1.0 - t;
        (1.0 + 2.0 * t) * rest * rest * p[1]
            + t * rest * rest * from
            + t * t * (3.0 - 2.0 * t) * p[2]
            + t * t * (t - 1.0) * to
    }
}

/// Returns one octave, or its derivative along an axis.
fn octave(p: DVec3, along: Option<usize>) -> f64 {
    let base = p.floor();
    let t = p - base;
    let at = |i: usize, j: usize, k: usize| {
        let place = base.to_array().map(|x| x as i64);
        corner([place[0] + NEIGHBOURS[i], place[1] + NEIGHBOURS[j], place[2] + NEIGHBOURS[k]])
    };
    let layers = std::array::from_fn(|k| {
        let rows = std::array::from_fn(|j| spline(std::array::from_fn(|i| at(i, j, k)), t.x, along == Some(0)));
        spline(rows, t.y, along == Some(1))
    });
    spline(layers, t.z, along == Some(2))
}

fn want(x: DVec3, u: f64) -> Want {
    let d = x - CENTER;
    let (mut n, mut slope) = (N0, DVec3::ZERO);
    let (mut n_error, mut slope_error) = (2.0 * u * N0, 0.0);
    for j in 0..OCTAVES {
        let (frequency, weight) = (FREQUENCY * 2.0_f64.powi(j), AMPLITUDE * 0.5_f64.powi(j));
        let p = frequency * d;
        // x − c and the product are rounded, and so is each component.
        let moved = 2.0 * u * p.length();
        n += weight * octave(p, None);
        slope += weight * frequency * DVec3::from_array([0, 1, 2].map(|axis| octave(p, Some(axis))));
        n_error += weight * (8.2 * moved + 90.0 * u);
        slope_error += weight * frequency * (42.0 * moved + 220.0 * u);
    }
    let length = 0.25 / FREQUENCY;
    let pull_error = n * slope_error + slope.length() * n_error + 4.0 * u * n * slope.length();
    Want { n: (n, n_error), pull: (n * slope, pull_error), length: (length, 2.0 * u * length) }
}

#[test]
fn noise() {
    let case = Case {
        name: "noise",
        parts: &["medium/noise", "medium/fractal_noise"],
        index: "{ kind = \"noise\", center = [0.5, -0.25, 1], n0 = 1.5, amplitude = 0.25, frequency = 1.5, octaves = 3, \
                seed = 77 }",
        center: CENTER,
        reach: [1e-6, 50.0],
        regular: true,
        want,
        undecided: |_, _| false,
    };
    case.check();
    // Second derivatives jump at the faces of cells.
    case.pull_is_the_slope(1e-3);
}

#[test]
fn textured() {
    let case = Case {
        name: "textured",
        parts: &["medium/textured", "medium/fractal_noise"],
        index: "{ kind = \"textured\", center = [0.5, -0.25, 1], n = 1.5, amplitude = 0.25, frequency = 1.5, octaves = 3, \
                seed = 77 }",
        center: CENTER,
        reach: [1e-6, 50.0],
        regular: true,
        want: |x, u| Want { pull: (DVec3::ZERO, 0.0), length: (BOUND, 0.0), ..want(x, u) },
        undecided: |_, _| false,
    };
    case.check();
}

/// Charts of noise have a separate implementation, along one axis of the lattice.
#[test]
fn charts_show_the_same_noise() {
    for i in -40..40 {
        let x = 0.37 * f64::from(i);
        let expected: f64 = (0..4).map(|j| 0.5_f64.powi(j) * octave(DVec3::X * x * 2.0_f64.powi(j), None)).sum();
        let found = bentray::chart::noise_sum(x, 4, SEED);
        assert!((found - expected).abs() < 1e-13, "{x}: {found} for {expected}");
    }
}

/// The spline reaches its points along every axis, and the sum never exceeds its bound.
#[test]
fn noise_overshoots_by_no_more_than_is_reckoned_with() {
    let reached = spline([-1.0, 1.0, 1.0, -1.0], 0.5, false);
    assert_eq!(reached.powi(3), bentray::model::medium::Noise::reach(1));
    assert_eq!(bentray::model::medium::Noise::reach(3), 1.75 * reached.powi(3));
    for k in 0..=1000 {
        let t = f64::from(k) / 1000.0;
        let weights = [0, 1, 2, 3].map(|i| spline(std::array::from_fn(|j| f64::from(u8::from(i == j))), t, false));
        assert!(weights.iter().map(|w| w.abs()).sum::<f64>() <= reached + 1e-15, "at {t}");
    }
}
