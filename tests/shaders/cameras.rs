//! Tests the starts and directions of a camera's rays.

use bentray::model::Value::{Float, Vec2, Vec3 as V3};
use bentray::program::constant;
use glam::{DVec2, DVec3, Vec4};

use super::reals::{REALS, U64, joined, joined3, split};
use super::{Errors, Random, U, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

const RADIUS: f64 = 50.0;

/// Looks along a slanted line, with an image twice as wide as it is high; every number is exact in f32.
fn camera(position: DVec3) -> (Record, [DVec3; 3]) {
    let axes = [DVec3::new(0.6, 0.0, -0.8), DVec3::new(0.8, 0.0, 0.6), DVec3::new(0.0, 0.5, 0.0)]
        .map(|v| v.as_vec3().as_dvec3());
    let record = ["position", "forward", "right", "up"].into_iter().zip([position, axes[0], axes[1], axes[2]]);
    (record.map(|(name, v)| (name, V3(v))).collect(), axes)
}

#[test]
fn pinhole_and_plane() {
    let gpu = gpu();
    let mut random = Random::new(141);
    let mut inputs: Vec<[Vec4; 1]> =
        [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[x, y]| [Vec4::new(x, y, 0.0, 0.0)]).into();
    inputs.extend(
        (0..2000).map(|_| [Vec4::new(random.within(-1.0, 1.0) as f32, random.within(-1.0, 1.0) as f32, 0.0, 0.0)]),
    );
    let body =
        "let ray = arrived(camera_ray(p0.xy)); put(0u, vec4f(ray.x, f32(ray.status))); put(1u, vec4f(ray.d, 0.0));";
    // Positions inside the bounding sphere, and outside, where most rays of the pinhole and some orthographic rays miss it.
    for position in [DVec3::new(1.0, -2.0, 4.0), DVec3::new(-75.0, 8.0, 64.0)] {
        for kind in ["pinhole", "plane"] {
            let (record, [forward, right, up]) = camera(position);
            let scale = if kind == "plane" { 40.0 } else { 1.0 };
            let stretched = record.into_iter().map(|(name, v)| match (name, v) {
                ("right" | "up", V3(v)) => (name, V3(v * scale)),
                other => other,
            });
            let part = format!("camera/{kind}");
            let probe = Probe::new(&[
                "segment/ray",
                "law/bound",
                "law/leaving",
                "camera/ray",
                "camera/arrival",
                "camera/frame_coordinate",
                &part,
            ])
            .bind("camera", [stretched.collect::<Record>()])
            .bind("bound", [vec![("center", V3(DVec3::ZERO)), ("radius", Float(RADIUS))]]);
            let [mut directions, mut starts] = ["camera's directions", "camera's starts"].map(Errors::of);
            let mut missed = 0;
            for (input, output) in inputs.iter().zip(&probe.run::<1, 2>(&gpu, body, &inputs)) {
                let p = wide(input[0]);
                let across = scale * (p.x * right + p.y * up);
                let (x, d) = if kind == "plane" {
                    (position + across, forward)
                } else {
                    (position, (forward + across).normalize())
                };
                directions.check3(output[1], d, 6.0 * U, input);
                let b = x.dot(d) / d.length_squared();
                let inside = RADIUS * RADIUS - (x - b * d).length_squared();
                // The nearest point errs by 16 U |x|.
                let unsure = 2.0 * RADIUS * 16.0 * U * x.length();
                let outside = x.length() > RADIUS;
                if outside && inside.abs() < unsure {
                    continue;
                }
                let misses = outside && (inside < 0.0 || b > 0.0);
                assert_eq!(
                    f64::from(output[0].w),
                    if misses { constant("segment/ray", "MISSED") } else { 0.0 },
                    "{kind} at {input:?}"
                );
                missed += u32::from(misses);
                let start = if outside && !misses { x - (b + inside.sqrt()) * d } else { x };
                let root = if outside { unsure / inside.abs().sqrt() } else { 0.0 };
                starts.check3(output[0], start, 16.0 * U * x.length() + root, input);
            }
            println!("{kind}: {missed} of {} miss the bounding sphere", inputs.len());
            assert_eq!(missed > 100, position.length() > RADIUS, "{kind}: {missed} missed");
            directions.report();
            starts.report();
        }
    }
}

const PRECISIONS: [(&str, f64); 2] = [("real/f32", U), ("real/f64", U64)];

/// The errors relative to their bounds, in one precision.
struct Ratio {
    what: String,
    worst: f64,
    /// The error as a fraction of the bound.
    share: f64,
    at: String,
}

impl Ratio {
    fn of(what: String) -> Self {
        Self { what, worst: 0.0, share: 0.0, at: String::new() }
    }

    fn check(&mut self, got: DVec3, want: DVec3, bound: f64, at: impl std::fmt::Debug) {
        let error = (got - want).abs().max_element();
        let error = if error.is_finite() { error } else { f64::INFINITY };
        self.worst = self.worst.max(error);
        if error / bound > self.share {
            (self.share, self.at) = (error / bound, format!("{got} for {want} at {at:?}"));
        }
    }

    fn report(&self) {
        println!("{}: error at most {:.1e}, {:.2} of its bound", self.what, self.worst, self.share);
        assert!(self.share > 0.0 && self.share <= 1.0, "{}: {}", self.what, self.at);
    }
}

/// Sine and cosine of quarter turns. Whole quarter turns are exact; the remainder, at most π/4, is rounded twice. A sine
/// has two more roundings, and a cosine has two near 1.
#[test]
fn quarter_turns() {
    let mut random = Random::new(142);
    let mut inputs: Vec<f64> = (0..4000).map(|_| random.within(-30.0, 30.0)).collect();
    inputs.extend((0..1000).map(|_| random.log(1e-30, 1e5)));
    inputs.extend((-80..80).flat_map(|k| [f64::from(k) / 4.0, f64::from(k) / 4.0 + 1e-6]));
    for (real, u) in PRECISIONS {
        let inputs: Vec<f64> =
            if u == U { inputs.iter().map(|q| f64::from(*q as f32)).collect() } else { inputs.clone() };
        let rows: Vec<[Vec4; 1]> = inputs.iter().map(|q| [split(*q)]).collect();
        let body = "let turned = quarters_sin_cos(real(p0)); put_real(0u, turned.x); put_real(1u, turned.y);";
        let out = Probe::new(&[real]).stub(REALS).run::<1, 2>(&gpu(), body, &rows);
        let mut errors = Ratio::of(format!("{real}: quarters_sin_cos"));
        for (q, output) in inputs.iter().zip(&out) {
            let (sine, cosine) = ((q - (q / 4.0).round() * 4.0) * std::f64::consts::FRAC_PI_2).sin_cos();
            // On the CPU, π/2 and the sine err by U64.
            let got = DVec3::new(joined(output[0]), joined(output[1]), 0.0);
            errors.check(got, DVec3::new(sine, cosine, 0.0), 3.0 * u + 6.0 * U64, q);
        }
        errors.report();
    }
}

/// The whole image, its center and the area around it, edges and corners.
fn points(seed: u64) -> Vec<[Vec4; 1]> {
    let mut random = Random::new(seed);
    let mut all: Vec<[f64; 2]> = (0..3000).map(|_| [random.within(-1.0, 1.0), random.within(-1.0, 1.0)]).collect();
    for size in [0.0, 1e-30, 1e-20, 1e-7, 1e-3, 0.5, 1.0] {
        all.extend([[size, 0.0], [-size, 0.0], [0.0, size], [0.0, -size], [size, -size]]);
    }
    all.into_iter().map(|[x, y]| [Vec4::new(x as f32, y as f32, 0.0, 0.0)]).collect()
}

/// Slanted axes at right angles, as numbers of f32.
fn slanted() -> [DVec3; 3] {
    [DVec3::new(0.48, 0.6, -0.64), DVec3::new(0.8, 0.0, 0.6), DVec3::new(0.36, -0.8, -0.48)]
        .map(|v| v.as_vec3().as_dvec3())
}

/// Returns the directions of a camera at `points`, and whether there is a ray.
fn directions(part: &str, real: &str, own: Record, inputs: &[[Vec4; 1]]) -> Vec<(DVec3, bool)> {
    let [forward, right, up] = slanted();
    let position = DVec3::new(1.0, -2.0, 4.0);
    let axes = [("position", position), ("forward", forward), ("right", right), ("up", up)];
    let record: Record = axes.map(|(name, v)| (name, V3(v))).into_iter().chain(own).collect();
    let probe = Probe::new(&["segment/ray", "camera/ray", part, real]).stub(REALS).bind("camera", [record]);
    let body =
        "let ray = camera_ray(Real2(p0.xy)); put_real3(0u, ray.d); put(3u, vec4f(vec3f(ray.x), f32(ray.status)));";
    let rows = probe.run::<1, 4>(&gpu(), body, inputs);
    let outside = constant("segment/ray", "OUTSIDE") as f32;
    rows.iter()
        .map(|row| {
            assert_eq!(wide(row[3]), position);
            assert!(row[3].w == 0.0 || row[3].w == outside, "status {}", row[3].w);
            (joined3(row), row[3].w == 0.0)
        })
        .collect()
}

#[test]
fn fisheye() {
    let inputs = points(143);
    let [forward, right, up] = slanted();
    for (real, u) in PRECISIONS {
        for (fov, sides) in
            [(2.0, [2.0, 1.0]), (180.0, [1.0, 1.0]), (360.0, [1.0, 1.5]), (1000.0, [2.0, 1.0]), (3600.0, [1.0, 1.0])]
        {
            let sides = DVec2::from(sides);
            let own = vec![("sides", Vec2(sides)), ("quarters", Float(fov / 180.0))];
            let mut errors = Ratio::of(format!("{real}: a fisheye of {fov}°"));
            let mut none = 0;
            for (input, (d, there)) in inputs.iter().zip(directions("camera/fisheye", real, own, &inputs)) {
                let p = wide(input[0]).truncate() * sides;
                let rho = p.x.hypot(p.y);
                let angle = (rho * 0.5 * fov).to_radians();
                let outwards = if rho > 0.0 { (p.x * right + p.y * up) / rho } else { DVec3::ZERO };
                // ρ errs by 3 U of it, the scale and the product of the angle by one rounding each, and the sum of the axes by 8 U.
                let bound = 5.0 * u * angle + 8.0 * u;
                errors.check(d, angle.cos() * forward + angle.sin() * outwards, bound, input);
                if (rho - 1.0).abs() > 3.0 * u {
                    assert_eq!(there, rho <= 1.0, "{fov}° at {input:?}");
                }
                none += u32::from(!there);
            }
            errors.report();
            assert!(none > 500, "{none} points are outside the disk");
        }
    }
}

#[test]
fn panorama() {
    let inputs = points(144);
    let [forward, right, up] = slanted();
    for (real, u) in PRECISIONS {
        for fov in [[360.0, 180.0], [90.0, 45.0], [200.0, 7.0]] {
            let own = vec![("quarters", Vec2(DVec2::from(fov) / 180.0))];
            let mut errors = Ratio::of(format!("{real}: a panorama of {fov:?}°"));
            for (input, (d, there)) in inputs.iter().zip(directions("camera/panorama", real, own, &inputs)) {
                let [longitude, latitude] = [0, 1].map(|k| (f64::from(input[0][k]) * 0.5 * fov[k]).to_radians());
                let level = longitude.cos() * forward + longitude.sin() * right;
                let want = latitude.cos() * level + latitude.sin() * up;
                // The scale and the product of each angle have one rounding each; the sum of the axes errs by 10 U.
                errors.check(d, want, 2.0 * u * (longitude.abs() + latitude.abs()) + 10.0 * u, input);
                assert!(there);
            }
            errors.report();
        }
    }
}

/// Both eyes see each point of the plane or sphere of convergence in the position where the camera between them sees it.
#[test]
fn eyes() {
    let mut random = Random::new(145);
    let inputs: Vec<[Vec4; 1]> = (0..2000).map(|_| [random.vector(1.0, 1.0 + 1e-9).extend(0.0)]).collect();
    let [forward, ..] = slanted();
    let offset = DVec3::new(0.25, -0.125, 0.5);
    let position = DVec3::new(1.0, -2.0, 4.0);
    let distance = 2.5;
    let camera = ["position", "forward", "right", "up"].map(|name| (name, V3(forward))).to_vec();
    let body = "let ray = CameraRay(Real3(1.0, -2.0, 4.0), Real3(p0.xyz), ALIVE);
        let left = eye_ray(ray, false);
        let right = eye_ray(ray, true);
        put_real3(0u, left.x);
        put_real3(3u, left.d);
        put_real3(6u, right.x);
        put_real3(9u, right.d);";
    for (real, u) in PRECISIONS {
        for part in ["camera/eyes/parallel", "camera/eyes/crossing_plane", "camera/eyes/crossing_sphere"] {
            let mut record = vec![("offset", V3(offset))];
            if part != "camera/eyes/parallel" {
                record.push(("distance", Float(distance)));
            }
            let probe = Probe::new(&["segment/ray", "camera/ray", "camera/pinhole", part, real]).stub(REALS);
            let probe = probe.bind("stereo", [record]).bind("camera", [camera.clone()]);
            let [mut starts, mut directions] =
                ["starts", "directions"].map(|what| Ratio::of(format!("{real}: {part}'s {what}")));
            for (input, output) in inputs.iter().zip(&probe.run::<1, 12>(&gpu(), body, &inputs)) {
                let d = wide(input[0]);
                let ahead = d.dot(forward);
                if part == "camera/eyes/crossing_plane" && ahead < 0.1 {
                    continue;
                }
                let reach = if part == "camera/eyes/crossing_plane" { distance / ahead } else { distance };
                for (rows, offset) in [(&output[..6], -offset), (&output[6..], offset)] {
                    starts.check(joined3(&rows[..3]), position + offset, 4.0 * u, input);
                    let towards = position + reach * d - (position + offset);
                    let want = if part == "camera/eyes/parallel" { d } else { towards.normalize() };
                    // The dot product errs by 3 U, relative to 1 and divided by `ahead`; the point errs by that and 4 U
                    // more of its distance, of which at least 2 remains; normalizing errs by 4 U.
                    let bound = (3.0 / ahead.abs().min(1.0) + 4.0) * u * reach / towards.length() + 4.0 * u;
                    directions.check(joined3(&rows[3..]), want, bound, input);
                }
            }
            println!("{part}: starts off by {:.1e}", starts.worst);
            assert!(starts.share <= 1.0, "{}", starts.at);
            if part == "camera/eyes/parallel" {
                assert_eq!(directions.worst, 0.0, "{}", directions.at);
            } else {
                directions.report();
            }
        }
    }
}
