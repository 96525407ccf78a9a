//! Tests the light that surfaces reflect: patterns, the Blinn–Phong model, sums over lights.

use bentray::model::Value::{Float, Uint, Vec2 as V2, Vec3 as V3};
use bentray::program::constant;
use glam::{DVec2, DVec3, Vec4};

use super::{Errors, Random, U, row, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

const SPECULAR: DVec3 = DVec3::new(0.5, 0.25, 1.0);
const EMISSION: DVec3 = DVec3::new(0.125, 0.0, 0.5);
const AMBIENT: f64 = 0.25;
const SHININESS: [f64; 4] = [1.0, 8.0, 50.0, 400.0];

fn material(k: usize) -> Record {
    vec![
        ("color", V3(DVec3::new(1.0, 0.0, 0.0))),
        ("kind", Uint(constant("surface/material/phong", "PHONG") as u32)),
        ("second_color", V3(DVec3::new(0.0, 0.0, 1.0))),
        ("pattern", Uint(constant("surface/pattern", "CHECKER") as u32)),
        ("repeat", V2(DVec2::new(4.0, 2.0))),
        ("image", Uint(0)),
        ("bit", Uint(0)),
        ("specular", V3(SPECULAR)),
        ("exponent", Float(SHININESS[k])),
        ("emission", V3(EMISSION)),
        ("ambient", Float(AMBIENT)),
        ("diffuse", V3(DVec3::ZERO)),
        ("temperature", Float(0.0)),
        ("brightness", Float(0.0)),
        ("transmit_exponent", Float(0.0)),
        ("roughness", Float(0.0)),
        ("fan", Uint(0)),
    ]
}

/// Returns the diffuse and specular factors, and the cosine of the highlight.
fn blinn_phong(k: usize, to_light: DVec3, normal: DVec3, view: DVec3) -> (f64, f64, f64) {
    let facing = normal.dot(to_light);
    let cosine = normal.dot((to_light + view).normalize());
    let highlight = if facing > 0.0 { cosine.max(0.0).powf(SHININESS[k]) } else { 0.0 };
    (facing.max(0.0), highlight, cosine)
}

/// Returns a bound on the error of the highlight. The built-in pow is exp2 of a product with log2, whose relative error
/// near 1 is 7e-5 on lavapipe, and the cosine errs by 8 U; the exponent multiplies both.
fn highlight_bound(k: usize, highlight: f64, cosine: f64) -> f64 {
    let cosine = cosine.clamp(1e-6, 1.0);
    highlight * SHININESS[k] * (8.0 * U * (1.0 + 1.0 / cosine) + 7e-5 * cosine.ln().abs()) + 1e-5 * highlight
}

fn materials(probe: Probe) -> Probe {
    probe.bind("materials", [0, 1, 2, 3].map(material))
}

#[test]
fn blinn_phong_answers() {
    let mut random = Random::new(121);
    let mut inputs: Vec<[Vec4; 3]> = Vec::new();
    for k in 0..8000 {
        let normal = random.direction();
        let view = if k % 3 == 0 { random.direction() } else { (normal + 0.5 * random.direction()).normalize() };
        let mirrored = 2.0 * view.dot(normal) * normal - view;
        // Many of the directions are in the highlight.
        let to_light = if k % 2 == 0 { random.direction() } else { (mirrored + 0.1 * random.direction()).normalize() };
        inputs.push([row(to_light.as_vec3(), (k % 4) as f32), row(normal.as_vec3(), 0.0), row(view.as_vec3(), 0.0)]);
    }
    let body = "put(0u, vec4f(blinn_phong(materials[u32(p0.w)], vec3f(0.0, 1.0, 0.5), p0.xyz, p1.xyz, p2.xyz), 0.0));";
    let probe = materials(Probe::new(&["surface/material", "surface/material/phong"]));
    let mut errors = Errors::of("blinn_phong");
    let mut lit = 0;
    for (input, [got]) in inputs.iter().zip(&probe.run::<3, 1>(&gpu(), body, &inputs)) {
        let k = input[0].w as usize;
        let [to_light, normal, view] = input.map(wide);
        let (facing, highlight, cosine) = blinn_phong(k, to_light, normal, view);
        if normal.dot(to_light).abs() < 4.0 * U {
            continue;
        }
        lit += u32::from(highlight > 0.1);
        let want = facing * DVec3::new(0.0, 1.0, 0.5) + highlight * SPECULAR;
        // Between opposite directions of light and view there is no half vector.
        let halfway = (to_light + view).length();
        errors.check3(*got, want, 6.0 * U + highlight_bound(k, highlight, cosine) / halfway.min(1.0) + 1e-6, input);
    }
    assert!(lit > 1000, "{lit} in the highlight");
    errors.report();
}

const POINTS: [(DVec3, DVec3); 2] = [
    (DVec3::new(5.0, 8.0, 2.0), DVec3::new(1.0, 0.5, 0.25)),
    (DVec3::new(-3.0, 1.0, 6.0), DVec3::new(0.25, 0.25, 2.0)),
];

fn suns() -> [(DVec3, DVec3); 3] {
    [DVec3::NEG_Y, DVec3::new(0.6, 0.0, -0.8), DVec3::new(-0.36, -0.48, -0.8)]
        .map(|d| (d.as_vec3().as_dvec3(), DVec3::new(0.5, 0.75, 1.0)))
}

#[test]
fn lights_add_up() {
    let mut random = Random::new(122);
    let inputs: Vec<[Vec4; 3]> = (0..3000)
        .map(|k| {
            let normal = random.direction();
            let view = (normal + 0.7 * random.direction()).normalize();
            [row(random.vector(0.1, 3.0), (k % 3) as f32), row(normal.as_vec3(), 0.0), row(view.as_vec3(), 0.0)]
        })
        .collect();
    let parts = [
        "state/loops",
        "surface/material",
        "surface/material/phong",
        "surface/material/emissive",
        "surface/light/point",
        "surface/light/directional",
        "surface/shadow/straight",
        "law/bound",
        "law/leaving",
        "real/f32",
    ];
    let probe = materials(Probe::new(&parts))
        .with("FALLS")
        .stub(
            "fn lit_radiance(material: Material, color: vec3f, lit: Lit) -> vec3f {
                return lit_by_point(material, color, lit) + lit_by_directional(material, color, lit);
            }",
        )
        .bind("bound", [vec![("center", V3(DVec3::ZERO)), ("radius", Float(50.0))]])
        .bind(
            "point_lights",
            POINTS.map(|(p, c)| vec![("position", V3(p)), ("color", V3(c)), ("shadows", Uint(0)), ("falls", Uint(0))]),
        )
        .bind(
            "directional_lights",
            suns().map(|(d, c)| vec![("direction", V3(d)), ("color", V3(c)), ("shadows", Uint(0))]),
        );
    let body = "let material = materials[u32(p0.w)];
        let own = vec3f(0.5, 1.0, 0.25);
        let lit = Lit(p0.xyz, p0.xyz, p1.xyz, p2.xyz);
        put(0u, vec4f(lit_by_point(material, own, lit), 0.0));
        put(1u, vec4f(lit_by_directional(material, own, lit), 0.0));
        put(2u, vec4f(radiance_phong(material, own, lit), 0.0));
        put(3u, vec4f(radiance_emissive(material, own, lit), 0.0));";
    let own = DVec3::new(0.5, 1.0, 0.25);
    let [mut points, mut directional, mut phong] =
        ["point lights", "directional lights", "radiance_phong"].map(Errors::of);
    for (input, output) in inputs.iter().zip(&probe.run::<3, 4>(&gpu(), body, &inputs)) {
        let k = input[0].w as usize;
        let [x, normal, view] = input.map(wide);
        let sum = |lights: &[(DVec3, DVec3)]| {
            let (mut all, mut bound, mut edge) = (DVec3::ZERO, 0.0, false);
            for (to_light, light) in lights {
                let (facing, highlight, cosine) = blinn_phong(k, *to_light, normal, view);
                // For a light on the horizon of the surface, rounding decides on its highlight.
                edge |= normal.dot(*to_light).abs() < 8.0 * U;
                all += *light * (facing * own + highlight * SPECULAR);
                bound += light.max_element()
                    * (16.0 * U + highlight_bound(k, highlight, cosine) / (to_light + view).length().min(1.0));
            }
            (all, bound + 1e-6, edge)
        };
        let at = POINTS.map(|(p, c)| ((p - x).normalize(), c));
        let far = suns().map(|(d, c)| (-d, c));
        let (a, b) = (sum(&at), sum(&far));
        if !a.2 && !b.2 {
            points.check3(output[0], a.0, a.1, input);
            directional.check3(output[1], b.0, b.1, input);
            phong.check3(output[2], EMISSION + AMBIENT * own + a.0 + b.0, a.1 + b.1 + 4.0 * U, input);
        }
        assert_eq!(wide(output[3]), own);
    }
    for errors in [points, directional, phong] {
        errors.report();
    }
}

