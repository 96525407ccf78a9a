//! Where a camera's rays start and where they point.

use bentray::gpu::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::{Errors, Random, U, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

const RADIUS: f64 = 50.0;

/// Looks along a slanted line, with a picture twice as wide as it is high; every number is exact in f32.
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
        "let ray = arrived(camera_ray(p0.xy)); put(0u, vec4f(ray.x, f32(ray.missed))); put(1u, vec4f(ray.d, 0.0));";
    // Inside the bounding sphere, and outside, where most rays of the pinhole and some of the plane miss it.
    for position in [DVec3::new(1.0, -2.0, 4.0), DVec3::new(-75.0, 8.0, 64.0)] {
        for kind in ["pinhole", "plane"] {
            let (record, [forward, right, up]) = camera(position);
            let scale = if kind == "plane" { 40.0 } else { 1.0 };
            let stretched = record.into_iter().map(|(name, v)| match (name, v) {
                ("right" | "up", V3(v)) => (name, V3(v * scale)),
                other => other,
            });
            let part = format!("camera/{kind}");
            let probe = Probe::new(&["bound", "camera/ray", "arrival/straight", "frame/coordinate", &part])
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
                assert_eq!(output[0].w == 1.0, misses, "{kind} at {input:?}");
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
