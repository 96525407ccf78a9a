//! Tests the bounds of formulas along pieces of paths: they contain all values, and close in on them.

use bentray::program::{Analysis, Features, ProgramOptions, plan};
use glam::Vec4;

use super::{Random, U};
use crate::support::{gpu, probe::Probe, scene};

/// Formulas of x and y with every operation, without poles for x and y from 0.5 to 3.
type Case = (&'static str, fn(f64, f64) -> f64);

const CASES: [Case; 12] = [
    ("exp(-((x - 1)/0.3)^2)*y", |x, y| (-((x - 1.0) / 0.3).powi(2)).exp() * y),
    ("1/(1 + (x - y)^2)", |x, y| 1.0 / (1.0 + (x - y).powi(2))),
    ("max(0, x*y - 1) + min(x, 2)", |x, y| (x * y - 1.0).max(0.0) + x.min(2.0)),
    ("sqrt(x) + log(1 + y)", |x, y| x.sqrt() + (1.0 + y).ln()),
    ("2 + sin(3*x)*cos(y)", |x, y| 2.0 + (3.0 * x).sin() * y.cos()),
    ("(x^3 - exp(y))^4", |x, y| (x.powi(3) - y.exp()).powi(4)),
    ("tan(0.4*x) + tanh(x - y) + 1", |x, y| (0.4 * x).tan() + (x - y).tanh() + 1.0),
    ("abs(x - 1)*cosh(y)", |x, y| (x - 1.0).abs() * y.cosh()),
    ("9 + sinh(x) - atan(y)", |x, y| 9.0 + x.sinh() - y.atan()),
    ("x^-3 + y^0.5", |x, y| x.powi(-3) + y.sqrt()),
    ("x^1.5/(1 + x)", |x, _| x.powf(1.5) / (1.0 + x)),
    ("exp(-y)^3 + exp(x - y)^2", |x, y| (-3.0 * y).exp() + (2.0 * (x - y)).exp()),
];

/// Returns the generated functions of a density.
fn generated(formula: &str) -> String {
    let text =
        format!("[rays]\nbounding_sphere = {{ radius = 9 }}\n[[volumes]]\ndensity = \"{formula}\"\nemission = 1\n");
    let scene = scene(&text);
    let analysis = Analysis::of(&scene);
    let parts = plan(&scene, &analysis, &Features::of(&scene, &ProgramOptions::default(), &analysis)).unwrap();
    let unit = parts.shared.into_iter().find(|unit| unit.file == "generated/matter.wgsl").unwrap();
    let function = |name: &str| {
        let from = &unit.text[unit.text.find(&format!("fn {name}(")).unwrap()..];
        from[..from.find("\n}").unwrap() + 3].to_owned()
    };
    format!("{}\n{}", function("see_volume_0"), function("density_range_volume_0"))
}

/// A point, and the range of a smooth function, of the formula `k`.
const AROUND: &str = "struct Point { q: vec3f }
    var<private> low: array<array<f32, 4>, 12>;
    var<private> high: array<array<f32, 4>, 12>;
    fn see_value(v: u32, i: u32, value: f32) {
        low[v][i] = min(low[v][i], value);
        high[v][i] = max(high[v][i], value);
    }
    fn see_point(v: u32) {}
    fn seen_range(v: u32, i: u32) -> vec2f { return vec2f(low[v][i], high[v][i]); }";

/// Along a line between two points, the range contains all values, and its width follows theirs.
#[test]
fn bounds_contain_all_values_and_close_in_on_them() {
    let mut random = Random::new(61);
    let inputs: Vec<[Vec4; 1]> = (0..2000)
        .map(|_| {
            let [x, y] = [random.within(0.5, 3.0), random.within(0.5, 3.0)];
            let size = random.log(1e-4, 1.0);
            let [a, b] = [0, 1].map(|_| random.within(-1.0, 1.0) * size);
            [Vec4::new(x as f32, y as f32, (x + a).clamp(0.5, 3.0) as f32, (y + b).clamp(0.5, 3.0) as f32)]
        })
        .collect();
    for (k, (formula, exact)) in CASES.iter().enumerate() {
        let text = generated(formula);
        let count = text.matches("    see_value(").count();
        let ranges: Vec<_> = (0..count).map(|i| format!("seen_range(0u, {i}u)")).collect();
        let body = format!(
            "for (var i = 0u; i < 4u; i++) {{ low[0][i] = 1e30; high[0][i] = -1e30; }}
             for (var i = 0u; i <= 64u; i++) {{
                 var at: MatterPlace;
                 at.q = vec3f(mix(p0.xy, p0.zw, f32(i) / 64.0), 0.0);
                 see_volume_0(at);
             }}
             put(0u, vec4f(density_range_volume_0(array<Real2, {count}>({})), 0.0, 0.0));",
            ranges.join(", ")
        );
        let place = "struct MatterPlace { q: vec3f, time: f32, r: f32, rho: f32, sine: f32, cosine: f32 }";
        let probe = Probe::new(&["state/loops", "medium/formula", "real/interval", "real/f32"]);
        let found = probe.stub(place).stub(AROUND).stub(&text).run::<1, 1>(&gpu(), &body, &inputs);
        let mut widest = 0.0_f64;
        for (input, rows) in inputs.iter().zip(&found) {
            let [x, y, to_x, to_y] = input[0].to_array().map(f64::from);
            let values = (0..=64).map(|i| f64::from(i) / 64.0).map(|f| exact(x + f * (to_x - x), y + f * (to_y - y)));
            let (least, most) = values.fold((f64::MAX, f64::MIN), |(lo, hi), value| (lo.min(value), hi.max(value)));
            let (lo, hi) = (f64::from(rows[0].x), f64::from(rows[0].y));
            // Rounding is not considered by the bounds.
            let slack = 2000.0 * U * (1.0 + most.abs());
            assert!(
                lo <= least.max(0.0) + slack && hi >= most - slack,
                "{k} {formula}: {lo} {hi}, {least} {most}, {input:?}"
            );
            let reach = (to_x - x).abs() + (to_y - y).abs();
            widest = widest.max((hi - lo - slack) / (reach * (1.0 + most.abs())));
        }
        assert!(widest < 1000.0, "{formula}: {widest}");
    }
}
