//! Tests the starts and ends of rays: the frame of the static observer, the bounding sphere, capture.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec3, Vec4};

use super::{Errors, Random, U, awkward_directions, row, vectors, wide};
use crate::support::{
    gpu,
    probe::{Probe, about_a_point},
};

/// The static observer: v = d⊥ + √(1 − 2M/r) (d·n̂) n̂, whose length by the black hole's metric equals the length of d.
#[test]
fn static_observer() {
    let center = Vec3::new(-0.5, 2.0, 1.0);
    let mut random = Random::new(41);
    let mut inputs = Vec::new();
    for x in vectors(&mut random, 2000, 2.2, 1e4) {
        let d = random.direction().as_vec3();
        let n = x.normalize();
        inputs.extend([d, n, -n, n.any_orthonormal_vector()].map(|d| [row(x + center, 0.0), row(d, 0.0)]));
    }
    let law = vec![("center", V3(center.as_dvec3())), ("mass", Float(1.0))];
    let probe = Probe::new(&["segment/ray", "law/phase_space", "law/schwarzschild_path", "camera/frame_static"])
        .bind("law", [law]);
    let out = probe.run::<2, 1>(&gpu(), "put(0u, vec4f(frame_velocity(p0.xyz, p1.xyz), 0.0));", &inputs);
    let (mut errors, mut lengths) = (Errors::of("static frame"), Errors::of("static frame's metric length"));
    for (input, [v]) in inputs.iter().zip(&out) {
        let (x, d) = (wide(input[0]) - center.as_dvec3(), wide(input[1]));
        let (r, n) = (x.length(), x.normalize());
        let f = 1.0 - 2.0 / r;
        // 1 − 2M/r errs by 4 U of 1, and its root by that over 2√f; n̂ and the products err by 8 U.
        let bound = U * (12.0 + 4.0 / f.sqrt());
        errors.check3(*v, d - d.dot(n) * n + f.sqrt() * d.dot(n) * n, bound, input);
        let v = wide(*v);
        let radial = v.dot(n);
        let length = ((v - radial * n).length_squared() + radial * radial / f).sqrt();
        lengths.check(length as f32, d.length(), bound / f.sqrt() + 2.0 * U, input);
    }
    errors.report();
    lengths.report();
}

const BOUND: f64 = 50.0;
const MIDDLE: Vec3 = Vec3::new(3.0, -2.0, 7.0);

/// Returns the distance at which the line enters the sphere of radius R: 0 from inside, `None` if it never does.
fn entry(x: DVec3, v: DVec3, radius: f64) -> Option<f64> {
    let b = x.dot(v);
    if x.length() <= radius {
        return Some(0.0);
    }
    let miss = x - b / v.length_squared() * v;
    let inside = radius * radius - miss.length_squared();
    (b < 0.0 && inside >= 0.0).then(|| (-b / v.length() - inside.sqrt()) / v.length())
}

