//! Tests formulas as WGSL: the functions that they call, the generated code, and positions without a value.

use bentray::program::{Analysis, Features, ProgramOptions, plan};
use glam::{DVec3, Vec4};

use super::numbers::SINE_BOUND;
use super::reals::{U64, answers, joined, joined3, split};
use super::{Errors, Random, U, wide};
use crate::support::{gpu, probe::Probe, scene};

/// Returns the generated function of a formula, with this name.
fn generated(name: &str, formula: &str) -> String {
    let text = format!(
        "[law]\nkind = \"medium\"\nindex = {{ kind = \"expression\", n = \"{formula}\" }}\n\
         [rays]\nbounding_sphere = {{ radius = 9 }}\ntolerance = 1e-6\n"
    );
    let scene = scene(&text);
    let analysis = Analysis::of(&scene);
    let parts = plan(&scene, &analysis, &Features::of(&scene, &ProgramOptions::default(), &analysis)).unwrap();
    let unit = parts
        .shared
        .into_iter()
        .chain(parts.regions.into_iter().flatten())
        .find(|unit| unit.file == "generated/formula.wgsl")
        .unwrap();
    let function = unit.text.split("fn formula(").next().unwrap();
    function.replace("formula_0", name)
}

fn with_formulas<'f>(real: &str, formulas: impl IntoIterator<Item = &'f str>) -> Probe {
    let probe = Probe::new(&["state/loops", "medium/formula", "medium/finite", real]);
    formulas
        .into_iter()
        .enumerate()
        .fold(probe, |probe, (k, formula)| probe.stub(&generated(&format!("case_{k}"), formula)))
}

