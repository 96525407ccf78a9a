//! How paths run and end: straight motion, the termination status of a segment, and the last step retaken to its end.

use bentray::model::Value::{Float, Uint, Vec3 as V3};
use bentray::program::constant;
use glam::{DVec3, Vec4};

use super::schemes::{path_rate, rk4};
use super::{Errors, Random, U, row, wide};
use crate::support::{
    gpu,
    probe::{Probe, about_a_point},
};

const RADIUS: f64 = 50.0;
const CENTER: DVec3 = DVec3::new(1.0, -2.0, 0.5);

fn bounded(parts: &[&str], center: DVec3) -> Probe {
    Probe::new(parts).bind("bound", [vec![("center", V3(center)), ("radius", Float(RADIUS))]])
}

#[test]
fn straight_motion_leaves_the_bound_in_one_step() {
    let mut random = Random::new(131);
    let inputs: Vec<[Vec4; 2]> = (0..3000)
        .map(|_| {
            let x = CENTER + random.direction() * RADIUS * random.within(0.0, 0.999);
            [row(x.as_vec3(), 0.0), row(random.vector(0.01, 100.0), 0.0)]
        })
        .collect();
    let body = "let ray = Ray(Phase(p0.xyz, p1.xyz), 0.5, 0.0, Memory(0.0), 0.0, 3u, 10u, 20u, ALIVE);
        let next = accepted_step(ray);
        put(0u, vec4f(next.phase[0], next.taken));
        put(1u, vec4f(next.phase[1], f32(left_bound(next.phase[0], next.phase[1]))));
        put(2u, vec4f(next.tau, f32(next.steps), 0.0, 0.0));";
    let probe = bounded(
        &["segment/ray", "law/bound", "law/leaving", "law/phase_space", "motion/straight", "law/limit"],
        CENTER,
    );
    let (mut places, mut exits) = (Errors::of("straight motion"), Errors::of("straight motion's exit"));
    for (input, output) in inputs.iter().zip(&probe.run::<2, 3>(&gpu(), body, &inputs)) {
        let (x, v) = (wide(input[0]), wide(input[1]));
        let h = f64::from(output[0].w);
        places.check3(output[0], x + h * v, 4.0 * U * (x.length() + h * v.length()), input);
        assert_eq!((output[1].truncate(), output[1].w), (input[1].truncate(), 1.0), "out, with v kept");
        assert_eq!((output[2].x, output[2].y), (0.5 + output[0].w, 11.0));
        // A thousandth of the radius beyond the sphere, along the ray.
        let d = x - CENTER;
        let b = d.dot(v) / v.length_squared();
        let exit = -b
            + b.hypot(((RADIUS * RADIUS - d.length_squared()) / v.length_squared()).sqrt())
            + 1e-3 * RADIUS / v.length();
        // The distance of the nearest point errs by 6 U R, and the distance along the ray from it by R over that distance more.
        let along = (exit + b).max(1e-3) * v.length();
        exits.check(output[0].w, exit, (12.0 * U * RADIUS + 12.0 * U * RADIUS * RADIUS / along) / v.length(), input);
    }
    places.report();
    exits.report();
}

fn code(name: &str) -> f32 {
    constant("segment/ray", name) as f32
}

