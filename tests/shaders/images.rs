//! Images: bilinear samples, and environment maps with the directions of their texels.

use std::f64::consts::{PI, TAU};

use bentray::model::Value::{self, Float, Uint, Uint2, Uint4};
use glam::{DVec2, DVec3, Vec3, Vec4};

use super::{Errors, Random, U, awkward_directions, row, wide};
use crate::support::{gpu, probe::Probe};

/// Six images of a few texels, made by a formula instead of textures.
const SIZE: [f64; 2] = [7.0, 4.0];
const PICTURES: &str = "fn image_extent(image: u32) -> vec2u {
    return vec2u(7u, 4u);
}

fn image_texel(image: u32, p: vec2u) -> vec3f {
    return vec3f(f32((p.x * 5u + p.y * 3u) % 8u), f32(p.x) + 10.0 * f32(p.y), f32(image));
}";

fn texel(image: f64, p: [f64; 2]) -> DVec3 {
    DVec3::new((p[0] * 5.0 + p[1] * 3.0) % 8.0, p[0] + 10.0 * p[1], image)
}

/// Returns a bilinear sample: texel centers are at halves, and between them the four nearest texels blend.
fn sample(image: f64, uv: DVec2, repeats: bool) -> DVec3 {
    let p = uv * DVec2::from(SIZE) - 0.5;
    let base = p.floor();
    let f = p - base;
    let at = |dx: f64, dy: f64| {
        let place = |k: usize, d: f64| {
            if repeats { (base[k] + d).rem_euclid(SIZE[k]) } else { (base[k] + d).clamp(0.0, SIZE[k] - 1.0) }
        };
        texel(image, [place(0, dx), place(1, dy)])
    };
    (at(0.0, 0.0) * (1.0 - f.x) + at(1.0, 0.0) * f.x) * (1.0 - f.y)
        + (at(0.0, 1.0) * (1.0 - f.x) + at(1.0, 1.0) * f.x) * f.y
}

/// Neighboring texels differ by 36 at most (across the seam, in the second color).
const STEEPEST: f64 = 36.0;

#[test]
fn bilinear_samples() {
    let mut random = Random::new(111);
    let mut inputs: Vec<[Vec4; 1]> = (0..4000)
        .map(|_| [Vec4::new(random.within(-3.0, 4.0) as f32, random.within(-3.0, 4.0) as f32, 0.0, 0.0)])
        .collect();
    // Texel centers, borders and corners.
    for i in -8..22 {
        for j in -5..13 {
            inputs.push([Vec4::new(i as f32 / 14.0, j as f32 / 8.0, 0.0, 0.0)]);
        }
    }
    let body =
        "put(0u, vec4f(image_sample(2u, p0.xy, true), 0.0)); put(1u, vec4f(image_sample(3u, p0.xy, false), 0.0));";
    let probe = Probe::new(&["surface/image"]).stub(PICTURES);
    let [mut repeated, mut clamped] = ["image_sample, repeating", "image_sample, clamped"].map(Errors::of);
    for (input, output) in inputs.iter().zip(&probe.run::<1, 2>(&gpu(), body, &inputs)) {
        let uv = wide(input[0]).truncate();
        // A position in texels errs by 3 U of its size; the blend by 6 U of its terms.
        let bound = STEEPEST * (3.0 * U * (uv.abs() * DVec2::from(SIZE) + 1.0).max_element() * 2.0 + 6.0 * U);
        repeated.check3(output[0], sample(2.0, uv, true), bound, input);
        clamped.check3(output[1], sample(3.0, uv, false), bound, input);
    }
    repeated.report();
    clamped.report();
}

fn directions(seed: u64) -> Vec<[Vec4; 1]> {
    let mut random = Random::new(seed);
    let mut all: Vec<[Vec4; 1]> = (0..4000).map(|_| [row(random.direction().as_vec3(), 0.0)]).collect();
    all.extend(awkward_directions().into_iter().map(|d| [row(d, 0.0)]));
    all
}

/// Returns the axes of a map that is not turned.
fn axes() -> Vec<(&'static str, Value)> {
    let axes = [("first", DVec3::X), ("second", DVec3::Y), ("third", DVec3::Z)];
    axes.map(|(name, axis)| (name, Value::Vec3(axis))).to_vec()
}