#[test]
fn checkers_alternate() {
    let mut inputs = Vec::new();
    for i in -9..17 {
        for j in -9..17 {
            // The center of each square, of 4 by 2, and points near its corners.
            for (x, y) in [(0.5, 0.5), (0.01, 0.99), (0.99, 0.01)] {
                inputs.push([Vec4::new((i as f32 + x) / 4.0, 0.5 * (j as f32 + y), f32::from((i + j) % 2 != 0), 0.0)]);
            }
        }
    }
    let body = "put(0u, vec4f(pattern_checker(materials[0], p0.xy), 0.0)); put(1u, vec4f(pattern_constant(materials[0], p0.xy), 0.0));";
    let probe = materials(Probe::new(&["surface/material", "surface/pattern"]));
    for (input, output) in inputs.iter().zip(&probe.run::<1, 2>(&gpu(), body, &inputs)) {
        let want = if input[0].z == 1.0 { DVec3::Z } else { DVec3::X };
        assert_eq!(wide(output[0]), want, "at {input:?}");
        assert_eq!(wide(output[1]), DVec3::X);
    }
}

/// Images on surfaces are upright and repeat: v = 1 is the top row.
#[test]
fn pictures_on_surfaces() {
    let stub = "fn image_extent(image: u32) -> vec2u { return vec2u(4u, 2u); }
        fn image_texel(image: u32, p: vec2u) -> vec3f { return vec3f(vec2f(p), f32(image)); }";
    let mut inputs = Vec::new();
    for i in 0..16_u8 {
        for j in 0..4_u8 {
            // The centers of texels, because the image repeats 4 by 2 times over the surface.
            inputs.push([Vec4::new(
                (f32::from(i) + 0.5) / 16.0,
                1.0 - (f32::from(j) + 0.5) / 4.0,
                f32::from(i % 4),
                f32::from(j % 2),
            )]);
        }
    }
    let probe = materials(Probe::new(&["surface/material", "surface/image", "surface/pattern"])).stub(stub);
    let out = probe.run::<1, 1>(&gpu(), "put(0u, vec4f(pattern_image(materials[0], p0.xy), 0.0));", &inputs);
    for (input, [got]) in inputs.iter().zip(&out) {
        assert!(
            (wide(*got) - DVec3::new(f64::from(input[0].z), f64::from(input[0].w), 0.0)).length() < 1e-5,
            "{got} at {input:?}"
        );
    }
}
