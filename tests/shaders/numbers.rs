//! Tests functions of numbers: the arc tangent, the status word, finite values, and values that compilers cannot simplify.

use glam::Vec4;

use super::{Errors, Random};
use crate::support::{gpu, probe::Probe};

/// The polynomial of Cephes errs by 2e-7 on the reduced interval; the reduction adds roundings of π/4, π/2 and π (1.2e-7 at most).
const ARC_TANGENT_BOUND: f64 = 4e-7;

#[test]
fn arc_tangent_in_all_octants() {
    let mut random = Random::new(1);
    let mut inputs = Vec::new();
    for _ in 0..20_000 {
        let angle = random.within(-std::f64::consts::PI, std::f64::consts::PI);
        let size = random.log(1e-30, 1e30);
        inputs.push([(size * angle.sin()) as f32, (size * angle.cos()) as f32]);
        // Components of very different sizes, and angles near the borders between octants and between the polynomial's intervals.
        inputs.push([random.vector(1e-9, 1.0).x, random.vector(1e-9, 1.0).y]);
        let slope =
            [0.414_213_56, 1.0, 2.414_213_6][(random.unit() * 3.0) as usize] * random.within(0.999_999, 1.000_001);
        inputs.push([slope as f32 * inputs.last().unwrap()[1].signum(), 1.0]);
    }
    for y in [-1e38_f32, -1.0, -1e-37, -0.0, 0.0, 1e-37, 1.0, 1e38] {
        for x in [-1e38_f32, -1.0, -1e-37, -0.0, 0.0, 1e-37, 1.0, 1e38] {
            inputs.push([y, x]);
        }
    }
    let rows: Vec<[Vec4; 1]> = inputs.iter().map(|[y, x]| [Vec4::new(*y, *x, 0.0, 0.0)]).collect();
    let out = Probe::new(&["real/math"]).run::<1, 1>(&gpu(), "put(0u, vec4f(arc_tangent(p0.x, p0.y)));", &rows);
    let mut errors = Errors::of("arc_tangent");
    for ([y, x], [angle]) in inputs.iter().zip(&out) {
        if *x == 0.0 && *y == 0.0 {
            assert!(angle.x.is_finite(), "arc_tangent({y}, {x}) is {}", angle.x);
            continue;
        }
        // −0 counts as 0: both ends of the branch cut are the same direction.
        let want = (f64::from(*y) + 0.0).atan2(f64::from(*x));
        errors.check(angle.x, want, ARC_TANGENT_BOUND, (y, x));
    }
    errors.report();
}

#[test]
fn status_words_keep_their_parts() {
    let mut inputs = Vec::new();
    for code in 0..9_u16 {
        for slot in 0..3_u16 {
            for index in [0.0_f32, 1.0, 63.0, 64.0, 65_535.0, 65_536.0, 1_000_001.0, 16_777_215.0] {
                inputs.push([Vec4::new(code.into(), slot.into(), index, 0.0)]);
            }
        }
    }
    let body = "let word = status_word(u32(p0.x), u32(p0.y), u32(p0.z));
        put(0u, vec4f(f32(status_code(word)), f32(status_slot(word)), f32(status_index(word)), 0.0));";
    let out = Probe::new(&["segment/ray"]).run::<1, 1>(&gpu(), body, &inputs);
    for ([input], [output]) in inputs.iter().zip(&out) {
        assert_eq!(input, output);
    }
}

/// Checks numbers of f32, in both precisions.
#[test]
fn finite_sees_every_kind_of_number() {
    let finite = [0.0, -0.0, 1.0, -1e38, f32::MAX, f32::MIN_POSITIVE, 1e-40, f32::from_bits(1)];
    let others = [f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::from_bits(0x7f80_0001), f32::from_bits(0xffff_ffff)];
    let all = || finite.iter().chain(&others).copied();
    let mut inputs = Vec::new();
    for a in all() {
        inputs.extend([[Vec4::new(a, 1.0, 2.0, 0.0)], [Vec4::new(0.0, a, 2.0, 0.0)], [Vec4::new(3.0, 1.0, a, 0.0)]]);
        inputs.extend(all().map(|b| [Vec4::new(a, 0.5, b, 0.0)]));
    }
    for real in ["real/f32", "real/f64"] {
        let out = Probe::new(&["segment/ray", real]).run::<1, 1>(
            &gpu(),
            "put(0u, vec4f(f32(finite(Real3(p0.xyz)))));",
            &inputs,
        );
        for ([input], [output]) in inputs.iter().zip(&out) {
            assert_eq!(output.x == 1.0, input.is_finite(), "{real}: {input}");
        }
    }
}

