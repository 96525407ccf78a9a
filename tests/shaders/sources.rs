//! Force centers: every falloff, and sums of several.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::laws::{LAW, keeps_phase, phases};
use super::{Errors, U, wide};
use crate::support::{
    gpu,
    probe::{Probe, about_a_point},
};

/// A center: position, strength, and the additional parameter of its falloff (a radius, μ); all exact in f32.
type Centre = (DVec3, f64, f64);

const INVERSE_SQUARE: [Centre; 3] = [
    (DVec3::new(0.0, 0.0, 0.0), 1.0, 0.0),
    (DVec3::new(3.0, -0.5, 1.0), 0.25, 0.0),
    (DVec3::new(-2.0, 4.0, 0.0), -0.75, 0.0),
];
const CUBIC: [Centre; 2] = [(DVec3::new(1.0, 1.0, 1.0), 0.5, 3.0), (DVec3::new(-5.0, 0.0, 2.0), -1.5, 8.0)];
const YUKAWA: [Centre; 2] = [(DVec3::new(0.5, 0.0, -4.0), 2.0, 0.5), (DVec3::new(-8.0, 1.0, 0.0), -1.0, 2.0)];

const SCENE: &str = r#"
[image]
size = [8, 8]
[camera]
position = [0, 0, 20]
look_at = [0, 0, 0]
[law]
kind = "sources"
[[law.sources]]
position = [0, 0, 0]
strength = 1
[[law.sources]]
position = [1, 1, 1]
strength = 0.5
falloff = { cubic = 3 }
[[law.sources]]
position = [0.5, 0, -4]
strength = 2
falloff = { yukawa = 0.5 }
[rays]
bounding_sphere = { radius = 50 }
"#;

/// Returns d(r) n̂ of each falloff, and the relative error of its terms.
fn pull(kind: &str, x: DVec3, (position, strength, extra): Centre) -> (DVec3, f64) {
    let d = x - position;
    let r = d.length();
    if r == 0.0 {
        return (DVec3::ZERO, 0.0);
    }
    let n = d / r;
    match kind {
        // x − c rounds once per component, which r³ contains three times, and ten operations follow.
        "inverse_square" => (-strength / (r * r) * n, 16.0 * U * strength.abs() / (r * r)),
        "cubic" => {
            let q = (r / extra).min(1.0);
            // Terms up to 3 that sum to d(r): the error comes from their roundings, not from the sum.
            (-strength * (2.0 * q.powi(3) - 3.0 * q * q + 1.0) * n, 16.0 * U * strength.abs() * (1.0 + 5.0 * q * q))
        }
        _ => {
            let m = extra * r;
            let d = (-m).exp() * (1.0 + m) / (r * r);
            // WGSL allows exp an error of 3 + 2 |m| units in the last place (2 U each), and the rounding of m counts m times.
            (-strength * d * n, (24.0 + 10.0 * m) * U * strength.abs() * d)
        }
    }
}

fn centres() -> impl Iterator<Item = (&'static str, Centre)> {
    let named = |kind: &'static str, list: &'static [Centre]| list.iter().map(move |c| (kind, *c));
    named("inverse_square", &INVERSE_SQUARE).chain(named("cubic", &CUBIC)).chain(named("yukawa", &YUKAWA))
}

fn probe() -> Probe {
    let parts = [
        "segment/ray",
        "state/loops",
        "law/phase_space",
        "law/sources",
        "law/falloff/inverse_square",
        "law/falloff/cubic",
        "law/falloff/yukawa",
    ];
    Probe::new(&parts)
        .generated(SCENE, "generated/sources.wgsl")
        .list(
            "inverse_square",
            "INVERSE_SQUARE_COUNT",
            INVERSE_SQUARE.map(|(p, s, _)| about_a_point(vec![("position", V3(p)), ("strength", Float(s))])),
        )
        .list(
            "cubic",
            "CUBIC_COUNT",
            CUBIC.map(|(p, s, e)| {
                about_a_point(vec![("position", V3(p)), ("strength", Float(s)), ("radius", Float(e))])
            }),
        )
        .list(
            "yukawa",
            "YUKAWA_COUNT",
            YUKAWA.map(|(p, s, e)| about_a_point(vec![("position", V3(p)), ("strength", Float(s)), ("mu", Float(e))])),
        )
}

