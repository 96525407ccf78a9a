//! Segments as curves: arcs, their pieces, and the first hit along them.

use bentray::model::Value::{Float, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::{Errors, Random, U, Verdict, check_hits, row, wide};
use crate::support::{
    gpu,
    probe::{Probe, Record},
};

const TOLERANCE: f64 = 1e-3;
const BOX: [DVec3; 2] = [DVec3::new(-3.0, -2.0, -1.0), DVec3::new(1.0, 2.0, 4.0)];

const SEGMENT: &str = "let s = Segment(p0.xyz, p1.xyz, p2.xyz, p3.xyz, p0.w);\n";

/// The ends, tangents and extent of an arc.
struct Hermite {
    x0: DVec3,
    c: DVec3,
    a: DVec3,
    b: DVec3,
    size: f64,
}

impl Hermite {
    fn of(input: &[Vec4; 4]) -> Self {
        let [x0, v0, x1, v1] = input.map(wide);
        let h = f64::from(input[0].w);
        let c = x1 - x0;
        let size = x0.length() + x1.length() + h * (v0.length() + v1.length());
        Self { x0, c, a: h * v0 - c, b: c - h * v1, size }
    }

    /// Returns a point by the standard Hermite basis polynomials.
    fn point(&self, t: f64) -> DVec3 {
        let (p0, p1, m0, m1) = (self.x0, self.x0 + self.c, self.a + self.c, self.c - self.b);
        let (t2, t3) = (t * t, t * t * t);
        (2.0 * t3 - 3.0 * t2 + 1.0) * p0 + (t3 - 2.0 * t2 + t) * m0 + (3.0 * t2 - 2.0 * t3) * p1 + (t3 - t2) * m1
    }

    /// Returns a bound on the distance of a chord over 1/n of the arc: an eighth of the largest second derivative, which is at an end.
    fn chord_error(&self, n: f64) -> f64 {
        (4.0 * self.a - 2.0 * self.b).length().max((2.0 * self.a - 4.0 * self.b).length()) / (8.0 * n * n)
    }
}

/// Returns arcs that bend one way, arcs that bend both ways, straight ones, and ones of zero length.
fn arcs(seed: u64, count: usize) -> Vec<[Vec4; 4]> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|k| {
            let x0 = random.vector(0.1, 8.0);
            let h = random.log(0.05, 4.0);
            let v0 = random.direction();
            let x1 = x0.as_dvec3() + h * (v0 + random.direction() * random.log(1e-4, 0.3));
            let c = (x1 - x0.as_dvec3()) / h;
            let v1 = match k % 4 {
                0 => 2.0 * c - v0,
                1 => v0,
                2 => v0 + random.direction() * 0.3,
                _ => c,
            };
            let v0 = if k % 4 == 3 { c } else { v0 };
            [row(x0, h as f32), row(v0.as_vec3(), 0.0), row(x1.as_vec3(), 0.0), row(v1.as_vec3(), 0.0)]
        })
        .collect()
}

fn arc(lo: DVec3, hi: DVec3) -> Record {
    vec![("tolerance", Float(TOLERANCE)), ("lo", V3(lo)), ("hi", V3(hi))]
}

