//! One step of each method.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::reals::{REALS, U64, joined3};
use super::rounding::{Rough, rough_bend};
use super::schemes::{BOGACKI_SHAMPINE, DORMAND_PRINCE, Phase, euler, leapfrog, lorenz_field, rate_of, rk4, rkn4};
use super::{Random, U, row, wide};
use crate::support::{gpu, probe::Probe};

/// The output of a step: its end, and for an embedded pair also the difference of its two results and the rate at the end.
type Steps<V> = Vec<[V; 2]>;

/// A method: its module, its form over vectors that carry their errors, the orders of its outputs, and a step size that reveals them.
struct Method {
    part: &'static str,
    rough: fn([Rough; 2], f64) -> Steps<Rough>,
    orders: &'static [f64],
    size: f64,
}

fn rough_rate(p: [Rough; 2]) -> [Rough; 2] {
    rate_of(rough_bend, p)
}

const METHODS: [Method; 6] = [
    Method { part: "method/step/euler", rough: |p, h| vec![euler(rough_rate, p, h)], orders: &[1.0], size: 1e-4 },
    Method { part: "method/step/leapfrog", rough: |p, h| vec![leapfrog(rough_bend, p, h)], orders: &[2.0], size: 4e-3 },
    Method { part: "method/step/rkn4", rough: |p, h| vec![rkn4(rough_bend, p, h)], orders: &[4.0], size: 1e-2 },
    Method { part: "method/step/rk4", rough: |p, h| vec![rk4(rough_rate, p, h)], orders: &[4.0], size: 4e-3 },
    Method {
        part: "method/step/bogacki_shampine",
        rough: |p, h| BOGACKI_SHAMPINE.step(rough_rate, p, h).to_vec(),
        orders: &[3.0, 2.0],
        size: 2e-3,
    },
    Method {
        part: "method/step/dormand_prince",
        rough: |p, h| DORMAND_PRINCE.step(rough_rate, p, h).to_vec(),
        orders: &[5.0, 4.0],
        size: 2e-3,
    },
];

impl Method {
    fn is_pair(&self) -> bool {
        self.orders.len() > 1
    }

    fn needs_acceleration(&self) -> bool {
        ["method/step/leapfrog", "method/step/rkn4"].contains(&self.part)
    }

    fn parts(&self) -> Vec<&'static str> {
        if self.is_pair() { vec!["method/control/embedded", self.part] } else { vec![self.part] }
    }

    /// Returns lines of a probe that take one step of p0.w from (p0, p1) and write its outputs.
    fn body(&self) -> &'static str {
        if self.is_pair() {
            "let p = Phase(Real3(p0.xyz), Real3(p1.xyz));
            let step = pair_step(p, law_derivative(p), Real(p0.w));
            put_real3(0u, step.end[0]);
            put_real3(3u, step.end[1]);
            put_real3(6u, step.error[0]);
            put_real3(9u, step.error[1]);
            put_real3(12u, step.rate[0]);
            put_real3(15u, step.rate[1]);"
        } else {
            "let next = step_ray(Phase(Real3(p0.xyz), Real3(p1.xyz)), Real(p0.w));
            put_real3(0u, next[0]);
            put_real3(3u, next[1]);"
        }
    }

    /// Returns the results of the device for the inputs.
    fn taken(&self, law: &Law, real: &str, inputs: &[[Vec4; 2]]) -> Vec<Steps<DVec3>> {
        let mut parts = vec!["segment/ray", "law/phase_space", real];
        parts.extend(law.parts);
        parts.extend(self.parts());
        let probe = Probe::new(&parts).bind(law.binding, [law.record.clone()]).stub(REALS);
        let of = |rows: &[Vec4]| rows.chunks(6).map(|c| [joined3(&c[..3]), joined3(&c[3..])]).collect();
        if self.is_pair() {
            probe.run::<2, 18>(&gpu(), self.body(), inputs).iter().map(|rows| of(rows)).collect()
        } else {
            probe.run::<2, 6>(&gpu(), self.body(), inputs).iter().map(|rows| of(rows)).collect()
        }
    }
}

/// The modules of a law, and the values of its binding.
struct Law {
    parts: &'static [&'static str],
    binding: &'static str,
    record: crate::support::probe::Record,
}

fn hole() -> Law {
    let record = vec![("center", V3(DVec3::ZERO)), ("mass", Float(1.0))];
    Law { parts: &["law/schwarzschild_path"], binding: "law", record }
}