#[test]
fn equirectangular_sky() {
    let sky = [vec![("intensity", Float(0.5)), ("image", Uint(4))], axes()].concat();
    let parts = ["segment/ray", "surface/image", "picture/sky/equirectangular"];
    let mut inputs = directions(112);
    // The centers of the texels, and the compass: -z at the center, +x right of it, +y at the top.
    for i in 0..7 {
        for j in 0..4 {
            let (u, v) = ((f64::from(i) + 0.5) / 7.0, (f64::from(j) + 0.5) / 4.0);
            let (longitude, latitude) = (TAU * (u - 0.5), PI * (0.5 - v));
            let d = DVec3::new(longitude.sin() * latitude.cos(), latitude.sin(), -longitude.cos() * latitude.cos());
            inputs.push([row(d.as_vec3(), 1.0 + (i + 7 * j) as f32)]);
        }
    }
    let out = Probe::new(&parts).stub(PICTURES).bind("sky", [sky]).run::<1, 1>(
        &gpu(),
        "put(0u, vec4f(sky_radiance(p0.xyz), 0.0));",
        &inputs,
    );
    let (mut errors, mut texels) =
        (Errors::of("picture/sky/equirectangular"), Errors::of("sky/equirectangular at texels"));
    // The error of arc_tangent, 4e-7 of 2π, and roundings of u and of the position in texels.
    let bound = 0.5 * STEEPEST * 7.0 * (4e-7 / PI + 6.0 * U);
    for (input, [color]) in inputs.iter().zip(&out) {
        let d = wide(input[0]);
        if input[0].w > 0.0 {
            let k = f64::from(input[0].w) - 1.0;
            // The rounding of the direction turns it by U.
            texels.check3(*color, 0.5 * texel(4.0, [k % 7.0, (k / 7.0).floor()]), 2.0 * bound, input);
        }
        let u = 0.5 + (d.x + 0.0).atan2(-d.z + 0.0) / TAU;
        let v = (0.5 - d.y.atan2(d.x.hypot(d.z)) / PI).clamp(0.5 / SIZE[1], 1.0 - 0.5 / SIZE[1]);
        // Straight up and down the longitude is arbitrary.
        if d.x.hypot(d.z) > 0.0 {
            errors.check3(*color, 0.5 * sample(4.0, DVec2::new(u, v), true), bound, input);
        }
        assert!(color.is_finite());
    }
    errors.report();
    texels.report();
}

/// A face as seen from inside: its number, and the directions ahead, to the right, and up.
const FACES: [(f64, Vec3, Vec3, Vec3); 6] = [
    (0.0, Vec3::X, Vec3::Z, Vec3::Y),
    (1.0, Vec3::NEG_X, Vec3::NEG_Z, Vec3::Y),
    (2.0, Vec3::Y, Vec3::X, Vec3::Z),
    (3.0, Vec3::NEG_Y, Vec3::X, Vec3::NEG_Z),
    (4.0, Vec3::Z, Vec3::NEG_X, Vec3::Y),
    (5.0, Vec3::NEG_Z, Vec3::X, Vec3::Y),
];

#[test]
fn six_faces() {
    for (_, ahead, right, up) in FACES {
        assert_eq!(ahead.cross(up), right, "faces are seen from inside");
    }
    let faces = vec![("faces", Uint4([0, 1, 2, 3])), ("more_faces", Uint2([4, 5])), ("intensity", Float(2.0))];
    let sky = [faces, axes()].concat();
    let inputs = directions(113);
    let probe = Probe::new(&["surface/image", "picture/sky/faces"]).stub(PICTURES).bind("sky", [sky]);
    let mut errors = Errors::of("picture/sky/faces");
    for (input, [color]) in
        inputs.iter().zip(&probe.run::<1, 1>(&gpu(), "put(0u, vec4f(sky_radiance(p0.xyz), 0.0));", &inputs))
    {
        let d = input[0].truncate();
        let largest = d.abs().max_element();
        let mut faces = FACES.iter().filter(|(_, ahead, ..)| ahead.dot(d) == largest);
        // On an edge between two faces either is correct.
        if let (Some((number, ahead, right, up)), None) = (faces.next(), faces.next()) {
            let along = |axis: Vec3| f64::from(axis.dot(d)) / f64::from(ahead.dot(d));
            let uv = DVec2::new(0.5 + 0.5 * along(*right), 0.5 - 0.5 * along(*up));
            errors.check3(*color, 2.0 * sample(*number, uv, false), 2.0 * STEEPEST * 7.0 * 6.0 * U, input);
        }
        assert!(color.is_finite());
    }
    errors.report();
}