#[test]
fn fates_in_their_order() {
    let spheres = about_a_point(vec![("center", V3(DVec3::ZERO)), ("radius", Float(2.0))]);
    let parts = [
        "segment/ray",
        "state/loops",
        "law/bound",
        "law/leaving",
        "law/phase_space",
        "law/capture",
        "law/limit",
        "segment/termination",
    ];
    let probe = bounded(&parts, DVec3::ZERO)
        .with("CAPTURES")
        .with("IS_LIMITED")
        .list("capture_spheres", "CAPTURE_COUNT", [spheres])
        .bind("limit", [vec![("length", Float(100.0))]])
        .bind("schedule", [vec![("max_segments", Uint(10)), ("segments", Uint(1))]]);
    let body = "let s = Segment(p0.xyz, vec3f(1.0), p1.xyz, p2.xyz, 1.0);
        let ray = Ray(Phase(p1.xyz, p2.xyz), p0.w, 0.0, Memory(0.0), 0.0, 0u, 0u, 0u, ALIVE);
        put(0u, vec4f(f32(open_status(s, p0.w, u32(p1.w))), f32(path_over(ray)), 0.0, 0.0));";
    let at = |x: f32, y: f32, z: f32| Vec4::new(x, y, z, 0.0);
    let (start, v) = (at(10.0, 0.0, 0.0), at(1.0, 0.0, 0.0));
    let cases = [
        ("ALIVE", [start, at(11.0, 0.0, 0.0), v]),
        ("ESCAPED", [start, at(50.1, 0.0, 0.0), v]),
        // Outside but moving in, and inside and moving out of the horizon.
        ("ALIVE", [start, at(50.1, 0.0, 0.0), -v]),
        ("ALIVE", [start, at(1.9, 0.0, 0.0), v]),
        ("CAPTURED", [start, at(1.9, 0.0, 0.0), -v]),
        ("FAILED", [start, at(f32::NAN, 0.0, 0.0), v]),
        ("FAILED", [start, at(60.0, 0.0, 0.0), at(0.0, f32::INFINITY, 0.0)]),
        ("ENDED", [start.with_w(100.0), at(11.0, 0.0, 0.0), v]),
        // Escape and capture take precedence over the length, and the length over a ray that stalls.
        ("ESCAPED", [start.with_w(100.0), at(51.0, 0.0, 0.0), v]),
        ("ENDED", [start.with_w(100.0), start, v]),
        ("STALLED", [start, start, v]),
        ("STALLED", [start, start.with_w(9.0), v]),
        ("EXHAUSTED", [start, at(11.0, 0.0, 0.0).with_w(9.0), v]),
        ("ALIVE", [start, at(11.0, 0.0, 0.0).with_w(8.0), v]),
        ("ESCAPED", [start, at(51.0, 0.0, 0.0).with_w(9.0), v]),
    ];
    let inputs = cases.map(|(_, input)| input);
    for ((name, input), [got]) in cases.iter().zip(probe.run::<3, 1>(&gpu(), body, &inputs)) {
        assert_eq!(got.x, code(name), "{name}: {input:?}");
        let over = ["ESCAPED", "CAPTURED", "FAILED", "ENDED"].contains(name);
        assert_eq!(got.y == 1.0, over, "path_over of {name}: {input:?}");
    }
}

/// Returns the modules that find the end of a path, with RK4 steps of one size around a black hole of mass 1.
fn path_end(step: f64) -> Probe {
    let parts = [
        "segment/ray",
        "state/loops",
        "law/bound",
        "law/leaving",
        "law/phase_space",
        "law/schwarzschild_path",
        "method/step/rk4",
        "method/control/fixed",
        "law/limit",
        "law/capture",
        "segment/follow",
        "segment/ends",
        "segment/stop",
        "segment/path_end",
        "motion/pace_tau",
        "law/asymptotic",
    ];
    bounded(&parts, DVec3::ZERO)
        .with("CAPTURES")
        .bind("law", [vec![("center", V3(DVec3::ZERO)), ("mass", Float(1.0))]])
        .bind("control", [vec![("step", Float(step)), ("eta", Float(100.0))]])
        .list(
            "capture_spheres",
            "CAPTURE_COUNT",
            [about_a_point(vec![("center", V3(DVec3::ZERO)), ("radius", Float(2.0))])],
        )
}

const PATH_END: &str = "let ray = Ray(Phase(p0.xyz, p1.xyz), 0.5, 0.0, Memory(0.0), 0.0, 0u, 0u, 0u, u32(p0.w));
    let end = path_end(ray, Hit(0.0, NOTHING));
    put(0u, vec4f(end.x, end.tau));
    put(1u, vec4f(end.v, end.fraction));";