#[test]
fn arcs_are_hermite_curves() {
    let gpu = gpu();
    let inputs = arcs(71, 3000);
    let body = format!(
        "{SEGMENT}put(0u, vec4f(segment_point(s, 0.0), f32(segment_pieces(s))));
        put(1u, vec4f(piece_end(s, 6u, 7u), 0.0));
        put(2u, vec4f(segment_point(s, 0.125), 0.0));
        put(3u, vec4f(segment_point(s, 0.6), 0.0));
        put(4u, vec4f(segment_point(s, 1.0), 0.0));
        put(5u, vec4f(segment_fraction(2u, 5u, 0.5), segment_fraction(4u, 5u, 1.00001), segment_fraction(0u, 5u, -1e-5), 0.0));"
    );
    let everything = arc(DVec3::splat(-1e3), DVec3::splat(1e3));
    let probe = Probe::new(&["segment/ray", "segment/curve_arc", "segment/pieces"]).bind("arc", [everything]);
    let mut errors = Errors::of("segment_point");
    let mut worst = 0.0_f64;
    for (input, output) in inputs.iter().zip(&probe.run::<4, 6>(&gpu, &body, &inputs)) {
        let curve = Hermite::of(input);
        assert_eq!(output[0].truncate(), input[0].truncate(), "the start, exactly");
        assert_eq!(output[1].truncate(), input[2].truncate(), "the end, exactly");
        for (k, t) in [(2, 0.125), (3, f64::from(0.6_f32)), (4, 1.0)] {
            errors.check3(output[k], curve.point(t), 6.0 * U * curve.size, input);
        }
        assert!((output[5].x - 0.5).abs() < 1e-6 && output[5].y < 1.0 && output[5].z == 0.0, "{}", output[5]);
        let pieces = output[0].w;
        assert!((1.0..=16.0).contains(&pieces) && pieces.fract() == 0.0, "{pieces} pieces");
        if pieces < 16.0 {
            worst = worst.max(chord_distance(&curve, f64::from(pieces)));
        }
    }
    errors.report();
    println!("chords are up to {worst:.2e} from their arcs, at a tolerance of {TOLERANCE:.0e}");
    assert!(worst <= TOLERANCE * 1.001, "a chord is {worst} from its arc");
    let body = format!(
        "{SEGMENT}put(0u, vec4f(segment_point(s, 0.0), f32(segment_pieces(s)))); put(1u, vec4f(segment_point(s, 1.0), 0.0));"
    );
    for (input, output) in
        inputs.iter().zip(&Probe::new(&["segment/ray", "segment/curve_line"]).run::<4, 2>(&gpu, &body, &inputs))
    {
        assert_eq!(
            (output[0], output[1].truncate()),
            (row(input[0].truncate(), 1.0), input[2].truncate()),
            "a line's ends"
        );
    }
}

/// Returns the largest sampled distance of the curve from n chords.
fn chord_distance(curve: &Hermite, n: f64) -> f64 {
    let mut worst = 0.0_f64;
    for k in 0..n as u32 {
        let at = |t: f64| curve.point((f64::from(k) + t) / n);
        let (p, q) = (at(0.0), at(1.0));
        for i in 1..8 {
            let x = at(f64::from(i) / 8.0);
            let along = ((x - p).dot(q - p) / (q - p).length_squared()).clamp(0.0, 1.0);
            worst = worst.max((x - p - along * (q - p)).length());
        }
    }
    worst
}

#[test]
fn arcs_far_from_the_scene_have_no_pieces() {
    let inputs = arcs(72, 4000);
    let probe = Probe::new(&["segment/ray", "segment/curve_arc"]).bind("arc", [arc(BOX[0], BOX[1])]);
    let body = format!("{SEGMENT}put(0u, vec4f(f32(segment_pieces(s))));");
    let (mut inside, mut skipped) = (0, 0);
    for (input, [pieces]) in inputs.iter().zip(&probe.run::<4, 1>(&gpu(), &body, &inputs)) {
        let curve = Hermite::of(input);
        let meets = (0..=64).any(|k| {
            let x = curve.point(f64::from(k) / 64.0);
            x.cmpge(BOX[0]).all() && x.cmple(BOX[1]).all()
        });
        assert!(!meets || pieces.x >= 1.0, "an arc through the scene's box is skipped: {input:?}");
        // Bézier points, in f64.
        let points = [
            curve.x0,
            curve.x0 + (curve.a + curve.c) / 3.0,
            curve.x0 + curve.c,
            curve.x0 + curve.c - (curve.c - curve.b) / 3.0,
        ];
        let lo = points.iter().copied().reduce(DVec3::min).expect("four");
        let hi = points.iter().copied().reduce(DVec3::max).expect("four");
        let margin = 8.0 * U * curve.size;
        let apart = (lo - BOX[1]).max(BOX[0] - hi).max_element();
        if apart > margin {
            assert_eq!(pieces.x, 0.0, "{input:?} is {apart} away");
            skipped += 1;
        }
        inside += u32::from(meets);
    }
    println!("{inside} arcs meet the box, {skipped} have no pieces, of {}", inputs.len());
    assert!(inside > 400 && skipped > 400);
}