fn lorenz(parts: &'static [&'static str]) -> Law {
    let record = vec![("sigma", Float(10.0)), ("rho", Float(28.0)), ("beta", Float(f64::from(8.0_f32 / 3.0)))];
    Law { parts, binding: "flow", record }
}

/// Checks that every output of every method is within its rounding error: in
/// f32, and in f64, where a wrong digit of a coefficient would be visible.
#[test]
fn one_step_of_each_method() {
    let mut random = Random::new(51);
    let inputs: Vec<[Vec4; 2]> = (0..3000)
        .map(|_| {
            let x = random.vector(2.5, 100.0);
            let h = random.log(1e-3, 0.3) as f32 * x.length();
            [row(x, h), row(random.vector(0.5, 1.5), 0.0)]
        })
        .collect();
    for method in &METHODS {
        for (real, unit) in [("real/f32", U), ("real/f64", U64)] {
            let out = method.taken(&hole(), real, &inputs);
            let (mut worst, mut at) = (0.0_f64, String::new());
            for (input, output) in inputs.iter().zip(&out) {
                let start = [0, 1].map(|k| Rough::exact(wide(input[k]), unit));
                let wanted = (method.rough)(start, f64::from(input[0].w));
                assert_eq!(wanted.len(), output.len());
                for (got, want) in output.iter().flatten().zip(wanted.iter().flatten()) {
                    let ratio = (*got - want.value).length() / want.bound();
                    // NaN remains the largest error.
                    if ratio > worst || ratio.is_nan() {
                        (worst, at) = (ratio, format!("{got} for {} at {input:?}", want.value));
                    }
                }
            }
            println!("{} in {real}: error at most {worst:.2} of its bound", method.part);
            assert!(worst <= 1.0, "{} in {real}: {worst} of its bound, {at}", method.part);
            assert!(worst > 1e-3, "{} in {real}: the bound is loose", method.part);
        }
    }
}

/// Returns the Lorenz system as a flow, and as an acceleration.
fn lorenz_rates(second_order: bool) -> (Law, fn(Phase) -> Phase) {
    if second_order {
        (lorenz(&["law/field_lorenz", "law/flow_acceleration"]), |p| [p[1], lorenz_field(p[0])])
    } else {
        (lorenz(&["law/field_lorenz", "law/flow"]), |p| [lorenz_field(p[0]), DVec3::ZERO])
    }
}

/// Returns the state after h, by many tiny steps.
fn exact(rate: fn(Phase) -> Phase, start: Phase, h: f64) -> Phase {
    (0..50).fold(start, |p, _| DORMAND_PRINCE.end(rate, p, h / 50.0))
}

/// The error of a method of order p in one step is proportional to h^(p + 1), and so is the error estimate of a pair for
/// its lower order: in f64, over sizes for which truncation is far above rounding.
#[test]
fn local_errors_fall_as_their_order_says() {
    let mut random = Random::new(52);
    let starts: Vec<[Vec4; 2]> =
        (0..200).map(|_| [row(random.vector(8.0, 20.0), 0.0), row(random.vector(1.0, 20.0), 0.0)]).collect();
    for method in &METHODS {
        let (law, rate) = lorenz_rates(method.needs_acceleration());
        let sizes = [method.size, 0.5 * method.size];
        let means = sizes.map(|h| {
            let inputs: Vec<[Vec4; 2]> = starts.iter().map(|[x, v]| [x.with_w(h as f32), *v]).collect();
            let out = method.taken(&law, "real/f64", &inputs);
            let mut sums = vec![0.0; method.orders.len()];
            for (input, output) in inputs.iter().zip(&out) {
                let end = exact(rate, [wide(input[0]), wide(input[1])], f64::from(input[0].w));
                let wrong = [output[0][0] - end[0], output[0][1] - end[1]];
                for (sum, error) in sums.iter_mut().zip([Some(wrong), output.get(1).copied()].into_iter().flatten()) {
                    *sum += (error[0].length() + error[1].length()).ln() / inputs.len() as f64;
                }
            }
            sums
        });
        for (k, order) in method.orders.iter().enumerate() {
            let observed = (means[0][k] - means[1][k]) / 2.0_f64.ln();
            let [first, second] = [0, 1].map(|i: usize| means[i][k].exp());
            println!("{}: output {k} falls as h^{observed:.2}, from {first:.1e} to {second:.1e}", method.part);
            assert!((observed - order - 1.0).abs() < 0.1, "{}: output {k} falls as h^{observed:.2}", method.part);
        }
    }
}
