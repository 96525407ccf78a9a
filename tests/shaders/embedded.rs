//! Embedded pairs with their controller, compared with the rule of DOPRI5 (Hairer, Nørsett, Wanner I, §II.4 and the code) in f64.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::reals::{REALS, U64, joined, joined3};
use super::rounding::{Rough, rough_bend};
use super::schemes::{BOGACKI_SHAMPINE, DORMAND_PRINCE, Pair, rate_of};
use super::{Random, U, row, wide};
use crate::support::{gpu, probe::Probe};

const ETA: f64 = 0.5;
const LENGTH: f64 = 10.0;

/// A ray with tau and h, the error of the last step (p2.x), and the rate at its position, or p2.y if p2.z is set; the same step retaken.
const CONTROL: &str = "let phase = Phase(Real3(p0.xyz), Real3(p1.xyz));
    var rate = law_derivative(phase);
    if p2.z != 0.0 {
        rate = Phase(Real3(Real(p2.y)), Real3(Real(p2.y)));
    }
    let ray = Ray(phase, Real(p0.w), 0.0, Memory(Real(p1.w), Real(p2.x), rate), 9.0, 3u, 10u, 20u, ALIVE);
    let next = accepted_step(ray);
    let again = retaken_step(ray.phase, next.taken);
    let fresh = law_derivative(next.phase);
    put_real3(0u, next.phase[0]);
    put_real3(3u, next.phase[1]);
    put_real(6u, next.tau);
    put_real(7u, next.memory.h);
    put_real(8u, next.memory.error);
    put_real(9u, next.taken);
    put(10u, vec4f(f32(next.index), f32(next.steps), f32(next.rejected), f32(next.status)));
    let same = all(next.memory.rate[0] == fresh[0]) && all(next.memory.rate[1] == fresh[1]);
    put(11u, vec4f(f32(same), 0.0, 0.0, 0.0));
    put_real(12u, first_step(phase));
    put_real3(13u, again[0]);
    put_real3(16u, again[1]);";

type Input = [Vec4; 3];

/// The output of one accepted step; `ends` are its end, and that of the same step retaken.
struct Output {
    ends: [[DVec3; 2]; 2],
    tau: f64,
    h: f64,
    error: f64,
    taken: f64,
    rejected: f64,
    first: f64,
}

impl Output {
    fn read(rows: &[Vec4; 19]) -> Self {
        let [index, steps, rejected, status] = rows[10].to_array();
        assert!(index == 3.0 && status == 0.0 && (10.0..=11.0).contains(&steps), "{}", rows[10]);
        let out = Self {
            ends: [0, 13].map(|k| [joined3(&rows[k..k + 3]), joined3(&rows[k + 3..k + 6])]),
            tau: joined(rows[6]),
            h: joined(rows[7]),
            error: joined(rows[8]),
            taken: joined(rows[9]),
            rejected: f64::from(rejected) - 20.0,
            first: joined(rows[12]),
        };
        assert_eq!(steps - 10.0, if out.taken == 0.0 { 0.0 } else { 1.0 }, "accepted steps are counted");
        // A later pass evaluates the stored rate again, and must get identical bits.
        assert!(out.taken == 0.0 || rows[11].x == 1.0, "the rate at the end differs from the stored one");
        out
    }
}

/// The largest fraction of the tolerance in one step.
const SHARE: f64 = 0.1;

/// A pair in one precision, under a tolerance that rejects some steps and accepts most.
#[derive(Clone, Copy)]
struct Setting {
    part: &'static str,
    pair: Pair,
    order: f64,
    tolerance: f64,
    real: &'static str,
    unit: f64,
}

const SHAMPINE: Setting = Setting {
    part: "method/step/bogacki_shampine",
    pair: BOGACKI_SHAMPINE,
    order: 3.0,
    tolerance: 1e-2,
    real: "real/f32",
    unit: U,
};
const PRINCE: Setting =
    Setting { part: "method/step/dormand_prince", pair: DORMAND_PRINCE, order: 5.0, tolerance: 5e-4, ..SHAMPINE };

fn in_64_bits(setting: Setting) -> Setting {
    Setting { real: "real/f64", unit: U64, ..setting }
}