/// At most two roundings of 6e-8, of the reduced angle and of the sum with its series.
pub(super) const SINE_BOUND: f64 = 1.2e-7;

/// Small angles are accurate; angles too large to be distinguished still give a point on the unit circle.
#[test]
fn sines_and_cosines() {
    let mut random = Random::new(3);
    let mut angles: Vec<f32> = (0..20_000).map(|_| random.within(-1e4, 1e4) as f32).collect();
    angles.extend((0..5000).map(|_| (random.log(1e-30, 4.0) * (random.unit() - 0.5).signum()) as f32));
    for k in -6000..6000 {
        let angle = (f64::from(k) * std::f64::consts::FRAC_PI_4) as f32;
        angles.extend([angle.next_down(), angle, angle.next_up()]);
    }
    let known = angles.len();
    angles.extend((0..1000).map(|_| (random.log(1e5, 1e38) * (random.unit() - 0.5).signum()) as f32));
    angles.extend([f32::INFINITY, f32::NEG_INFINITY, f32::NAN]);
    let rows: Vec<[Vec4; 1]> = angles.iter().map(|a| [Vec4::splat(*a)]).collect();
    let out = Probe::new(&["real/math"]).run::<1, 1>(&gpu(), "put(0u, vec4f(real_sin_cos(p0.x), 0.0, 0.0));", &rows);
    let [mut sines, mut cosines] = ["sine", "cosine"].map(Errors::of);
    for (angle, [got]) in angles.iter().zip(&out).take(known) {
        let a = f64::from(*angle);
        sines.check(got.x, a.sin(), SINE_BOUND * a.abs().min(1.0), a);
        cosines.check(got.y, a.cos(), SINE_BOUND, a);
    }
    sines.report();
    cosines.report();
    for (angle, [got]) in angles.iter().zip(&out).skip(known) {
        let off = (got.x.hypot(got.y) - 1.0).abs();
        assert!(if angle.is_finite() { off < 1e-6 } else { off.is_nan() }, "{angle:e}: {got}");
    }
}

/// Every bit is kept, including NaNs and the signs of zeros.
#[test]
fn opaque_numbers_keep_their_bits() {
    let special =
        [0.0, -0.0, f32::MAX, -f32::MIN_POSITIVE, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 1.0 + f32::EPSILON];
    let mut random = Random::new(2);
    let mut inputs: Vec<[Vec4; 1]> = special.map(|a| [Vec4::new(a, 0.75, -a, a)]).into();
    inputs.extend((0..500).map(|_| [Vec4::from_array([0, 1, 2, 3].map(|_| random.vector(1e-30, 1e30).x))]));
    let body = "put(0u, vec4f(f32(opaque(Real(p0.x))), vec3f(opaque3(Real3(p0.yzw)))));
        put(1u, vec4f(opaque4(Real4(p0))));";
    for real in ["real/f32", "real/f64"] {
        let out = Probe::new(&[real]).run::<1, 2>(&gpu(), body, &inputs);
        for ([input], rows) in inputs.iter().zip(&out) {
            // A NaN may become a different NaN on its way through 64 bits.
            let same = |a: f32| if a.is_nan() && real == "real/f64" { f32::NAN } else { a };
            let bits = |row: &Vec4| row.to_array().map(|a| same(a).to_bits());
            assert_eq!([bits(&rows[0]), bits(&rows[1])], [bits(input); 2], "{real}");
        }
    }
}