#[test]
fn bounding_sphere() {
    let mut random = Random::new(42);
    let mut inputs = Vec::new();
    for x in vectors(&mut random, 3000, 1.0, 1e5) {
        let aim = random.vector(0.1, 80.0);
        let toward = (aim - x) * random.log(1e-3, 10.0) as f32;
        inputs.extend([toward, -toward, random.vector(0.1, 10.0)].map(|v| [row(x + MIDDLE, 0.0), row(v, 0.0)]));
    }
    for d in awkward_directions() {
        inputs.extend([100.0_f32, 49.9, 50.1].map(|r| [row(MIDDLE - d * r, 0.0), row(d, 0.0)]));
    }
    let bound = vec![("center", V3(MIDDLE.as_dvec3())), ("radius", Float(BOUND))];
    let body = "put(0u, vec4f(bound_entry(p0.xyz, p1.xyz), f32(left_bound(p0.xyz, p1.xyz)), 0.0, 0.0));";
    let out = Probe::new(&["law/bound", "law/leaving"]).bind("bound", [bound]).run::<2, 1>(&gpu(), body, &inputs);
    let mut entries = Errors::of("bound_entry, as length over the size of its terms");
    let (mut open, mut entered) = (0, 0);
    for (input, [got]) in inputs.iter().zip(&out) {
        let (x, v) = (wide(input[0]) - MIDDLE.as_dvec3(), wide(input[1]));
        // The nearest point errs by 10 U of |x − c|, and so may the radius of the sphere.
        let moved = 10.0 * U * (x.length() + BOUND);
        let [grown, shrunk] = [1.0, -1.0].map(|s| entry(x, v, BOUND + s * moved));
        match (grown, shrunk) {
            (Some(a), Some(b)) if (a == 0.0) == (b == 0.0) => {
                entered += 1;
                let speed = v.length();
                let bound = 8.0 * U * (x.length() + BOUND) + 0.5 * (a - b).abs() * speed;
                entries.check(got.x * speed as f32, f64::midpoint(a, b) * speed, bound + U * a.abs() * speed, input);
            }
            (None, None) => assert!(got.x < 0.0, "{input:?} enters at {}", got.x),
            _ => open += 1,
        }
        let (r, outwards) = (x.length(), x.dot(v));
        if (r - BOUND).abs() > moved && outwards.abs() > 8.0 * U * r * v.length() {
            assert_eq!(got.y == 1.0, r > BOUND && outwards > 0.0, "left_bound at {input:?}");
        }
    }
    println!("bound_entry: {entered} enter, {open} for rounding to decide, of {}", inputs.len());
    assert!(entered > inputs.len() / 5 && open < inputs.len() / 50);
    entries.report();
}

#[test]
fn capture_spheres() {
    let spheres = [(DVec3::ZERO, 2.0), (DVec3::new(3.0, 0.0, 0.0), 1.5), (DVec3::new(-4.0, 8.0, 1.0), 0.25)];
    let mut random = Random::new(43);
    let inputs: Vec<[Vec4; 2]> = (0..4000)
        .map(|k| {
            let (center, radius) = spheres[k % 3];
            let x = center + random.direction() * radius * random.within(0.2, 2.5);
            [row(x.as_vec3(), 0.0), row(random.vector(0.1, 10.0), 0.0)]
        })
        .collect();
    let body = "put(0u, vec4f(f32(law_captured(p0.xyz, p1.xyz)))); put(1u, capture_gap(p0.xyz));";
    let records =
        spheres.map(|(center, radius)| about_a_point(vec![("center", V3(center)), ("radius", Float(radius))]));
    let probe =
        Probe::new(&["state/loops", "law/capture"]).with("CAPTURES").list("capture_spheres", "CAPTURE_COUNT", records);
    let out = probe.run::<2, 2>(&gpu(), body, &inputs);
    let (mut gaps, mut normals) = (Errors::of("capture_gap"), Errors::of("capture_gap's normal"));
    let mut captured = 0;
    for (input, [caught, gap]) in inputs.iter().zip(&out) {
        let (x, v) = (wide(input[0]), wide(input[1]));
        let each = spheres.map(|(c, r)| ((x - c).length() - r, (x - c).dot(v), x - c));
        let sure = |inside: f64, inwards: f64| {
            each.iter().any(|(gap, towards, d)| *gap < inside && *towards < inwards * d.length() * v.length())
        };
        let small = 20.0 * U;
        if sure(-small, -small) == sure(small, small) {
            assert_eq!(caught.x == 1.0, sure(0.0, 0.0), "{input:?}");
            captured += usize::from(caught.x == 1.0);
        }
        let nearest = each.iter().fold(each[0], |a, b| if b.0 < a.0 { *b } else { a });
        gaps.check(gap.w, nearest.0, 8.0 * U * x.length() + 4.0 * U, input);
        // Near the middle between two spheres either may be the nearest.
        if each.iter().filter(|(gap, ..)| gap - nearest.0 < small).count() == 1 {
            normals.check3(*gap, nearest.2.normalize(), 4.0 * U * (2.0 + x.length() / nearest.2.length()), input);
        }
    }
    assert!(captured > 300, "{captured} of {} captured", inputs.len());
    gaps.report();
    normals.report();
}
