//! Tests the elementary functions of `real/f64.wgsl` against those of the standard library, which err by less than one unit
//! in the last place (2.2e-16 of the result).
//!
//! Each bound is the sum of one rounding of the last operation (1.1e-16), the
//! rounding of the last term added, and the error of the standard library.

use glam::Vec4;

use super::Random;
use super::reals::{REALS, answers, joined, scale_of, split, times};
use crate::support::{gpu, probe::Probe};

fn functions() -> Probe {
    Probe::new(&["real/f64"])
}

/// The largest error, and its location.
struct Worst {
    what: &'static str,
    error: f64,
    at: String,
}

impl Worst {
    fn of(what: &'static str) -> Self {
        Self { what, error: 0.0, at: String::new() }
    }

    fn see(&mut self, error: f64, at: impl FnOnce() -> String) {
        // NaN is the largest error, and remains so.
        if error > self.error || error.is_nan() {
            (self.error, self.at) = (error, at());
        }
    }

    fn report(&self, bound: f64) {
        println!("{}: error at most {:.2e}, allowed {bound:.0e}", self.what, self.error);
        assert!(self.error <= bound, "{}: {:e} at {}", self.what, self.error, self.at);
    }
}

/// Evaluates a function of one number at each of the inputs, as (input, answer, expected answer). Both answers are scaled
/// by the same power of two to fit into f32.
fn at_each(call: &str, inputs: &[f64], wanted: impl Fn(f64) -> f64) -> Vec<(f64, f64, f64)> {
    let scales: Vec<f32> = inputs.iter().map(|x| scale_of(wanted(*x))).collect();
    let rows: Vec<[Vec4; 2]> = inputs.iter().zip(&scales).map(|(x, s)| [split(*x), Vec4::splat(*s)]).collect();
    let body = format!("put_real(0u, times({call}, p1.x));");
    let out = answers::<2, 1>(functions(), &gpu(), &body, &rows);
    let want = |(x, s): (&f64, &f32)| (*x, times(wanted(*x), *s));
    inputs.iter().zip(&scales).map(want).zip(out).map(|((x, want), [got])| (x, got, want)).collect()
}

/// Relative: 1 + (r + r² p) rounds to 1.1e-16 of a result of at least 0.7, and the term added to 1 rounds to half of that.
#[test]
fn exp_in_64_bits() {
    let mut random = Random::new(3);
    let mut inputs: Vec<f64> = (0..20_000).map(|_| random.within(-700.0, 700.0)).collect();
    inputs.extend((0..2000).map(|_| random.log(1e-300, 1.0) * (random.unit() - 0.5).signum()));
    // The borders between powers of two, and their neighbors.
    for k in -1000..1000 {
        let border = (f64::from(k) + 0.5) * std::f64::consts::LN_2;
        inputs.extend([border.next_down(), border, border.next_up()]);
    }
    inputs.extend([0.0, -0.0, 1.0, -1.0, 700.0, -700.0]);
    let mut worst = Worst::of("exp");
    for (x, got, want) in at_each("real_exp(real(p0))", &inputs, f64::exp) {
        worst.see((got - want).abs() / want, || format!("{x:e}"));
    }
    worst.report(4e-16);
}

/// Results outside the range of f64 are infinity and 0.
#[test]
fn exp_overflows_and_underflows() {
    let inputs = [709.7, 709.9, 720.0, 750.0, 1e5, 1e300, f64::INFINITY, -746.0, -1e4, -1e300, f64::NEG_INFINITY];
    let rows: Vec<[Vec4; 1]> = inputs.iter().map(|x| [split(*x)]).collect();
    // There are two factors, because 2⁻¹⁰²⁴ is not normal.
    let body =
        "put_real(0u, times(times(real_exp(real(p0)), 1.0 / 18446744073709551616.0), 1.0 / 18446744073709551616.0));";
    let out = answers::<1, 1>(functions(), &gpu(), body, &rows);
    for (x, [got]) in inputs.iter().zip(&out) {
        let want = x.exp() * 2.0_f64.powi(-1000) * 2.0_f64.powi(-24);
        assert!(*got == want || (got - want).abs() <= 4e-16 * want, "exp({x:e}) is {got:e} · 2¹⁰²⁴, not {want:e}");
    }
}

/// Relative, also where x is near 1 and ln x near 0.
#[test]
fn log_in_64_bits() {
    let mut random = Random::new(4);
    let mut inputs: Vec<f64> = (0..20_000).map(|_| random.log(1e-307, 1e308)).collect();
    inputs.extend((0..5000).map(|_| 1.0 + random.log(1e-16, 0.5) * (random.unit() - 0.5).signum()));
    for k in -1021..1024 {
        let power = 2.0_f64.powi(k);
        let border = std::f64::consts::SQRT_2 * power;
        inputs.extend([power.next_down(), power, power.next_up(), border.next_down(), border, border.next_up()]);
    }
    // Beyond these numbers the exponent is brought into the range of f32.
    for border in
        [1.329_227_995_784_916e36, 7.523_163_845_262_64e-37, 2.348_542_582_773_833_2e108, 4.257_959_840_008_151e-109]
    {
        inputs.extend([f64::next_down(border), border, f64::next_up(border)]);
    }
    inputs.extend([f64::MAX, std::f64::consts::E]);
    inputs.retain(|x| x.is_normal());
    let mut worst = Worst::of("log");
    for (x, got, want) in at_each("real_log(real(p0))", &inputs, f64::ln) {
        worst.see(if want == 0.0 { got.abs() } else { (got - want).abs() / want.abs() }, || format!("{x:e}"));
    }
    worst.report(4e-16);
    // The logarithm of 0 is so low that real_exp gives 0.
    let [(_, got, _)] = at_each("real_log(real(p0))", &[0.0], |_| 1.0)[..] else { panic!("one answer") };
    assert!(got < -745.2, "ln 0 is {got}");
}

