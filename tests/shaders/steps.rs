//! One step of each method.

use bentray::gpu::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::laws::flow;
use super::{Errors, Random, U, row, wide};
use crate::support::{gpu, probe::Probe};

pub type Phase = [DVec3; 2];

pub fn plus(p: Phase, h: f64, k: Phase) -> Phase {
    [p[0] + h * k[0], p[1] + h * k[1]]
}

/// Schwarzschild's path form about 0, M = 1.
pub fn path_rate(p: Phase) -> Phase {
    let l = p[0].cross(p[1]);
    [p[1], -3.0 * l.length_squared() / p[0].length().powi(5) * p[0]]
}

fn lorenz_rate(p: Phase) -> Phase {
    let x = p[0];
    let beta = f64::from(8.0_f32 / 3.0);
    [DVec3::new(10.0 * (x.y - x.x), 28.0 * x.x - x.y - x.x * x.z, x.x * x.y - beta * x.z), DVec3::ZERO]
}

pub fn euler(rate: fn(Phase) -> Phase, p: Phase, h: f64) -> Phase {
    plus(p, h, rate(p))
}

pub fn rk4(rate: fn(Phase) -> Phase, p: Phase, h: f64) -> Phase {
    let k1 = rate(p);
    let k2 = rate(plus(p, 0.5 * h, k1));
    let k3 = rate(plus(p, 0.5 * h, k2));
    let k4 = rate(plus(p, h, k3));
    [0, 1].map(|i| p[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

const STEP: &str = "let next = step_ray(Phase(p0.xyz, p1.xyz), p0.w);
    put(0u, vec4f(next[0], 0.0));
    put(1u, vec4f(next[1], 0.0));";

fn hole(step: &str) -> Probe {
    let law = vec![("center", V3(DVec3::ZERO)), ("mass", Float(1.0))];
    Probe::new(&["ray", "phase/space", "law/schwarzschild_path", step]).bind("law", [law])
}

fn phase(input: &[Vec4; 2]) -> Phase {
    [wide(input[0]), wide(input[1])]
}

#[test]
fn one_step_of_each_scheme() {
    let gpu = gpu();
    let mut random = Random::new(51);
    let inputs: Vec<[Vec4; 2]> = (0..3000)
        .map(|_| {
            let x = random.vector(2.0, 100.0);
            let h = random.log(1e-3, 0.4) as f32 * x.length();
            [row(x, h), row(random.vector(1.0, 1.0), 0.0)]
        })
        .collect();
    for (step, scheme) in [("step/euler", euler as fn(fn(Phase) -> Phase, Phase, f64) -> Phase), ("step/rk4", rk4)] {
        let out = hole(step).run::<2, 2>(&gpu, STEP, &inputs);
        let mut errors = Errors::of(step);
        for (input, output) in inputs.iter().zip(&out) {
            let (p, h) = (phase(input), f64::from(input[0].w));
            let want = scheme(path_rate, p, h);
            // Each evaluation errs by 40 U of 3 |v|²/r² (see the law), at a place off by U r; a step adds h times that, over
            // a stretch in which, as h ≤ 0.4 r and |v| = 1, r falls to no less than half.
            let r = p[0].length();
            let rate = 60.0 * U * 3.0 / (0.5 * r).powi(2);
            errors.check3(output[0], want[0], 4.0 * U * (r + h) + h * h * rate, input);
            errors.check3(output[1], want[1], 4.0 * U + h * rate, input);
        }
        errors.report();
    }
}

/// The state after h by many tiny steps.
fn exact(rate: fn(Phase) -> Phase, start: Phase, h: f64) -> Phase {
    (0..400).fold(start, |p, _| rk4(rate, p, h / 400.0))
}

/// RK4's local error falls as h⁵ and Euler's as h², in f32, over sizes where truncation stays above rounding.
#[test]
fn local_errors_fall_as_their_order_says() {
    let gpu = gpu();
    let mut random = Random::new(52);
    let sizes = [0.02_f64, 0.01];
    let starts: Vec<Vec4> = (0..200).map(|_| row(random.vector(8.0, 20.0), 0.0)).collect();
    for (step, order, factor) in [("step/euler", 1, 0.25), ("step/rk4", 4, 1.0)] {
        let law = flow("flow/lorenz", "law/flow");
        let probe = law.stub(bentray::program::part(step).expect("a part").text);
        let mean = sizes.map(|h| {
            let h = (h * factor) as f32;
            let inputs: Vec<[Vec4; 2]> = starts.iter().map(|x| [x.with_w(h), Vec4::ZERO]).collect();
            let out = probe.run::<2, 2>(&gpu, STEP, &inputs);
            let error = |(input, output): (&[Vec4; 2], &[Vec4; 2])| {
                (wide(output[0]) - exact(lorenz_rate, phase(input), f64::from(h))[0]).length().ln()
            };
            inputs.iter().zip(&out).map(error).sum::<f64>() / inputs.len() as f64
        });
        let observed = (mean[0] - mean[1]) / 2.0_f64.ln();
        println!("{step}: local order {observed:.2}, errors {:.1e} and {:.1e}", mean[0].exp(), mean[1].exp());
        assert!((observed - f64::from(order + 1)).abs() < 0.25, "{step}: the local error falls as h^{observed:.2}");
    }
}
