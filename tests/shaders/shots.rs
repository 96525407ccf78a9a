//! Paths from a light to a position around one center, compared with conics in closed form.

use std::f64::consts::PI;

use bentray::model::Value::{Float, Uint, Vec3 as V3};
use glam::{DVec3, Vec4};

use super::{Errors, Random, U, row, wide};
use crate::support::{gpu, probe::Probe};

const SCENE: &str = "[law]\nkind = \"sources\"\n[[law.sources]]\nposition = [0, 0, 0]\nstrength = 1\n[rays]\nbounding_sphere = { radius = 50 }\n";

/// A path: its unit direction at the light and at the position, the spread there, and a condition number of its directions:
/// the change of its end in the plane per angle at the light, and its speed at the end.
type Conic = (DVec3, DVec3, f64, f64);

/// Returns u(φ) of the conic that leaves r = 1/u₀ with cot ψ = c, ψ from outward,
/// |v| = 1: M/h² + (u₀ − M/h²) cos φ − u₀ c sin φ with 1/h² = u₀²(1 + c²).
fn reciprocal(m: f64, near: f64, c: f64, angle: f64) -> f64 {
    let pull = m * near * near * (1.0 + c * c);
    pull + (near - pull) * angle.cos() - near * c * angle.sin()
}

/// Returns every path from s to x around the origin through less than a full turn: the roots of a quadratic in cot ψ, for either side.
fn conics(m: f64, s: DVec3, x: DVec3) -> Vec<Conic> {
    let (near, far) = (1.0 / s.length(), 1.0 / x.length());
    let n = s * near;
    let t = (x - x.dot(n) * n).normalize();
    let angle = x.dot(t).atan2(x.dot(n));
    let mut found = Vec::new();
    for (t, sweep) in [(t, angle), (-t, 2.0 * PI - angle)] {
        let a = m * near * near * (1.0 - sweep.cos());
        let (b, c) = (-near * sweep.sin(), a + near * sweep.cos() - far);
        let root = (b * b - 4.0 * a * c).sqrt();
        for cot in [(-b + root) / (2.0 * a), (-b - root) / (2.0 * a)] {
            let way = (1..400).map(|k| reciprocal(m, near, cot, sweep * f64::from(k) / 400.0));
            let (least, peak) = way.fold((f64::INFINITY, 0.0_f64), |(least, peak), u| (least.min(u), peak.max(u)));
            if cot.is_nan() || least <= 0.0 {
                continue;
            }
            let sine = 1.0 / (1.0 + cot * cot).sqrt();
            let h = sine / near;
            // du/dφ at the end, and dr for a change of ψ, whose cotangent changes by −1/sin².
            let bend = |d: f64| (reciprocal(m, near, cot, sweep + d) - reciprocal(m, near, cot, sweep - d)) / (2.0 * d);
            let slope = (2.0 * a * cot + b) / (sine * sine) / (far * far);
            let (outward, onward) = (sweep.cos() * n + sweep.sin() * t, sweep.cos() * t - sweep.sin() * n);
            let v = h * far * onward - h * bend(1e-5) * outward;
            let square = h * far / v.length();
            let spread = slope.abs() * square * sweep.sin().abs() / far / sine;
            let loose = peak / (far * far) / slope.abs() + peak / far / v.length();
            found.push((sine * t + sine * cot * n, v.normalize(), spread, loose));
        }
    }
    found
}

/// Checks the number of paths and each path for a thousand pairs of positions and lights around an attractive and a repulsive center.
#[test]
fn shots_about_a_centre_are_conics() {
    for m in [1.0, -0.6] {
        let mut random = Random::new(91);
        let pairs: Vec<(DVec3, DVec3)> = (0..1000)
            .map(|_| {
                let place = |random: &mut Random| random.direction() * random.within(1.5, 20.0);
                (place(&mut random).as_vec3().as_dvec3(), place(&mut random).as_vec3().as_dvec3())
            })
            .collect();
        let inputs: Vec<[Vec4; 2]> = pairs
            .iter()
            .flat_map(|(s, x)| (0..4).map(|k| [row(s.as_vec3(), k as f32), row(x.as_vec3(), 0.0)]))
            .collect();
        let centre =
            vec![("position", V3(DVec3::ZERO)), ("strength", Float(m)), ("along", V3(DVec3::Z)), ("kind", Uint(0))];
        let probe = Probe::new(&[
            "segment/ray",
            "state/loops",
            "real/math",
            "law/phase_space",
            "law/orbit",
            "law/orbit/inverse_square",
            "law/falloff/inverse_square",
            "law/capture",
            "surface/shot/shot",
            "surface/shadow/look",
            "surface/shot/planar",
        ])
        .generated(SCENE, "generated/source_counts.wgsl")
        .bind("schedule", [vec![("max_segments", Uint(1000)), ("segments", Uint(1000))]])
        .bind("inverse_square", [centre]);
        let body = "let shot = shot_at(p0.xyz, p1.xyz, u32(p0.w));
            put(0u, vec4f(shot.leaves, f32(shot.found)));
            put(1u, vec4f(shot.arrives, shot.spread));";
        let out = probe.run::<2, 2>(&gpu(), body, &inputs);
        let mut directions = Errors::of("directions of shots");
        let mut spreads = Errors::of("spreads of shots");
        let mut lost = 0;
        for ((s, x), shots) in pairs.iter().zip(out.chunks(4)) {
            let mut wanted = conics(m, *s, *x);
            let found: Vec<_> = shots.iter().filter(|shot| shot[0].w == 1.0).collect();
            // Rounding decides if two paths are about to merge, or a position is nearly behind the center.
            let angle = (x.normalize() - s.normalize()).length().min((x.normalize() + s.normalize()).length());
            if angle < 0.02 || wanted.iter().any(|(_, _, spread, _)| *spread < 0.2) {
                continue;
            }
            lost += wanted.len().abs_diff(found.len());
            for shot in found {
                let [leaves, arrives] = [shot[0], shot[1]].map(wide);
                let near = |conic: &Conic| conic.0.distance(leaves);
                wanted.sort_by(|a, b| near(a).total_cmp(&near(b)));
                let Some((at_light, at_place, spread, loose)) = wanted.first() else { continue };
                let bound = (8.0 * U * loose).max(1e-5);
                directions.check(at_light.distance(leaves).max(at_place.distance(arrives)), 0.0, bound, (s, x, m));
                // The derivative uses differences, which are as accurate as the last digits allow.
                spreads.check(f64::from(shot[1].w) / spread, 1.0, 2e-3, (s, x, m));
            }
        }
        directions.report();
        spreads.report();
        assert!(lost <= 2, "{lost} paths lost or too many");
    }
}
