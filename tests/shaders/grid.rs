//! The spline through a grid's samples, compared with Hermite cubics through the same points, axis by axis.

use bentray::model::Value::{Uint4, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::reals::{REALS, U64, joined, joined3, split};
use super::{Errors, Random, U, wide};
use crate::support::{gpu, probe::Probe};

const SIZE: [i32; 3] = [7, 5, 2];
const ORIGIN: DVec3 = DVec3::new(-1.0, 0.5, 2.0);
const CELL: DVec3 = DVec3::new(0.25, 0.5, 2.0);

fn samples() -> Vec<f32> {
    let mut random = Random::new(71);
    (0..SIZE.iter().product::<i32>()).map(|_| random.within(1.0, 2.0) as f32).collect()
}

/// The samples of another grid come before those of this one.
fn probe(real: &str) -> Probe {
    let before = [7.0_f32; 11];
    let all: Vec<u32> = before.iter().chain(&samples()).map(|n| n.to_bits()).collect();
    let size = Uint4([SIZE[0] as u32, SIZE[1] as u32, SIZE[2] as u32, before.len() as u32]);
    Probe::new(&["state/loops", "medium/grid", "medium/finite", "surface/region_none", real])
        .list("media", "MEDIA_COUNT", [vec![("origin", V3(ORIGIN)), ("cell", V3(CELL)), ("size", size)]])
        .numbers("index_samples", &all)
}

/// Returns the cubic through b and c, with the slopes of the neighbors' chords there: the value at t and the slope.
fn hermite([a, b, c, d]: [f64; 4], t: f64) -> [f64; 2] {
    let (m, n) = ((c - a) / 2.0, (d - b) / 2.0);
    let value = (2.0 * t.powi(3) - 3.0 * t * t + 1.0) * b
        + (t.powi(3) - 2.0 * t * t + t) * m
        + (3.0 * t * t - 2.0 * t.powi(3)) * c
        + (t.powi(3) - t * t) * n;
    let slope = 6.0 * (t * t - t) * (b - c) + (3.0 * t * t - 4.0 * t + 1.0) * m + (3.0 * t * t - 2.0 * t) * n;
    [value, slope]
}

/// Returns the gradient and the value; `along` is the axis of a slope, or 3 for the value.
fn spline(samples: &[f32], x: DVec3) -> (DVec3, f64) {
    let p = (x - ORIGIN) / CELL;
    let inside: [f64; 3] = std::array::from_fn(|k| p[k].clamp(0.0, f64::from(SIZE[k] - 1)));
    let base: [i32; 3] = std::array::from_fn(|k| (inside[k].floor() as i32).min(SIZE[k] - 2));
    let t: [f64; 3] = std::array::from_fn(|k| inside[k] - f64::from(base[k]));
    let at = |i: i32, j: i32, k: i32| {
        let place = [i, j, k].map(|i| i - 1);
        let [i, j, k] = std::array::from_fn(|a| (base[a] + place[a]).clamp(0, SIZE[a] - 1));
        f64::from(samples[(i + SIZE[0] * (j + SIZE[1] * k)) as usize])
    };
    let result = |along: usize| {
        let pick = |axis: usize, values: [f64; 4]| hermite(values, t[axis])[usize::from(along == axis)];
        let four = |of: &dyn Fn(i32) -> f64| [of(0), of(1), of(2), of(3)];
        pick(2, four(&|k| pick(1, four(&|j| pick(0, four(&|i| at(i, j, k)))))))
    };
    let slope: [f64; 3] = std::array::from_fn(|k| if inside[k] == p[k] { result(k) / CELL[k] } else { 0.0 });
    (DVec3::from_array(slope), result(3))
}

/// Positions inside, on grid points, at the border and beyond.
fn places(seed: u64) -> Vec<DVec3> {
    let mut random = Random::new(seed);
    let steps = DVec3::from_array(SIZE.map(|n| f64::from(n - 1)));
    let mut all: Vec<DVec3> = (0..3000)
        .map(|_| ORIGIN + CELL * steps * DVec3::from_array([0; 3].map(|_| random.within(-0.2, 1.2))))
        .collect();
    for corner in 0..8_u8 {
        let bit = |k: u8| f64::from((corner >> k) & 1);
        all.push(ORIGIN + CELL * steps * DVec3::new(bit(0), bit(1), bit(2)));
        all.push(ORIGIN + CELL * DVec3::new(2.0 * bit(0), 3.0 * bit(1), bit(2)));
    }
    all
}

/// Returns bounds on the errors of value and gradient (times the cell). Per axis the absolute weights sum to 1.25, their slopes to 2
/// and second derivatives to 10, for samples up to 2; each has about 24 roundings; a position errs by 4 U of its coordinates in cells.
fn bounds(x: DVec3, u: f64) -> (f64, f64) {
    let moved = 4.0 * u * ((x.abs() + ORIGIN.abs()) / CELL + DVec3::splat(7.0)).max_element();
    let (weights, slopes) = (2.0 * 1.25_f64.powi(3), 2.0 * 2.0 * 1.25 * 1.25);
    (24.0 * u * weights + 3.0 * moved * slopes, 24.0 * u * slopes + moved * 2.0 * (10.0 * 1.5625 + 2.0 * 4.0 * 1.25))
}

/// Returns `true` if a border or a face of a cell is within the rounding error.
fn at_face(x: DVec3, u: f64) -> bool {
    let p = (x - ORIGIN) / CELL;
    (p - p.round()).abs().min_element() < 64.0 * u * (x.abs() / CELL).max_element() && x != x.as_vec3().as_dvec3()
}

#[test]
fn splines_go_through_their_samples() {
    let inputs: Vec<[Vec4; 1]> = places(72).iter().map(|x| [x.as_vec3().extend(0.0)]).collect();
    let body = "put(0u, index_spline(p0.xyz)); put(1u, vec4f(medium_pull(p0.xyz), medium_index(p0.xyz)));
        put(2u, vec4f(medium_length(p0.xyz)));";
    let out = probe("real/f32").run::<1, 3>(&gpu(), body, &inputs);
    let samples = samples();
    let names = ["grid index", "grid gradient", "grid pull"];
    let [mut values, mut slopes, mut pulls] = names.map(Errors::of);
    let mut beyond = 0;
    for (input, rows) in inputs.iter().zip(&out) {
        let x = wide(input[0]);
        let (slope, n) = spline(&samples, x);
        let (value_bound, slope_bound) = bounds(x, U);
        values.check(rows[0].w, n, value_bound, input);
        for k in 0..3 {
            slopes.check(rows[0][k], slope[k], slope_bound / CELL[k], input);
            pulls.check(rows[1][k], n * slope[k], 3.0 * slope_bound / CELL[k] + value_bound * slope[k].abs(), input);
        }
        assert_eq!((rows[1].w, rows[2].x), (rows[0].w, 0.25), "at {input:?}");
        beyond += usize::from(slope.min_element().abs().min(slope.max_element().abs()) == 0.0);
    }
    assert!(beyond > 300, "{beyond} positions are beyond the border");
    for errors in [values, slopes, pulls] {
        errors.report();
    }
    // At grid points the value is the sample.
    let (last, first) = (samples[samples.len() - 1], samples[0]);
    let count = inputs.len();
    assert_eq!((out[count - 16][0].w, out[count - 2][0].w), (first, last), "the corners");
}

#[test]
fn splines_in_64_bits() {
    let mut places = places(73);
    places.retain(|x| !at_face(*x, U64));
    let inputs: Vec<[Vec4; 3]> = places.iter().map(|x| x.to_array().map(split)).collect();
    let body = "let n = index_spline(Real3(real(p0), real(p1), real(p2)));
        put_real3(0u, n.xyz);
        put_real(3u, n.w);";
    let out = probe("real/f64").stub(REALS).run::<3, 4>(&gpu(), body, &inputs);
    let samples = samples();
    let mut worst = 0.0_f64;
    for (x, rows) in places.iter().zip(&out) {
        let (slope, n) = spline(&samples, *x);
        let (value_bound, slope_bound) = bounds(*x, U64);
        let off = ((joined3(rows) - slope) * CELL).abs().max_element();
        worst = worst.max((joined(rows[3]) - n).abs() / value_bound).max(off / slope_bound);
        assert!(worst <= 1.0, "at {x}: {rows:?}, not {slope}, {n}");
    }
    println!("grid in 64 bits: {worst:.2} of its bound");
}
