//! Boxes of the hierarchy, which no chord through them may miss.

use glam::{DVec3, Vec3};

use super::triangles::{grown, probe};
use super::{Random, awkward_directions, row, wide};
use crate::support::gpu;

/// Checks boxes, including flat ones, and chords along axes, on faces and from far away: every hit in f64 is found.
#[test]
fn boxes_of_the_hierarchy_are_never_missed() {
    let mut random = Random::new(104);
    let (mut boxes, mut inputs) = (Vec::new(), Vec::new());
    for k in 0..20_000 {
        let lo = random.vector(0.01, 100.0);
        let mut size = random.vector(1e-3, 10.0).abs();
        if k % 4 == 0 {
            size[k % 3] = 0.0;
        }
        let hi = lo + size;
        let inside = lo + size * Vec3::new(random.unit() as f32, random.unit() as f32, random.unit() as f32);
        // Some chords meet a face, an edge or a corner.
        let aim = if k % 3 == 0 { inside } else { Vec3::select(random.vector(1.0, 1.0).cmpgt(Vec3::ZERO), lo, inside) };
        let d = if k % 2 == 0 { awkward_directions()[k % 61] } else { random.vector(1.0, 1.0) };
        let far = random.log(0.1, 1e4) as f32;
        let a = aim - d * far;
        boxes.push([lo, hi].map(Vec3::as_dvec3));
        let [lo, hi] = grown(lo, hi);
        inputs.push([row(lo, 0.0), row(hi, 0.0), row(a, 0.0), row(a + d * far * random.within(0.5, 3.0) as f32, 0.0)]);
    }
    let body = "let d = p3.xyz - p2.xyz;
        let sweep = segment_sweep(Segment(p2.xyz, d, p3.xyz, d, 1.0));
        let whole = box_span(p0.xyz, p1.xyz, sweep, 2.0);
        let part = box_span(p0.xyz, p1.xyz, sweep, 0.25);
        put(0u, vec4f(f32(whole.enters <= whole.leaves), f32(part.enters <= part.leaves), 0.0, 0.0));";
    let (mut met, mut missed) = (0, 0);
    let spans = probe().run::<4, 1>(&gpu(), body, &inputs);
    for (([lo, hi], input), [got]) in boxes.into_iter().zip(&inputs).zip(&spans) {
        let [_, _, a, b] = input.map(wide);
        for (k, limit) in [(0, 1.0), (1, 0.25)] {
            let meets = slabs(lo, hi, a, b - a, limit);
            assert!(!meets || got[k] == 1.0, "a box that is hit before {limit} is missed: {input:?}");
            met += u32::from(meets);
        }
        missed += u32::from(got.x == 0.0);
    }
    println!("box_span: {met} of {} met, {missed} missed", 2 * inputs.len());
    assert!(met > 10_000 && missed > 500, "{met} met, {missed} missed");
}

fn slabs(lo: DVec3, hi: DVec3, a: DVec3, d: DVec3, limit: f64) -> bool {
    let (mut enters, mut leaves) = (0.0_f64, limit);
    for k in 0..3 {
        if d[k] == 0.0 {
            if a[k] < lo[k] || a[k] > hi[k] {
                return false;
            }
            continue;
        }
        let (t0, t1) = ((lo[k] - a[k]) / d[k], (hi[k] - a[k]) / d[k]);
        (enters, leaves) = (enters.max(t0.min(t1)), leaves.min(t0.max(t1)));
    }
    enters <= leaves
}