impl Setting {
    fn run(&self, is_limited: bool, inputs: &[Input]) -> Vec<Output> {
        let law = vec![("center", V3(DVec3::ZERO)), ("mass", Float(1.0))];
        let mut parts =
            vec!["segment/ray", "state/loops", "method/memory_pair", "law/phase_space", "law/schwarzschild_path"];
        parts.extend(["method/control/embedded", self.part, "method/control/embedded", "law/limit", self.real]);
        let probe = Probe::new(&parts);
        let probe = if is_limited { probe.with("IS_LIMITED") } else { probe };
        let rows = probe
            .stub(REALS)
            .bind("law", [law])
            .bind("control", [vec![("tolerance", Float(self.tolerance)), ("eta", Float(ETA))]])
            .bind("limit", [vec![("length", Float(LENGTH))]])
            .run::<3, 19>(&gpu(), CONTROL, inputs);
        rows.iter().map(Output::read).collect()
    }

    /// Returns the end of a step with bounds on its rounding errors, and its error in units of the tolerance with a bound on its own error.
    fn step(&self, input: &Input, h: f64) -> ([Rough; 2], [f64; 2]) {
        let p = [0, 1].map(|k| Rough::exact(wide(input[k]), self.unit));
        let [end, error, _] = self.pair.step(|p| rate_of(rough_bend, p), p, h);
        let (r, speed) = (p[0].value.length(), p[1].value.length());
        let scaled = |x: f64, v: f64| (x * speed / r + v) / (speed * SHARE * self.tolerance);
        let size = scaled(error[0].value.length(), error[1].value.length());
        // Lengths, scale and quotients err by 12 U, and the error is rounded to f32.
        (end, [size, scaled(error[0].bound(), error[1].bound()) + size * (12.0 * self.unit + U)])
    }

    /// Returns FAC11 of DOPRI5.
    fn factor(&self, error: f64) -> f64 {
        error.max(1e-10).powf(1.0 / self.order - 0.04 * 0.75)
    }

    /// Returns the divisor of the step size after an accepted step, if no try was rejected.
    fn pi(&self, error: f64, last: f64) -> f64 {
        (self.factor(error) / last.powf(0.04) / 0.9).clamp(1.0 / 10.0, 1.0 / 0.2)
    }

    /// Returns the error of a quotient of sizes: 1e-4 per power (lavapipe's log errs by 3e-5), and that of the error estimate.
    fn unsure(&self, [error, off]: [f64; 2]) -> f64 {
        2e-4 + off / error.max(1e-10) / self.order
    }

    /// Returns the accepted size, the number of rejected tries, the error of the size, and whether a try was undecidable.
    fn tried(&self, input: &Input, first: f64) -> (f64, f64, f64, bool) {
        let (mut h, mut slack, mut close) = (first, 8.0 * self.unit, false);
        for rejected in 0..16 {
            let [error, off] = self.step(input, h).1;
            // The error grows with some power of h near the order.
            close |= (error - 1.0).abs() < off + 2.0 * (self.order + 1.0) * slack * error;
            if error <= 1.0 {
                return (h, f64::from(rejected), slack, close);
            }
            h /= (self.factor(error) / 0.9).min(1.0 / 0.2);
            slack += self.unsure([error, off]) + slack * (self.order + 1.0) / self.order;
        }
        (0.0, 16.0, slack, close)
    }
}

/// Returns rays around a black hole, with first step sizes from tiny to above the cap, and stored errors in the range of DOPRI5.
fn inputs(seed: u64) -> Vec<Input> {
    let mut random = Random::new(seed);
    (0..3000)
        .map(|_| {
            let x = random.vector(2.5, 30.0);
            let h = random.log(0.02, 1.0) as f32 * x.length();
            let remembered = Vec4::new(random.log(1e-4, 1.0) as f32, 0.0, 0.0, 0.0);
            [row(x, random.within(0.0, 4.0) as f32), row(random.vector(0.8, 1.25), h), remembered]
        })
        .collect()
}

fn cap(input: &Input) -> f64 {
    ETA * wide(input[0]).length() / wide(input[1]).length()
}

fn close_to(got: f64, want: f64, relative: f64) -> bool {
    (got - want).abs() <= relative * want.abs()
}

/// Checks the result of an accepted step: its end and tau, the stored error, and the next size.
fn check_accepted(setting: &Setting, input: &Input, out: &Output) {
    let (end, [error, off]) = setting.step(input, out.taken);
    for (got, want) in out.ends.iter().flat_map(|of| of.iter().zip(&end)) {
        assert!((*got - want.value).length() <= want.bound(), "{got} for {} at {input:?}", want.value);
    }
    assert!(close_to(out.tau, f64::from(input[0].w) + out.taken, setting.unit), "tau at {input:?}");
    assert!(error <= 1.0 + off, "accepted with {error} of the tolerance at {input:?}");
    // The error is an f32, and so is its lower limit.
    let remembered = error.max(1e-4);
    assert!((out.error - remembered).abs() <= off + U * remembered, "{} for {remembered} at {input:?}", out.error);
    let free = out.taken / setting.pi(error, f64::from(input[2].x));
    let next = if out.rejected > 0.0 { free.min(out.taken) } else { free };
    assert!(close_to(out.h, next, setting.unsure([error, off])), "next {} for {next} at {input:?}", out.h);
}

