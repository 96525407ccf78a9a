//! Tests step control by doubling: the effect of each rule on a step and on the next one, and the last step under every
//! control.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::schemes::{Phase, euler, path_rate, rk4};
use super::{Errors, Random, U, row, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

/// A ray with tau, h, and counts 3, 10, 20; the result of the control, and the same step retaken.
pub const CONTROL: &str = "let ray = Ray(Phase(p0.xyz, p1.xyz), p0.w, 0.0, Memory(p1.w), 9.0, 3u, 10u, 20u, ALIVE);
    let next = accepted_step(ray);
    let again = retaken_step(ray.phase, next.taken);
    put(0u, vec4f(next.phase[0], next.tau));
    put(1u, vec4f(next.phase[1], next.memory.h));
    put(2u, vec4f(next.taken, f32(next.index), f32(next.steps), f32(next.rejected)));
    put(3u, vec4f(again[0], first_step(ray.phase)));
    put(4u, vec4f(again[1], f32(next.status)));";

const TOLERANCE: f64 = 1e-3;
const GROW_BELOW: f64 = 1e-4;
pub const ETA: f64 = 0.5;

pub fn probe(step: &str, control: &[&str], is_limited: bool, values: Record) -> Probe {
    let law = vec![("center", V3(DVec3::ZERO)), ("mass", Float(1.0))];
    let mut parts = vec!["segment/ray", "state/loops", "law/phase_space", "law/schwarzschild_path", "law/limit", step];
    parts.extend(control);
    let probe = Probe::new(&parts).bind("law", [law]).bind("control", [values]);
    let probe = probe.bind("limit", [vec![("length", Float(10.0))]]);
    if is_limited { probe.with("IS_LIMITED") } else { probe }
}

fn doubling() -> Record {
    vec![("tolerance", Float(TOLERANCE)), ("grow_below", Float(GROW_BELOW)), ("eta", Float(ETA))]
}

/// Returns rays around a black hole, with first step sizes from tiny to above the cap.
pub fn rays(seed: u64) -> Vec<[Vec4; 2]> {
    let mut random = Random::new(seed);
    (0..3000)
        .map(|_| {
            let x = random.vector(2.5, 30.0);
            let v = random.vector(1.0, 1.0);
            let h = random.log(0.02, 2.0) as f32 * x.length();
            [row(x, random.within(0.0, 4.0) as f32), row(v, h)]
        })
        .collect()
}

type Scheme = fn(fn(Phase) -> Phase, Phase, f64) -> Phase;

/// Returns the result of two half steps, and its relative difference from that of a whole step.
fn doubled(scheme: Scheme, p: Phase, h: f64) -> (Phase, f64) {
    let whole = scheme(path_rate, p, h);
    let halves = scheme(path_rate, scheme(path_rate, p, 0.5 * h), 0.5 * h);
    let speed = p[1].length();
    let scale = p[0].length() / speed;
    (halves, ((halves[0] - whole[0]).length() / scale + (halves[1] - whole[1]).length()) / speed)
}

/// The rounding error of a measured difference, relative to x and v (steps.rs has the bound on a step; h ≤ η r).
const NOISE: f64 = 60.0 * U;

/// Checks that are common to all controls: position, path parameter, counts, and identical bits when a step is retaken.
pub struct Kept {
    ends: Errors,
    taus: Errors,
}

impl Kept {
    pub fn new() -> Self {
        Self { ends: Errors::of("accepted step"), taus: Errors::of("accepted step's tau") }
    }

    pub fn check(&mut self, input: &[Vec4; 2], output: &[Vec4; 5], end: Phase) {
        let taken = output[2].x;
        let r = f64::from(input[0].truncate().length());
        // The rounding error of a step, in which r occurs as r/2 or larger.
        self.ends.check3(output[0], end[0], NOISE * r, input);
        self.ends.check3(output[1], end[1], NOISE, input);
        self.taus.check(output[0].w, f64::from(input[0].w) + f64::from(taken), U * f64::from(output[0].w), input);
        assert_eq!((output[2].y, output[2].z, output[4].w), (3.0, 11.0, 0.0), "index, steps and status");
        assert_eq!(
            (output[0].truncate(), output[1].truncate()),
            (output[3].truncate(), output[4].truncate()),
            "retaken"
        );
    }

    pub fn report(&self) {
        self.ends.report();
        self.taus.report();
    }
}

fn capped(input: &[Vec4; 2]) -> f64 {
    f64::from(input[1].w).min(ETA * wide(input[0]).length() / wide(input[1]).length())
}

#[test]
fn the_papers_doubling() {
    let inputs = rays(62);
    let rule = ["method/control/doubling"];
    let probe = probe("method/step/euler", &rule, false, doubling()).with("KEEPS_ERRORS");
    let out = probe.run::<2, 5>(&gpu(), CONTROL, &inputs);
    let (mut kept, mut sizes) = (Kept::new(), Errors::of("sizes by the paper's doubling"));
    let (mut grown, mut shrunk, mut same, mut open) = (0, 0, 0, 0);
    for (input, output) in inputs.iter().zip(&out) {
        let p = [wide(input[0]), wide(input[1])];
        let taken = f64::from(output[2].x);
        // The first step is small, because no step is repeated.
        let first = 1e-3 * ETA * p[0].length() / p[1].length();
        sizes.check(output[2].x, capped(input), 6.0 * U * taken, input);
        sizes.check(output[3].w, first, 6.0 * U * first, input);
        let (end, error) = doubled(euler, p, taken);
        kept.check(input, output, end);
        if (error - TOLERANCE).abs() < 2.0 * NOISE || (error - GROW_BELOW).abs() < 2.0 * NOISE {
            open += 1;
            continue;
        }
        let (count, factor) = match error {
            e if e > TOLERANCE => (&mut shrunk, 0.5),
            e if e < GROW_BELOW => (&mut grown, 2.0),
            _ => (&mut same, 1.0),
        };
        *count += 1;
        assert_eq!(output[1].w, output[2].x * factor, "error {error:e} at {input:?}");
        let over = if error > TOLERANCE { 21.0 } else { 20.0 };
        assert_eq!(output[2].w, over, "accepted errors above the tolerance are counted");
    }
    println!("the paper's doubling: {grown} grow, {same} stay, {shrunk} shrink, {open} for rounding to decide");
    assert!(grown.min(shrunk).min(same) > 150 && open < 150);
    kept.report();
    sizes.report();
}

fn factor(error: f64, order: f64) -> f64 {
    (0.9 * (TOLERANCE / error).powf(1.0 / (order + 1.0))).clamp(0.2, 5.0)
}

/// Returns the rule's result in f64: the accepted size, its error, the rejected tries, and whether a try was undecidable.
fn tried(scheme: Scheme, order: f64, p: Phase, mut h: f64) -> (f64, f64, u32, bool) {
    let mut close = false;
    for rejected in 0..16 {
        let (_, error) = doubled(scheme, p, h);
        close |= (error - TOLERANCE).abs() < 2.0 * NOISE + 2e-3 * TOLERANCE;
        if error <= TOLERANCE {
            return (h, error, rejected, close);
        }
        h *= factor(error, order).min(0.9);
    }
    (0.0, f64::INFINITY, 16, close)
}

#[test]
fn doubling_that_rejects() {
    let gpu = gpu();
    let inputs = rays(63);
    let rule = ["method/control/doubling"];
    for (step, scheme, order) in [("method/step/euler", euler as Scheme, 1.0), ("method/step/rk4", rk4, 4.0)] {
        let out = probe(step, &rule, false, doubling()).run::<2, 5>(&gpu, CONTROL, &inputs);
        let (mut kept, mut sizes) = (Kept::new(), Errors::of("sizes by doubling that rejects"));
        let (mut twice, mut open) = (0, 0);
        for (input, output) in inputs.iter().zip(&out) {
            let p = [wide(input[0]), wide(input[1])];
            let taken = f64::from(output[2].x);
            let (end, error) = doubled(scheme, p, taken);
            kept.check(input, output, end);
            assert!(error <= TOLERANCE + 2.0 * NOISE, "accepted with error {error:e} at {input:?}");
            let (h, _, rejected, close) = tried(scheme, order, p, capped(input));
            if close {
                open += 1;
                continue;
            }
            twice += u32::from(rejected > 0);
            assert_eq!(output[2].w, 20.0 + rejected as f32, "rejections at {input:?}");
            // pow may err by 3e-5 of a factor (lavapipe's log), and the error that goes into it by NOISE.
            let unsure = |error: f64| 1e-4 + 2.0 * NOISE / error / (order + 1.0);
            let tries = f64::from(rejected) * unsure(TOLERANCE);
            sizes.check(output[2].x, h, (tries + 8.0 * U) * h, input);
            let next = taken * factor(error.max(1e-30), order);
            sizes.check(output[1].w, next, unsure(error) * next, input);
        }
        println!(
            "doubling that rejects with {step}: {twice} rejected first, {open} for rounding to decide, of {}",
            inputs.len()
        );
        assert!(twice > 150 && open < 150);
        kept.report();
        sizes.report();
    }
}

/// If a step gives NaN or infinity it is rejected, the ray stays in place, and the tries end.
#[test]
fn a_ray_that_no_try_moves() {
    let inputs: Vec<[Vec4; 2]> = [Vec4::new(f32::NAN, 1.0, 0.0, 0.5), Vec4::new(f32::INFINITY, 1.0, 0.0, 0.5)]
        .map(|x| [x, Vec4::new(1.0, 0.0, 0.0, 1.0)])
        .into();
    let rule = ["method/control/doubling"];
    let out = probe("method/step/rk4", &rule, false, doubling()).run::<2, 5>(&gpu(), CONTROL, &inputs);
    for (input, output) in inputs.iter().zip(&out) {
        assert_eq!(output[2], Vec4::new(0.0, 3.0, 10.0, 36.0), "taken, index, steps, rejected");
        assert_eq!(output[0].w, 0.5, "tau stays");
        assert_eq!(output[0].x.to_bits(), input[0].x.to_bits(), "x stays");
        assert_eq!(output[1].truncate(), input[1].truncate(), "v stays");
    }
}

#[test]
fn the_last_step_is_shortened_to_the_length() {
    let gpu = gpu();
    let mut inputs = rays(64);
    for (k, input) in inputs.iter_mut().enumerate() {
        input[0].w = 10.0 - (0.001 * (k + 1) as f32);
    }
    let rules: [(&[&str], Record); 3] = [
        (&["method/control/fixed"], vec![("step", Float(0.25)), ("eta", Float(ETA))]),
        (&["method/control/scaled"], vec![("eta", Float(0.25))]),
        (&["method/control/doubling"], doubling()),
    ];
    for (rule, values) in rules {
        let body =
            format!("{CONTROL} put(5u, vec4f(f32(length_reached(next.tau)), f32(length_reached(p0.w)), 0.0, 0.0));");
        let probe = probe("method/step/euler", rule, true, values).with("KEEPS_ERRORS");
        let out = probe.run::<2, 6>(&gpu, &body, &inputs);
        let mut sizes = Errors::of("sizes under a length");
        let mut shortened = 0;
        for (input, output) in inputs.iter().zip(&out) {
            let (r, left) = (wide(input[0]).length(), 10.0 - f64::from(input[0].w));
            let h = match rule[0] {
                "method/control/fixed" => 0.25,
                "method/control/scaled" => 0.25 * r / wide(input[1]).length(),
                _ => capped(input),
            };
            sizes.check(output[2].x, h.min(left), 6.0 * U * h.min(left), input);
            assert!(output[0].w <= 10.0 + 1e-6);
            let reached = h > left * (1.0 + 1e-5);
            if (h - left).abs() > 1e-5 * left {
                assert_eq!((output[5].x == 1.0, output[5].y), (reached, 0.0), "{input:?}");
                shortened += usize::from(reached);
            }
        }
        assert!(shortened > 100 && shortened < inputs.len(), "{shortened} of {}", inputs.len());
        sizes.report();
    }
}
