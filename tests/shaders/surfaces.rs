//! Tests the data of a point on a surface: distance, normal, texture coordinates, object.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec3, Vec4};

use super::shapes::{HOLE, PARTS, Place, balls, places};
use super::{Errors, Random, U, wide};
use crate::support::{gpu, probe::Probe};

/// A point near a surface in object space, and the expected data there.
struct Expected {
    place: usize,
    own: DVec3,
    /// The gradient in object space of a function that is zero on the surface, and its value there.
    gradient: DVec3,
    value: f64,
    uv: [f64; 2],
}

/// Returns the coordinates along the longitude of a sphere, from -z over -x, +z, +x, and from the south to the north pole.
fn round_uv(p: DVec3) -> [f64; 2] {
    [0.5 + p.x.atan2(p.z) / TAU, 0.5 + (p.y / p.length()).asin() / PI]
}

fn norm(m: DMat3) -> f64 {
    (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt()
}

fn check(kind: &str, list: &'static str, targets: [Place; 2], expect: impl Fn(&mut Random, usize) -> Expected) {
    let mut random = Random::new(91);
    let expected: Vec<Expected> = (0..4000).map(|k| expect(&mut random, k)).collect();
    let inputs: Vec<[Vec4; 1]> = expected
        .iter()
        .map(|e| {
            let place = targets[e.place];
            [(place.linear.inverse() * (e.own - place.offset)).as_vec3().extend(e.place as f32)]
        })
        .collect();
    let body = format!(
        "let s = surface_{kind}(u32(p0.w), p0.xyz);
        put(0u, vec4f(s.normal, s.signed_distance));
        put(1u, vec4f(s.shading_normal, f32(s.material)));
        put(2u, vec4f(s.uv, f32(s.object), 0.0));"
    );
    let record = |k: usize| {
        // The `radius` of a disk's record is the inner radius.
        let radius = if kind == "disk" { HOLE } else { targets[k].radius };
        Place { radius, ..targets[k] }.record(k as u32)
    };
    let probe = Probe::new(&PARTS).bind(list, [0, 1].map(record));
    let (mut normals, mut gaps, mut uvs) = (Errors::of("normal"), Errors::of("gap"), Errors::of("uv"));
    for ((e, input), output) in expected.iter().zip(&inputs).zip(&probe.run::<1, 3>(&gpu(), &body, &inputs)) {
        let place = targets[e.place];
        // The transpose of the inverse map takes normals to the scene.
        let steep = place.linear.transpose() * e.gradient;
        // The coordinates err by 8 U of 1 + |row| |x| (with the rounding of the input), and a curved normal errs with them.
        let x = wide(input[0]);
        let size = norm(place.linear);
        let moved = 8.0 * U * (1.0 + size * x.length() + place.offset.length());
        // The longest axis, which is the largest factor of the inverse map.
        let stretch = norm(place.linear.inverse());
        let turned = if ["sphere", "ellipsoid", "cylinder"].contains(&kind) { 2.0 * moved } else { 0.0 };
        normals.check3(output[0], steep.normalize(), (turned + 4.0 * U) * size * stretch, input);
        gaps.check(output[0].w, e.value / steep.length(), 2.0 * moved * stretch, input);
        assert_eq!(output[0].truncate(), output[1].truncate(), "{kind}: shaded with the geometric normal");
        assert_eq!((output[1].w, output[2].z), (10.0 + e.place as f32, 20.0 + e.place as f32), "{kind}: owner");
        for k in 0..2 {
            assert!(
                (0.0..=1.0).contains(&output[2][k]) || kind == "box" || kind == "plane",
                "{kind}: uv {}",
                output[2]
            );
            // arc_tangent errs by 4e-7 of 2π or π; near the poles longitude varies as 1/ρ. u = 0 and u = 1 are the same position.
            let rho = e.own.x.hypot(e.own.z).max(1e-3);
            let off = f64::from(output[2][k]) - e.uv[k];
            let off = if k == 0 && kind != "box" && kind != "plane" { off - off.round() } else { off };
            uvs.check(off as f32, 0.0, 2e-7 + moved / rho, input);
        }
    }
    println!("surface_{kind}:");
    for errors in [normals, gaps, uvs] {
        errors.report();
    }
}

/// Points near a unit sphere, also at its poles and along the seam.
fn round_point(random: &mut Random, k: usize) -> DVec3 {
    let d = match k % 10 {
        0 => DVec3::new(random.within(-1e-2, 1e-2), 1.0, random.within(-1e-2, 1e-2)),
        1 => DVec3::new(random.within(-1e-6, 1e-6), random.within(-1.0, 1.0), -0.5),
        _ => random.direction(),
    };
    d.normalize() * random.within(0.99, 1.01)
}

#[test]
fn spheres() {
    check("sphere", "spheres", balls(92), |random, k| {
        let own = round_point(random, k);
        Expected { place: k % 2, own, gradient: own.normalize(), value: own.length() - 1.0, uv: round_uv(own) }
    });
}

#[test]
fn ellipsoids() {
    check("ellipsoid", "ellipsoids", places(93), |random, k| {
        let own = round_point(random, k);
        Expected { place: k % 2, own, gradient: own.normalize(), value: own.length() - 1.0, uv: round_uv(own) }
    });
}

/// Each face seen from outside: outward, to the right, up, with right × up = outward.
const FACES: [[DVec3; 3]; 6] = [
    [DVec3::X, DVec3::NEG_Z, DVec3::Y],
    [DVec3::NEG_X, DVec3::Z, DVec3::Y],
    [DVec3::Y, DVec3::X, DVec3::NEG_Z],
    [DVec3::NEG_Y, DVec3::X, DVec3::Z],
    [DVec3::Z, DVec3::X, DVec3::Y],
    [DVec3::NEG_Z, DVec3::NEG_X, DVec3::Y],
];

#[test]
fn boxes() {
    for [out, right, up] in FACES {
        assert_eq!(right.cross(up), out, "the faces are seen from outside");
    }
    check("box", "boxes", places(94), |random, k| {
        let [out, right, up] = FACES[k % 6];
        let (u, v) = (random.within(-0.97, 0.97), random.within(-0.97, 0.97));
        let value = random.within(-0.01, 0.01);
        let own = (1.0 + value) * out + u * right + v * up;
        Expected { place: (k / 6) % 2, own, gradient: out, value, uv: [0.5 + 0.5 * u, 0.5 + 0.5 * v] }
    });
}

#[test]
fn planes() {
    check("plane", "planes", places(95), |random, k| {
        let own = DVec3::new(random.within(-1.0, 1.0), random.within(-0.01, 0.01), random.within(-1.0, 1.0));
        let uv = [0.5 + 0.5 * own.x, 0.5 - 0.5 * own.z];
        Expected { place: k % 2, own, gradient: DVec3::Y, value: own.y, uv }
    });
}

/// Returns u around y, from -z over -x, z and x.
fn turned(p: DVec3) -> f64 {
    0.5 + p.x.atan2(p.z) / TAU
}

/// None of the three faces is mirrored as seen from outside: u grows with the angle, and v toward the upper end.
#[test]
fn cylinders() {
    check("cylinder", "cylinders", places(96), |random, k| {
        let (sin, cos) = random.within(-PI, PI).sin_cos();
        let value = random.within(-0.01, 0.01);
        let place = (k / 3) % 2;
        if k % 3 == 0 {
            let y = random.within(-0.97, 0.97);
            let out = DVec3::new(sin, 0.0, cos);
            let own = (1.0 + value) * out + y * DVec3::Y;
            return Expected { place, own, gradient: out, value, uv: [turned(own), 0.5 * (1.0 + y)] };
        }
        let rho = random.within(0.02, 0.97);
        let (out, v) = if k % 3 == 1 { (DVec3::Y, 1.0 - rho) } else { (DVec3::NEG_Y, rho) };
        let own = (1.0 + value) * out + rho * DVec3::new(sin, 0.0, cos);
        Expected { place, own, gradient: out, value, uv: [turned(own), v] }
    });
}

#[test]
fn disks() {
    check("disk", "disks", places(97), |random, k| {
        let (sin, cos) = random.within(-PI, PI).sin_cos();
        let rho = random.within(HOLE + 0.01, 0.99);
        let own = DVec3::new(rho * sin, random.within(-0.01, 0.01), rho * cos);
        let v = (1.0 - rho) / (1.0 - HOLE);
        Expected { place: k % 2, own, gradient: DVec3::Y, value: own.y, uv: [turned(own), v] }
    });
}
