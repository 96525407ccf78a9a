//! Tests step control with a step size that is fixed before the step: fixed, scaled, and by curvature.

use bentray::model::Value::Float;
use glam::{DVec3, Vec3, Vec4};

use super::control::{CONTROL, ETA, Kept, probe, rays};
use super::laws::{flow, lorenz, phases};
use super::rounding::{Rough, rough_bend};
use super::schemes::{path_rate, rk4};
use super::{Errors, Random, U, row, wide};
use crate::support::gpu;

/// Returns η · scale of a ray around the black hole, with an error of 6 U.
fn cap(input: &[Vec4; 2]) -> f64 {
    ETA * wide(input[0]).length() / wide(input[1]).length()
}

/// Steps of one size, or the cap if it is smaller; the cap applies to many rays, but not to all.
#[test]
fn fixed_steps() {
    let inputs = rays(61);
    for (step, some_capped) in [(0.25, false), (3.0, true), (8.0, true)] {
        let values = vec![("step", Float(step)), ("eta", Float(ETA))];
        let out =
            probe("method/step/rk4", &["method/control/fixed"], false, values).run::<2, 5>(&gpu(), CONTROL, &inputs);
        let (mut kept, mut sizes, mut capped) = (Kept::new(), Errors::of("fixed sizes"), 0);
        for (input, output) in inputs.iter().zip(&out) {
            let taken = f64::from(output[2].x);
            let longest = cap(input);
            capped += usize::from(longest < step);
            // The uncapped step is used unchanged.
            let bound = if longest < 0.999 * step { 6.0 * U * longest } else { 0.0 };
            if (longest - step).abs() > 1e-3 * step {
                sizes.check(output[2].x, step.min(longest), bound, input);
            }
            assert_eq!(
                (output[1].w, output[2].w),
                (input[1].w, 20.0),
                "the memory does not change, and nothing is rejected"
            );
            kept.check(input, output, rk4(path_rate, [wide(input[0]), wide(input[1])], taken));
        }
        assert_eq!(capped > 100 && capped < inputs.len() - 100, some_capped, "{capped} capped of {}", inputs.len());
        kept.report();
        sizes.report();
    }
}

#[test]
fn scaled_steps() {
    let inputs = rays(65);
    let (mut kept, mut sizes) = (Kept::new(), Errors::of("scaled sizes"));
    let scaled = probe("method/step/rk4", &["method/control/scaled"], false, vec![("eta", Float(ETA))]);
    for (input, output) in inputs.iter().zip(&scaled.run::<2, 5>(&gpu(), CONTROL, &inputs)) {
        let p = [wide(input[0]), wide(input[1])];
        sizes.check(output[2].x, cap(input), 6.0 * U * cap(input), input);
        kept.check(input, output, rk4(path_rate, p, f64::from(output[2].x)));
    }
    kept.report();
    sizes.report();
}

const TURN: f64 = 0.02;

/// Returns the possible range of h = turn |v|²/|v × a|, before the cap.
fn curved(input: &[Vec4; 2]) -> [f64; 2] {
    let p = [0, 1].map(|k| Rough::exact(wide(input[k]), U));
    let a = rough_bend(p)(p[0]);
    let v = p[1].value;
    let bend = v.cross(a.value).length();
    // A component of v × a errs by 3 U of |v| |a|, two products and their difference, and the root of the sum of squares by 3 U.
    let off = v.length() * a.bound() + 6.0 * U * v.length() * a.value.length() + 3.0 * U * bend;
    // turn |v|², its quotient and the f32 of turn: 6 U.
    [1.0 - 6.0 * U, 1.0 + 6.0 * U]
        .map(|slack| TURN * v.length_squared() / (bend - (slack - 1.0).signum() * off).max(0.0) * slack)
}