/// Compares with hits of the curve itself: the chords may be hit earlier, later or not at all, up to their tolerance.
#[test]
fn first_hit_of_arcs_in_several_pieces() {
    let spheres =
        [(DVec3::new(0.0, 0.0, 0.0), 1.0), (DVec3::new(3.0, 1.0, 0.0), 0.5), (DVec3::new(-2.0, 2.0, 2.0), 1.5)];
    let mut inputs = arcs(73, 6000);
    let mut random = Random::new(74);
    for (k, input) in inputs.iter_mut().enumerate() {
        // The curves pass near a sphere.
        let (center, radius) = spheres[k % 3];
        let shift = (center + random.direction() * radius * random.within(0.0, 1.5)).as_vec3()
            - (0.5 * (input[0] + input[2])).truncate();
        *input = [input[0] + row(shift, 0.0), input[1], input[2] + row(shift, 0.0), input[3]];
    }
    let records = spheres.map(|(center, radius)| vec![("center", V3(center)), ("radius", Float(radius))]);
    let parts = [
        "segment/ray",
        "state/loops",
        "segment/curve_arc",
        "segment/pieces",
        "segment/walk",
        "segment/lists",
        "shape/placed",
        "shape/sphere",
    ];
    let probe = Probe::new(&parts)
        .with("HAS_LISTS")
        .with("HAS_OBJECTS")
        .stub(
            "fn piece_hit(a: vec3f, b: vec3f, best: Hit) -> Hit {
                var hit = best;
                for (var i = 0u; i < SPHERE_COUNT; i++) {
                    hit = nearer_hit(hit, hit_sphere(sphere_list[i], SPHERE | i, a, b - a), SPHERE | i);
                }
                return hit;
            }",
        )
        .bind("arc", [arc(DVec3::splat(-4.0), DVec3::splat(4.0))])
        .list("sphere_list", "SPHERE_COUNT", records);
    let body = format!(
        "{SEGMENT}let hit = first_hit(s, NEAR_STRUCTURE | NEAR_LISTED, vec2u(0u));
        let missed = hit.primitive == NOTHING;
        put(0u, vec4f(select(hit.t, 2.0, missed), select(f32(hit.primitive & PRIMITIVE_INDEX), -1.0, missed), f32(segment_pieces(s)), 0.0));"
    );
    let out = probe.run::<4, 1>(&gpu(), &body, &inputs);
    let mut gaps = Errors::of("a hit's distance from its sphere");
    let mut several = 0;
    let cases: Vec<_> = inputs
        .iter()
        .zip(&out)
        .map(|(input, [hit])| {
            let curve = Hermite::of(input);
            let apart = curve.chord_error(f64::from(hit.z.max(1.0))) + 20.0 * U * curve.size;
            if hit.x < 1.5 {
                let (center, radius) = spheres[hit.y as usize];
                gaps.check(
                    ((curve.point(f64::from(hit.x)) - center).length() - radius) as f32,
                    0.0,
                    1.01 * apart,
                    input,
                );
                several += u32::from(hit.z > 2.0);
            }
            let results = [apart, -apart].map(|grown| first_crossing(&curve, &spheres, grown));
            (hit.x, Verdict::of(&results), 1e-3, format!("{input:?}, {} pieces", hit.z))
        })
        .collect();
    check_hits("first_hit of arcs", 0.1, cases);
    assert!(several > 300, "{several} hits of arcs in several pieces");
    gaps.report();
}

/// Returns the first crossing of the curve with a sphere, inward or outward, by small steps and bisection.
fn first_crossing(curve: &Hermite, spheres: &[(DVec3, f64)], grown: f64) -> Option<f64> {
    let gap = |t: f64, s: &(DVec3, f64)| (curve.point(t) - s.0).length() - s.1 - grown;
    for k in 0..256 {
        let (t0, t1) = (f64::from(k) / 256.0, f64::from(k + 1) / 256.0);
        let crossings = spheres.iter().filter(|s| (gap(t0, s) < 0.0) != (gap(t1, s) < 0.0));
        let first = crossings
            .map(|s| {
                let (mut lo, mut hi) = (t0, t1);
                for _ in 0..30 {
                    let mid = f64::midpoint(lo, hi);
                    if (gap(mid, s) < 0.0) == (gap(t0, s) < 0.0) { lo = mid } else { hi = mid }
                }
                hi
            })
            .reduce(f64::min);
        if first.is_some() {
            return first;
        }
    }
    None
}