#[test]
fn the_controller_is_dopri5s() {
    for setting in [SHAMPINE, PRINCE, in_64_bits(SHAMPINE), in_64_bits(PRINCE)] {
        let inputs = inputs(71);
        let (mut rejected, mut held, mut grown, mut open) = (0, 0, 0, 0);
        for (input, out) in inputs.iter().zip(&setting.run(false, &inputs)) {
            assert!(close_to(out.first, cap(input), 6.0 * setting.unit), "the first step is the cap");
            check_accepted(&setting, input, out);
            let first = f64::from(input[1].w).min(cap(input));
            let (h, failed, slack, close) = setting.tried(input, first);
            if close {
                open += 1;
                continue;
            }
            assert_eq!(out.rejected, failed, "rejections at {input:?}");
            assert!(close_to(out.taken, h, slack), "{} taken, not {h}, at {input:?}", out.taken);
            rejected += usize::from(failed > 0.0);
            held += usize::from(failed > 0.0 && out.h == out.taken);
            grown += usize::from(out.h > out.taken);
        }
        println!(
            "{} in {}: {rejected} rejected first, of which {held} are not let grow, {grown} grow, {open} open of {}",
            setting.part,
            setting.real,
            inputs.len()
        );
        assert!(rejected > 150 && grown > 150 && held > 10 && open < 150);
    }
}

/// A step with NaN or infinity is rejected, the ray stays in place, and the tries end: at an invalid position, where the
/// law has no rate, and for an invalid stored rate. A ray that was finite then loses its velocity and fails.
#[test]
fn a_ray_that_no_try_moves() {
    let v = Vec4::new(1.0, 0.0, 0.0, 1.0);
    let places =
        [Vec4::new(f32::NAN, 1.0, 0.0, 0.5), Vec4::new(f32::INFINITY, 1.0, 0.0, 0.5), Vec4::new(0.0, 0.0, 0.0, 0.5)];
    let mut inputs: Vec<Input> = places.map(|x| [x, v, Vec4::new(0.25, 0.0, 0.0, 0.0)]).into();
    for rate in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        inputs.push([Vec4::new(5.0, 1.0, 0.0, 0.5), v, Vec4::new(0.25, rate, 1.0, 0.0)]);
    }
    for setting in [SHAMPINE, PRINCE, in_64_bits(PRINCE)] {
        for (input, out) in inputs.iter().zip(&setting.run(false, &inputs)) {
            assert_eq!((out.taken, out.rejected, out.tau), (0.0, 16.0, 0.5), "{input:?}");
            assert_eq!((out.h, out.error), (1.0, 0.25), "the memory does not change");
            let same = |a: f64, b: f32| a == f64::from(b) || (a.is_nan() && b.is_nan());
            let velocity = out.ends[0][1];
            let kept = if input[0].is_finite() { !velocity.is_finite() } else { velocity == wide(input[1]) };
            assert!(same(out.ends[0][0].x, input[0].x) && kept, "{:?} at {input:?}", out.ends[0]);
        }
    }
}

/// The first try is not longer than the rest of the path, and later ones follow the usual rule.
#[test]
fn the_last_step_is_shortened_to_the_length() {
    let mut inputs = inputs(72);
    for (k, input) in inputs.iter_mut().enumerate() {
        input[0].w = LENGTH as f32 - 0.001 * (k + 1) as f32;
    }
    for setting in [SHAMPINE, PRINCE] {
        let (mut reached, mut open) = (0, 0);
        for (input, out) in inputs.iter().zip(&setting.run(true, &inputs)) {
            check_accepted(&setting, input, out);
            let left = LENGTH - f64::from(input[0].w);
            let (h, failed, slack, close) = setting.tried(input, f64::from(input[1].w).min(cap(input)).min(left));
            open += usize::from(close);
            assert!(close || (out.rejected == failed && close_to(out.taken, h, slack)), "{} at {input:?}", out.taken);
            reached += usize::from(out.taken == left);
        }
        assert!(reached > 300 && reached < inputs.len() - 300 && open < 150, "{reached} reached the end, {open} open");
    }
}