/// Each step turns the ray through a constant angle: h = turn |v|²/|v × a|, or η · scale if that is smaller.
#[test]
fn steps_by_curvature() {
    let mut inputs = rays(66);
    let mut random = Random::new(68);
    for [_, v] in &mut inputs {
        *v *= Vec3::splat(random.log(0.5, 2.0) as f32).extend(1.0);
    }
    // A ray straight through the center does not turn at all.
    inputs.extend([1.0, -1.0].map(|s| [row(Vec3::X * 7.0, 0.0), row(Vec3::X * s, 0.0)]));
    let radial = inputs.len() - 2;
    let values = vec![("turn", Float(TURN)), ("eta", Float(ETA))];
    let out =
        probe("method/step/rk4", &["method/control/curvature"], false, values).run::<2, 5>(&gpu(), CONTROL, &inputs);
    let (mut kept, mut turns, mut capped) = (Kept::new(), Errors::of("angles turned through"), 0);
    for (i, (input, output)) in inputs.iter().zip(&out).enumerate() {
        let (p, taken) = ([wide(input[0]), wide(input[1])], f64::from(output[2].x));
        let [shortest, longest] = curved(input);
        let under = cap(input) * (1.0 - 6.0 * U);
        assert!(
            taken >= shortest.min(under) && taken <= longest.min(cap(input) * (1.0 + 6.0 * U)),
            "{taken} is not in [{shortest}, {longest}] at {input:?}"
        );
        assert!(i < radial || (shortest > 1e6 && taken >= under), "a radial ray's steps are the cap");
        let end = rk4(path_rate, p, taken);
        kept.check(input, output, end);
        capped += usize::from(shortest > cap(input));
        // v × x is constant, so that |v × a| ∝ r⁻⁵; |v| changes by |a| h. The change of both during the step is the error of the angle.
        let (r, speed) = (p[0].length(), p[1].length());
        let change = 5.0 * taken * speed / (r - taken * speed) + 2.0 * path_rate(p)[1].length() * taken / speed;
        if shortest < 0.99 * cap(input) && change < 0.3 {
            let angle = wide(output[1]).angle_between(p[1]) as f32;
            turns.check(angle, TURN, TURN * (change.exp() - 1.0) + 1e-6, input);
        }
    }
    println!("curvature: {capped} steps of {} are capped", inputs.len());
    assert!(capped > 300 && capped < inputs.len() - 300);
    kept.report();
    turns.report();
}

/// The v of a flow turns by DF · F; the law uses a difference over a small time ε, with the exact second-order term of a quadratic field.
#[test]
fn a_flow_bends_as_its_field_changes() {
    let inputs = phases(67, [0.5, 50.0], [1.0, 1.0]);
    let body = "let here = Phase(p0.xyz, p1.xyz); put(0u, vec4f(path_acceleration(here, law_derivative(here)), 0.0));";
    let out = flow("law/field_lorenz", "law/flow").run::<2, 1>(&gpu(), body, &inputs);
    let (mut bends, beta) = (Errors::of("a flow's bend"), f64::from(8.0_f32 / 3.0));
    let epsilon = 1e-3 / (11.0 + beta);
    for (input, [output]) in inputs.iter().zip(&out) {
        let x = wide(input[0]);
        let (f, terms) = lorenz(x);
        let along =
            DVec3::new(10.0 * (f.y - f.x), (28.0 - x.z) * f.x - f.y - x.x * f.z, x.y * f.x + x.x * f.y - beta * f.z);
        let want = along + epsilon * DVec3::new(0.0, -f.x * f.z, f.x * f.y);
        // Both values of the field err by 4 U of their terms, and the second position by 2 U, times a slope of the field of at most 60 + 2
        // |x|; the quotient errs by 3 U.
        let place = 2.0 * U * (x.length() + 1e-3 * f.length()) * (60.0 + 2.0 * x.length());
        let (_, later) = lorenz(x + epsilon * f);
        bends.check3(*output, want, (4.0 * U * (terms + later) + place) / epsilon + 4.0 * U * want.length(), input);
    }
    bends.report();
}