/// Returns rays whose next step crosses the sphere, outward or inward, and which first move away from it or not.
fn crossing(name: &str, sphere: f64, step: f64, turns: bool) -> Vec<[Vec4; 2]> {
    let mut random = Random::new(132);
    let mut inputs = Vec::new();
    let sign = if name == "ESCAPED" { 1.0 } else { -1.0 };
    while inputs.len() < 2000 {
        let out = random.direction();
        let x = (out * (sphere - sign * step * random.log(1e-3, 0.8))).as_vec3();
        let v = (sign * out + 3.0 * random.direction()).normalize().as_vec3();
        let [end, onward] = rk4(path_rate, [x.as_dvec3(), v.as_dvec3()], step);
        let crosses = sign * (end.length() - sphere) > 1e-4 * sphere && sign * end.dot(onward) > 0.1;
        let away = sign * x.as_dvec3().dot(v.as_dvec3()) < 0.0;
        if crosses && away == turns {
            inputs.push([row(x, code(name)), row(v, 0.0)]);
        }
    }
    inputs
}

fn check_crossing(name: &str, sphere: f64, step: f64, inputs: &[[Vec4; 2]]) {
    let (mut gaps, mut ends) = (Errors::of("distance from the sphere"), Errors::of("the retaken step"));
    let out = path_end(step).run::<2, 2>(&gpu(), PATH_END, inputs);
    for (input, output) in inputs.iter().zip(&out) {
        let fraction = f64::from(output[1].w);
        // Newton's method stops when rounding determines the correction, of the position and of |x|. Some rays are nearly
        // tangential, for which the secant's estimate alone would be far off.
        gaps.check(wide(output[0]).length() as f32, sphere, 16.0 * U * sphere, input);
        let end = rk4(path_rate, [wide(input[0]), wide(input[1])], fraction * step);
        let near = 60.0 * U * 3.0 / (0.5 * sphere).powi(2) * step * step;
        ends.check3(output[0], end[0], 8.0 * U * (sphere + step) + near, input);
        ends.check3(output[1], end[1], 8.0 * U + near / step, input);
        ends.check(output[0].w, 0.5 + fraction * step, 4.0 * U * (0.5 + step), input);
    }
    println!("{name}:");
    ends.report();
    gaps.report();
}

#[test]
fn last_steps_are_retaken_to_where_they_stop() {
    for (name, sphere, step) in [("ESCAPED", RADIUS, 4.0), ("CAPTURED", 2.0, 0.25)] {
        check_crossing(name, sphere, step, &crossing(name, sphere, step, false));
    }
}

/// A grazing ray may first move inward and leave in the same step: the sphere is first further off, then nearer.
#[test]
fn last_steps_that_turn_before_they_leave() {
    check_crossing("ESCAPED", RADIUS, 4.0, &crossing("ESCAPED", RADIUS, 4.0, true));
}

/// A ray that never started stays in place; one that ended at its length is at the end of its last step.
#[test]
fn ends_that_need_no_search() {
    let step = 4.0;
    let (x, v) = (Vec4::new(9.0, 1.0, -3.0, 0.0), Vec4::new(0.0, 0.6, 0.8, 0.0));
    let inputs = ["MISSED", "ALIVE", "ENDED"].map(|name| [x.with_w(code(name)), v]);
    let out = path_end(step).run::<2, 2>(&gpu(), PATH_END, &inputs);
    for output in &out[..2] {
        assert_eq!(*output, [x.with_w(0.5), v]);
    }
    let end = rk4(path_rate, [wide(x), wide(v)], step)[0];
    assert!((wide(out[2][0]) - end).length() < 20.0 * U * 10.0, "{} is not {end}", out[2][0]);
    assert_eq!((out[2][0].w, out[2][1].w), (0.5 + step as f32, 1.0));
}