/// Absolute: the sum of r and its series rounds to at most 1.1e-16, and the sum of the series to a fifth of that.
#[test]
fn sines_and_cosines_in_64_bits() {
    let mut random = Random::new(5);
    let mut inputs: Vec<f64> = (0..20_000).map(|_| random.within(-1000.0, 1000.0)).collect();
    inputs.extend((0..5000).map(|_| random.within(-1e6, 1e6)));
    inputs.extend((0..1000).map(|_| random.log(1e-300, 1e-3)));
    // Zeros of both functions, and the borders between quarters.
    for k in -1000..1000 {
        let angle = f64::from(k) * std::f64::consts::FRAC_PI_4;
        inputs.extend([angle.next_down(), angle, angle.next_up()]);
    }
    let rows: Vec<[Vec4; 1]> = inputs.iter().map(|x| [split(*x)]).collect();
    let body = "let both = real_sin_cos(real(p0));
        put_real(0u, both.x);
        put_real(1u, both.y);";
    let out = answers::<1, 2>(functions(), &gpu(), body, &rows);
    let (mut sines, mut cosines) = (Worst::of("sin"), Worst::of("cos"));
    for (a, [sine, cosine]) in inputs.iter().zip(&out) {
        sines.see((sine - a.sin()).abs(), || format!("{a:e}"));
        cosines.see((cosine - a.cos()).abs(), || format!("{a:e}"));
    }
    sines.report(3e-16);
    cosines.report(3e-16);
}

/// Absolute, for angles up to π (4.4e-16 in the last place).
#[test]
fn arc_tangent_in_64_bits() {
    let mut random = Random::new(6);
    let mut inputs = Vec::new();
    for _ in 0..20_000 {
        let (y, x) = random.within(-std::f64::consts::PI, std::f64::consts::PI).sin_cos();
        let size = random.log(1e-300, 1e300);
        inputs.push([size * y, size * x]);
        // Components of very different sizes, and the borders between the intervals of octants.
        inputs.push([y * random.log(1e-300, 1e300), x * random.log(1e-300, 1e300)]);
        let slope = [2.0_f64.sqrt() - 1.0, 1.0, 2.0_f64.sqrt() + 1.0][(random.unit() * 3.0) as usize];
        inputs.push([slope * random.within(1.0 - 1e-14, 1.0 + 1e-14) * y.signum(), x.signum()]);
    }
    for y in [-1e300, -1.0, -1e-300, -0.0, 0.0, 1e-300, 1.0, 1e300] {
        inputs.extend([-1e300, -1.0, -1e-300, -0.0, 0.0, 1e-300, 1.0, 1e300].map(|x| [y, x]));
    }
    let rows: Vec<[Vec4; 2]> = inputs.iter().map(|pair| pair.map(split)).collect();
    let out = answers::<2, 1>(functions(), &gpu(), "put_real(0u, arc_tangent(real(p0), real(p1)));", &rows);
    let mut worst = Worst::of("atan2");
    for ([y, x], [angle]) in inputs.iter().zip(&out) {
        // −0 counts as 0: both ends of the branch cut are the same direction, and (0, 0) has the angle 0.
        let want = if *x == 0.0 && *y == 0.0 { 0.0 } else { (y + 0.0).atan2(*x) };
        worst.see((angle - want).abs(), || format!("({y:e}, {x:e})"));
    }
    worst.report(5e-16);
}

/// Conversion to and from 64 bits in the probe is lossless.
#[test]
fn numbers_of_64_bits_pass_whole() {
    let mut random = Random::new(8);
    let mut inputs: Vec<f64> = (0..5000).map(|_| random.log(1e-300, 1e300) * (random.unit() - 0.5).signum()).collect();
    inputs.extend([0.0, 1.0, -1.0, std::f64::consts::PI, f64::MAX, 1.0_f64.next_down(), 1.0_f64.next_up()]);
    for (x, got, want) in at_each("real(p0)", &inputs, |x| x) {
        assert_eq!(got, want, "{x:e}");
    }
    let host: Vec<f64> = inputs.iter().map(|x| joined(split(*x))).collect();
    assert!(inputs.iter().zip(host).all(|(x, y)| times(*x, scale_of(*x)) == y));
}

/// Numbers outside the range of f32 count as infinite, and every number inside it as finite.
#[test]
fn finite_in_64_bits_ends_where_f32_does() {
    // Halfway from the largest number of f32 to the next power of two, where rounding down to it ends.
    let border = 3.402_823_567_797_336_6e38;
    let cases = [(0.0, true), (1e-300, true), (-3.4e38, true), (f64::next_down(border), true), (border, false)];
    let more = [(1e39, false), (-1e300, false), (f64::MAX, false), (f64::INFINITY, false), (f64::NEG_INFINITY, false)];
    let cases: Vec<(f64, bool)> = cases.into_iter().chain(more).collect();
    let rows: Vec<[Vec4; 1]> = cases.iter().map(|(x, _)| [split(*x)]).collect();
    let body = "let a = real(p0);
        put(0u, vec4f(f32(finite(Real3(a, 1.0, 2.0))), f32(finite(Real3(1.0, a, 2.0))), f32(finite(Real3(1.0, 2.0, a))), 0.0));";
    let out = functions().stub(REALS).run::<1, 1>(&gpu(), body, &rows);
    for ((x, finite), [row]) in cases.iter().zip(&out) {
        assert_eq!(row.truncate(), glam::Vec3::splat(f32::from(*finite)), "{x:e}");
    }
}