/// A formula; its gradient, value and the size of their terms, derived by hand; the scale of its positions.
type Case = (&'static str, fn(DVec3) -> (DVec3, f64, f64), f64);

const CASES: [Case; 8] = [
    (
        "1 + 0.1 * exp(-r^2)",
        |q| {
            let e = 0.1 * (-q.length_squared()).exp();
            (-2.0 * e * q, 1.0 + e, 1.0 + e * (1.0 + q.length_squared()))
        },
        2.0,
    ),
    (
        "2 / (1 + r^2)",
        |q| {
            let n = 2.0 / (1.0 + q.length_squared());
            (-n * n * q, n, n * (1.0 + n * q.length()))
        },
        5.0,
    ),
    (
        "sqrt(2 - r^2 / 9)",
        |q| {
            let n = (2.0 - q.length_squared() / 9.0).sqrt();
            (-q / (9.0 * n), n, 2.0 / n + q.length() / n.powi(3))
        },
        4.0,
    ),
    (
        "1.5 + 0.2 * sin(3 * x) * cos(2 * y + z)",
        |q| {
            let ((s, c), (t, d)) = ((3.0 * q.x).sin_cos(), (2.0 * q.y + q.z).sin_cos());
            (0.2 * DVec3::new(3.0 * c * d, -2.0 * s * t, -s * t), 1.5 + 0.2 * s * d, 2.0 + q.length())
        },
        3.0,
    ),
    (
        "2 + 0.3 * tanh(y / 0.5) * max(0.5, abs(x)) - min(z, -4)",
        |q| {
            let (t, wide) = ((y_of(q) / 0.5).tanh(), q.x.abs() > 0.5);
            let width = if wide { q.x.abs() } else { 0.5 };
            let slope = if wide { 0.3 * t * q.x.signum() } else { 0.0 };
            (DVec3::new(slope, 0.6 * (1.0 - t * t) * width, 0.0), 6.0 + 0.3 * t * width, 7.0 + 2.0 * width)
        },
        3.0,
    ),
    (
        "(4 + x)^1.3 + log(5 + z) + 1 / (6 + y)^2",
        |q| {
            let (a, b, c) = (4.0 + q.x, 5.0 + q.z, 6.0 + q.y);
            let slope = DVec3::new(1.3 * a.powf(0.3), -2.0 / c.powi(3), 1.0 / b);
            (
                slope,
                a.powf(1.3) + b.ln() + 1.0 / (c * c),
                (4.0 + a.ln().abs()) * (a.powf(1.3) + 2.0) + 3.0 / b + 3.0 / c.powi(2),
            )
        },
        3.0,
    ),
    (
        "1.2 + atan(x * y) / pi + 0.1 * cosh(z) - 0.05 * sinh(y) + tan(0.3 * x)",
        |q| {
            let (d, tan) = (1.0 + (q.x * q.y).powi(2), (0.3 * q.x).tan());
            let pi = std::f64::consts::PI;
            let slope =
                DVec3::new(q.y / d / pi + 0.3 * (1.0 + tan * tan), q.x / d / pi - 0.05 * q.y.cosh(), 0.1 * q.z.sinh());
            let n = 1.2 + (q.x * q.y).atan() / pi + 0.1 * q.z.cosh() - 0.05 * q.y.sinh() + tan;
            (slope, n, 3.0 + q.length() + q.z.cosh() + q.y.cosh() + 3.0 * tan * tan)
        },
        3.0,
    ),
    (
        "9 + r^3 / 20 - 1 / (1 + r)^2 + r",
        |q| {
            let r = q.length();
            let slope = r * r * 3.0 / 20.0 + 2.0 / (1.0 + r).powi(3) + 1.0;
            (slope * q / r, 9.0 + r.powi(3) / 20.0 - 1.0 / (1.0 + r).powi(2) + r, 11.0 + r + r.powi(3))
        },
        6.0,
    ),
];

fn y_of(q: DVec3) -> f64 {
    q.y
}

/// Each value results from at most 24 operations, and a function adds an error of at most 40 roundings (an exponential in 32 bits has 6 + 4
/// |a|, |a| < 9; the sizes of the terms account for conditioning).
#[test]
fn values_and_gradients_of_formulas() {
    let calls: Vec<String> = (0..CASES.len())
        .map(|k| {
            let s = CASES[k].2;
            format!("let c{k} = case_{k}({s:?} * p0.xyz); put({k}u, c{k});\n")
        })
        .collect();
    let mut random = Random::new(51);
    let inputs: Vec<[Vec4; 1]> = (0..3000).map(|_| [random.vector(1e-3, 1.0).extend(0.0)]).collect();
    let body = calls.concat();
    let out = with_formulas("real/f32", CASES.map(|case| case.0)).run::<1, 8>(&gpu(), &body, &inputs);
    for (k, (formula, exact, scale)) in CASES.iter().enumerate() {
        let (mut values, mut slopes) = (Errors::of(formula), Errors::of("its gradient"));
        for (input, rows) in inputs.iter().zip(&out) {
            // The scaled position is rounded once more, which counts as an operation.
            let (slope, n, size) = exact(*scale * wide(input[0]));
            values.check(rows[k].w, n, 64.0 * U * size, input);
            slopes.check3(rows[k], slope, 64.0 * U * size * (1.0 + slope.length()), input);
        }
        values.report();
        slopes.report();
    }
    // At the center no gradient has a direction, and none is NaN.
    let centre = with_formulas("real/f32", CASES.map(|case| case.0)).run::<1, 8>(&gpu(), &body, &[[Vec4::ZERO]]);
    for k in [0, 1, 2, 7] {
        assert_eq!(wide(centre[0][k]), DVec3::ZERO, "{}", CASES[k].0);
    }
}

/// In 64 bits the numbers of the formula must have 64 bits too.
#[test]
fn formulas_in_64_bits() {
    let calls: Vec<String> = (0..CASES.len())
        .map(|k| {
            let (s, row) = (CASES[k].2, 4 * k);
            format!(
                "let c{k} = case_{k}({s:?} * Real3(real(p0), real(p1), real(p2)));
                put_real3({row}u, c{k}.xyz);
                put_real({row}u + 3u, c{k}.w);\n"
            )
        })
        .collect();
    let mut random = Random::new(52);
    let places: Vec<DVec3> = (0..1000).map(|_| random.direction() * random.log(1e-3, 1.0)).collect();
    let inputs: Vec<[Vec4; 3]> = places.iter().map(|q| q.to_array().map(split)).collect();
    let probe = with_formulas("real/f64", CASES.map(|case| case.0)).stub(super::reals::REALS);
    let out = probe.run::<3, 32>(&gpu(), &calls.concat(), &inputs);
    for (k, (formula, exact, scale)) in CASES.iter().enumerate() {
        let mut worst = 0.0_f64;
        for (q, rows) in places.iter().zip(&out) {
            let (slope, n, size) = exact(*scale * *q);
            let bound = 64.0 * U64 * size;
            let (got, gradient) = (joined(rows[4 * k + 3]), joined3(&rows[4 * k..4 * k + 3]));
            worst =
                worst.max((got - n).abs() / bound).max((gradient - slope).length() / (bound * (1.0 + slope.length())));
            assert!(worst <= 1.0, "{formula} at {q}: {got}, {gradient}, not {n}, {slope}");
        }
        println!("{formula}: {worst:.2} of its bound");
    }
}

/// √, ln, sine and cosine; sinh, cosh, tanh, sign; minimum and maximum.
const FUNCTIONS: &str = "put(0u, vec4f(formula_sqrt(abs(p0.x)), formula_log(abs(p0.x)), formula_sin_cos(p0.x)));
    put(1u, vec4f(formula_sinh(p0.y), formula_cosh(p0.y), formula_tanh(p0.y), formula_sign(p0.y)));
    put(2u, vec4f(formula_min(p0.x, p0.y), formula_max(p0.x, p0.y), real_exp(p0.y), 0.0));";

#[test]
fn functions_of_formulas() {
    let mut random = Random::new(53);
    let sign = |random: &mut Random| if random.unit() < 0.5 { -1.0 } else { 1.0 };
    let inputs: Vec<[Vec4; 1]> = (0..8000)
        .map(|i| {
            let (a, b) = (sign(&mut random), sign(&mut random));
            let near_one = 1.0 + random.log(1e-7, 0.1) * sign(&mut random);
            let x = if i % 4 == 0 { near_one } else { random.log(1e-4, 40.0) };
            [Vec4::new((a * x) as f32, (b * random.log(1e-4, 20.0)) as f32, 0.0, 0.0)]
        })
        .collect();
    let out = with_formulas("real/f32", []).run::<1, 3>(&gpu(), FUNCTIONS, &inputs);
    let names = ["sqrt", "log", "sin", "cos", "sinh", "cosh", "tanh", "exp"];
    let [mut roots, mut logs, mut sines, mut cosines, mut sinhs, mut coshs, mut tanhs, mut exps] =
        names.map(Errors::of);
    for (input, rows) in inputs.iter().zip(&out) {
        let (x, y) = (f64::from(input[0].x), f64::from(input[0].y));
        let size = x.abs();
        roots.check(rows[0].x, size.sqrt(), 3.0 * U * size.sqrt(), input);
        logs.check(rows[0].y, size.ln(), 4.0 * U * size.ln().abs(), input);
        sines.check(rows[0].z, x.sin(), SINE_BOUND * size.min(1.0), input);
        cosines.check(rows[0].w, x.cos(), SINE_BOUND, input);
        // WGSL's bound on exp, 3 + 2 |a| units in the last place, each up to two roundings.
        let e = |a: f64| (6.0 + 4.0 * a.abs()) * U;
        exps.check(rows[2].z, y.exp(), e(y) * y.exp(), input);
        let terms = if y.abs() < 0.3 { 0.0 } else { y.cosh() };
        sinhs.check(rows[1].x, y.sinh(), e(y) * terms + 8.0 * U * y.sinh().abs(), input);
        coshs.check(rows[1].y, y.cosh(), (e(y) + U) * y.cosh(), input);
        tanhs.check(rows[1].z, y.tanh(), 2.0 * e(2.0 * y) * (-2.0 * y.abs()).exp() + 4.0 * U, input);
        assert_eq!(rows[1].w, input[0].y.signum(), "{input:?}");
        assert_eq!((rows[2].x, rows[2].y), (input[0].x.min(input[0].y), input[0].x.max(input[0].y)), "{input:?}");
    }
    for errors in [roots, logs, sines, cosines, sinhs, coshs, tanhs, exps] {
        errors.report();
    }
}

#[test]
fn functions_of_formulas_in_64_bits() {
    let mut random = Random::new(54);
    let inputs: Vec<[Vec4; 1]> =
        (0..4000).map(|_| [split(random.log(1e-4, 20.0) * (random.unit() - 0.5).signum())]).collect();
    let body = "let a = real(p0);
        put_real(0u, formula_sinh(a));
        put_real(1u, formula_cosh(a));
        put_real(2u, formula_tanh(a));
        put_real(3u, formula_log(abs(a)));";
    let out = answers::<1, 4>(with_formulas("real/f64", []), &gpu(), body, &inputs);
    for (input, got) in inputs.iter().zip(&out) {
        let x = f64::from(input[0].x) + f64::from(input[0].y) + f64::from(input[0].z);
        let x = super::reals::times(x, input[0].w);
        let terms = if x.abs() < 0.3 { 0.0 } else { x.cosh() };
        let bounds = [
            4.0 * U64 * terms + 8.0 * U64 * x.sinh().abs(),
            6.0 * U64 * x.cosh(),
            8.0 * U64,
            4.0 * U64 * x.abs().ln().abs() + U64,
        ];
        let want = [x.sinh(), x.cosh(), x.tanh(), x.abs().ln()];
        for k in 0..4 {
            assert!((got[k] - want[k]).abs() <= bounds[k], "{k} of {x}: {} not {}", got[k], want[k]);
        }
    }
}

/// The index and its pull are not finite if a formula has no value, or none above 0; otherwise they are.
#[test]
fn no_index_goes_unnoticed() {
    let formulas = [
        "x",
        "sqrt(x)",
        "log(x + 1)",
        "1 / x",
        "max(log(x), 1)",
        "min(sqrt(x), 1)",
        "x^1.5",
        "sin(1 / x) + 2 + 0 * x",
        "exp(1 / x)",
        "cos(x * 1e8) + 2",
    ];
    let count = formulas.len();
    let calls: Vec<String> = (0..count)
        .map(|k| {
            format!(
                "let n{k} = limited_index(case_{k}(q).w);
                let pull{k} = limited_pull(case_{k}(q));
                put({k}u, vec4f(f32(n{k}), f32(finite(Real3(n{k}))), f32(finite(pull{k})), 0.0));\n"
            )
        })
        .collect();
    for real in ["real/f32", "real/f64"] {
        let body = format!("let q = Real3(p0.xyz);\n{}", calls.concat());
        let inputs = [2.0_f32, 0.0, -2.0, f32::NAN].map(|x| [Vec4::new(x, 0.5, 0.25, 0.0)]);
        let out = with_formulas(real, formulas).run::<1, 10>(&gpu(), &body, &inputs);
        let finite = |i: usize| (0..count).map(|k| [out[i][k].y == 1.0, out[i][k].z == 1.0]).collect::<Vec<_>>();
        // The logarithm of 0 is less than 1, and that of −2 is not a number.
        let yes = [true; 2];
        let no = [false; 2];
        assert_eq!(finite(0), [yes, yes, yes, yes, yes, yes, yes, yes, yes, no], "{real} at 2");
        assert_eq!(finite(1), [no, no, no, no, yes, no, no, no, no, yes], "{real} at 0");
        assert_eq!(finite(2)[..7], [no; 7], "{real} at −2");
        assert_eq!(finite(3), [no; 10], "{real} at no number");
    }
}