#[test]
fn falloffs_one_by_one_and_summed() {
    let mut inputs = phases(21, [0.01, 1e4], [1e-3, 1e3]);
    // Near and on the rims of the cubic centers, and near every center.
    for (_, (position, _, extra)) in centres() {
        for d in super::awkward_directions() {
            for r in [extra * (1.0 - 1e-6), extra, extra * (1.0 + 1e-6), 1e-3, 1e-2] {
                if r > 0.0 {
                    inputs.push([(position + d.as_dvec3() * r).as_vec3().extend(0.0), d.extend(0.0)]);
                }
            }
        }
    }
    let body = format!(
        "{LAW}
        put(6u, vec4f(inverse_square_acceleration(p0.xyz), inverse_square_distance(p0.xyz)));
        put(7u, vec4f(cubic_acceleration(p0.xyz), cubic_distance(p0.xyz)));
        put(8u, vec4f(yukawa_acceleration(p0.xyz), yukawa_distance(p0.xyz)));"
    );
    let out = probe().run::<2, 9>(&gpu(), &body, &inputs);
    let kinds = ["inverse_square", "cubic", "yukawa"];
    let mut each = kinds.map(Errors::of);
    let (mut sums, mut scales) = (Errors::of("sources, summed"), Errors::of("sources scale"));
    for (input, output) in inputs.iter().zip(&out) {
        keeps_phase(input, output);
        let x = wide(input[0]);
        let speed = wide(input[1]).length();
        let (mut all, mut all_bound, mut all_near) = (DVec3::ZERO, 0.0, f64::INFINITY);
        for (k, kind) in kinds.iter().enumerate() {
            let (mut sum, mut bound, mut near) = (DVec3::ZERO, 0.0, f64::INFINITY);
            for (_, centre) in centres().filter(|(name, _)| name == kind) {
                let (a, error) = pull(kind, x, centre);
                sum += a;
                bound += error + 4.0 * U * a.length();
                let floor = if *kind == "cubic" { 0.02 * centre.2 } else { 0.0 };
                near = near.min((x - centre.0).length().max(floor));
            }
            each[k].check3(output[6 + k], sum, bound, input);
            each[k].check(output[6 + k].w, near, 6.0 * U * near, input);
            all += sum;
            all_bound += bound + 2.0 * U * sum.length();
            all_near = all_near.min(near);
        }
        sums.check3(output[1], all, all_bound, input);
        scales.check(output[0].w, all_near / speed, 12.0 * U * all_near / speed, input);
    }
    for errors in each.iter().chain([&sums, &scales]) {
        errors.report();
    }
}

/// At its center the cubic falloff has no direction but must be finite; outside R it is exactly 0.
#[test]
fn cubic_at_its_centre_and_outside() {
    let inputs =
        [[CUBIC[0].0.as_vec3().extend(0.0)], [Vec4::new(20.0, 0.0, 0.0, 0.0)], [Vec4::new(0.0, -1e6, 0.0, 0.0)]];
    let out =
        probe().run::<1, 1>(&gpu(), "put(0u, vec4f(cubic_acceleration(p0.xyz), cubic_distance(p0.xyz)));", &inputs);
    let (alone, _) = pull("cubic", CUBIC[0].0, CUBIC[1]);
    assert!((wide(out[0][0]) - alone).length() < 1e-6, "{} is not {alone}", out[0][0]);
    assert!(out[0][0].w > 0.0, "steps may not shrink to nothing at a cubic center");
    assert_eq!((wide(out[1][0]), wide(out[2][0])), (DVec3::ZERO, DVec3::ZERO));
}

/// The displacement from a line is the part of d across its direction: u × (d × u).
#[test]
fn the_way_from_a_line_is_across_it() {
    let inputs = phases(22, [0.01, 1e4], [1e-3, 1e3]).into_iter().flat_map(|[place, _]| {
        super::awkward_directions().into_iter().map(move |u| [place, u.normalize().extend(0.0)])
    });
    let inputs: Vec<_> = inputs.collect();
    let body = "put(0u, vec4f(offset_line(p0.xyz, p1.xyz), 0.0));";
    let out = Probe::new(&["law/offset"]).run::<2, 1>(&gpu(), body, &inputs);
    let mut errors = Errors::of("way from a line");
    for (input, output) in inputs.iter().zip(&out) {
        let (d, u) = (wide(input[0]), wide(input[1]).normalize());
        // u is a unit vector up to 2 U, and the dot product rounds six times before its multiple is subtracted.
        errors.check3(output[0], u.cross(d.cross(u)), 16.0 * U * d.length(), input);
    }
    errors.report();
}
