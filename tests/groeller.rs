//! Tests the two methods of G95: the iteration as printed, and the law by arc length that it approximates.

use bentray::render::{RenderSettings, Status, Traced, trace};
use glam::DVec3;

use crate::support::{gpu, scene};

/// Two centers and a line, with every falloff.
const SOURCES: &str = "[[law.sources]]\nposition = [0, 1, 0]\nstrength = S1\n\
    [[law.sources]]\nposition = [2, -2, 1]\nstrength = S2\nfalloff = { cubic = 4 }\n\
    [[law.sources]]\nkind = \"line\"\nposition = [-2, -3, 0]\ndirection = [0, 0.3, 1]\nstrength = S3\n";

/// Returns sources with their strengths multiplied by `part`.
fn sources(part: f64) -> String {
    let numbers = [0.4, -0.3, 0.2].map(|strength| format!("{}", part * strength));
    SOURCES.replace("S1", &numbers[0]).replace("S2", &numbers[1]).replace("S3", &numbers[2])
}

/// Returns the sum of their accelerations, and of their potentials.
fn force(x: DVec3) -> (DVec3, f64) {
    let along = DVec3::new(0.0, 0.3, 1.0).normalize();
    let off = x - DVec3::new(-2.0, -3.0, 0.0);
    let (first, second, third) = (x - DVec3::Y, x - DVec3::new(2.0, -2.0, 1.0), off - off.dot(along) * along);
    let inverse = |m: f64, d: DVec3| (-m * d / d.length().powi(3), -m / d.length());
    let r = second.length();
    let inside = r < 4.0;
    let cubic = if inside {
        let pull = 2.0 * (r / 4.0_f64).powi(3) - 3.0 * (r / 4.0_f64).powi(2) + 1.0;
        (0.3 * pull / r * second, -0.3 * (r.powi(4) / 128.0 - r.powi(3) / 16.0 + r - 2.0))
    } else {
        (DVec3::ZERO, 0.0)
    };
    let all = [inverse(0.4, first), cubic, inverse(0.2, third)];
    all.into_iter().fold((DVec3::ZERO, 0.0), |(a, v), (own, potential)| (a + own, v + potential))
}

const STARTS: [[f64; 6]; 4] = [
    [-8.0, 0.5, 0.3, 1.0, 0.0, 0.1],
    [-8.0, -1.5, 0.0, 0.9, 0.1, -0.1],
    [0.0, 8.0, 2.0, 0.1, -1.2, -0.2],
    [7.0, -5.0, -1.0, -1.0, 0.3, 0.2],
];

fn ends(law: &str, rays: &str) -> Vec<Traced> {
    let text = format!("[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = 40 }}\nmax_segments = 100000\n{rays}\n");
    trace(&gpu(), &scene(&text), &RenderSettings::default(), &STARTS).unwrap().0
}

/// Returns the end of a literal implementation of Table 1.
fn iterated(start: [f64; 6], step: f64, steps: u32, next: impl Fn(DVec3, DVec3) -> DVec3) -> DVec3 {
    let (mut x, mut v) = (DVec3::from_slice(&start[..3]), DVec3::from_slice(&start[3..]));
    for _ in 0..steps {
        (x, v) = (x + step * v.normalize(), next(x, v));
    }
    x
}

#[test]
fn the_iteration_is_as_printed() {
    let rays = "method = \"groeller\"\nstep = 0.25\nmax_parameter = 10\nprecision = \"f64\"";
    let forces = ends(&format!("kind = \"sources\"\n{}", sources(0.25)), rays);
    for (start, end) in STARTS.into_iter().zip(forces) {
        let want = iterated(start, 0.25, 40, |x, v| v + 0.25 * force(x).0);
        assert_eq!(end.status, Status::Ended);
        assert!(DVec3::from(end.x).distance(want) < 1e-9, "{end:?} {want}");
    }
    // The first v of a flow is also the field.
    let field = |x: DVec3| DVec3::new(-(x.y + x.z), x.x + 0.375 * x.y, 2.0 + x.z * (x.x - 4.0));
    for (start, end) in STARTS.into_iter().zip(ends("kind = \"rossler\"", rays)) {
        let v = field(DVec3::new(start[0], start[1], start[2]));
        let want = iterated([start[0], start[1], start[2], v.x, v.y, v.z], 0.25, 40, |x, _| field(x));
        assert!(DVec3::from(end.x).distance(want) < 1e-8, "{end:?} {want}");
    }
}

/// The rays with M h instead of M converge to those by arc length at the rate of the Euler method.
#[test]
fn the_iteration_comes_to_the_law_by_length() {
    let law = |part: f64| format!("kind = \"sources\"\n{}", sources(part));
    let by_length = format!("kind = \"sources\"\nparameter = \"length\"\n{}", sources(1.0));
    let exact = ends(&by_length, "tolerance = 1e-12\nmax_parameter = 12\nprecision = \"f64\"");
    let off = |h: f64| {
        let rays = format!("method = \"groeller\"\nstep = {h}\nmax_parameter = 12\nprecision = \"f64\"");
        let found = ends(&law(h), &rays);
        found.iter().zip(&exact).map(|(a, b)| a.distance_to(b)).collect::<Vec<_>>()
    };
    for (coarse, fine) in off(0.002).into_iter().zip(off(0.001)) {
        let ratio = coarse / fine;
        assert!((1.7..2.3).contains(&ratio), "{coarse:e} to {fine:e}");
    }
    // With time as the parameter the path is different.
    let by_time = ends(&law(1.0), "tolerance = 1e-12\nmax_parameter = 12\nprecision = \"f64\"");
    assert!(by_time.iter().zip(&exact).all(|(a, b)| a.distance_to(b) > 1e-2));
}

/// Checks that |v| + V is constant, τ is the path length, and segments are on the path.
#[test]
fn the_law_by_length_keeps_what_it_says() {
    let law = format!("kind = \"sources\"\nparameter = \"length\"\n{}", sources(1.0));
    let sum = |x: DVec3, v: DVec3| v.length() + force(x).1;
    for rays in [
        "tolerance = 1e-12\nmax_parameter = 12\nprecision = \"f64\"",
        "scaled_step = 0.02\nmax_parameter = 12\nprecision = \"f64\"",
    ] {
        for (start, end) in STARTS.into_iter().zip(ends(&law, rays)) {
            let before = sum(DVec3::from_slice(&start[..3]), DVec3::from_slice(&start[3..]));
            let after = sum(end.x.into(), end.v.into());
            assert!((before - after).abs() < 1e-6, "{rays}: {before} {after}");
            assert!((end.tau - 12.0).abs() < 1e-9);
        }
    }
    // A wall hit by long arcs and by short ones.
    let wall = "[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\ncenter = [3, 0, 0]\nradius = 2.5\nmaterial = \"m\"\n";
    let met = |step: &str| ends(&law, &format!("{step}\nprecision = \"f64\"\n{wall}"));
    let [long, short] = [met("tolerance = 1e-7"), met("tolerance = 1e-11")];
    assert!(long.iter().filter(|end| end.status == Status::Hit).count() >= 2);
    for (a, b) in long.iter().zip(&short) {
        assert!(a.status == b.status && a.distance_to(b) < 1e-4, "{a:?} {b:?}");
    }
}
