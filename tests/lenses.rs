//! Tests rays through media inside objects, against values with 15 digits.
//!
//! A traced ray continues in air after the object, up to the bounding sphere. The rays of the tables are extended to it in 64
//! bits, and the effect of one input rounding on a position grows by its effect on the direction, times the distance.

use std::collections::BTreeMap;

use bentray::render::{RenderSettings, Status, Traced, trace, trace_paths};
use glam::DVec3;

use crate::support::lens::{Fate, Lens, lens_scene, lenses};
use crate::support::{gpu, scene};

/// The keys that every scene here has in [rays] in addition to its bounding sphere.
const EXACT: &str = "";
const EXACT_IN_64_BITS: &str = "precision = \"f64\"";
const STEPPED: &str = "method = \"dormand-prince\"\ntolerance = 1e-6\nmax_segments = 4000";

/// Returns `true` if the medium of the row has no closed form.
fn needs_steps(lens: &Lens) -> bool {
    lens.object.contains("gaussian")
}

/// Returns the traced ray of each row; rows of one object share a program.
fn traced<'l>(lenses: &[&'l Lens], rays: &str) -> Vec<(&'l Lens, Traced)> {
    let mut groups: BTreeMap<String, Vec<&Lens>> = BTreeMap::new();
    for lens in lenses {
        groups.entry(lens_scene(lens, rays)).or_default().push(lens);
    }
    let gpu = gpu();
    let mut ends = Vec::new();
    for (text, lenses) in groups {
        let given = |lens: &&Lens| {
            let (x, v) = (lens.origin, lens.direction.normalize());
            [x.x, x.y, x.z, v.x, v.y, v.z]
        };
        let rays: Vec<[f64; 6]> = lenses.iter().map(given).collect();
        let (results, _) = trace(&gpu, &scene(&text), &RenderSettings::default(), &rays).unwrap();
        ends.extend(lenses.into_iter().zip(results));
    }
    ends
}

/// Checks that rays leave their object as in the table: within `floor` (of the radius of the bounding sphere, and in
/// direction) plus `roundings` times the effect of one rounding.
fn hold(lenses: &[&Lens], rays: &str, floor: f64, roundings: f64) {
    for (lens, end) in traced(lenses, rays) {
        let (x, d) = lens.end().expect("a ray that leaves");
        assert_eq!(end.status.name(), "escaped", "{}", lens.name);
        let [position, direction] = lens.sensitivity.map(|s| roundings * s);
        let way = lens.exit.map_or(0.0, |(exit, _)| exit.distance(x));
        let off = DVec3::from(end.x).distance(x) / lens.bound.radius;
        let allowed = floor.max((position + way * direction) / lens.bound.radius);
        assert!(off <= allowed, "{}: position off by {off:e} of the bound", lens.name);
        let off = DVec3::from(end.v).normalize().distance(d);
        assert!(off <= floor.max(direction), "{}: direction off by {off:e}", lens.name);
    }
}

#[test]
fn lens_scenes_load() {
    for lens in lenses() {
        for rays in [EXACT, EXACT_IN_64_BITS, STEPPED] {
            let scene = scene(&lens_scene(&lens, rays));
            assert!(scene.objects[0].interior().is_some(), "{}", lens.name);
            // The ray starts inside the bounding sphere, and ends on it.
            assert!(
                lens.origin.distance(scene.rays.bounding_sphere.center) < scene.rays.bounding_sphere.radius,
                "{}",
                lens.name
            );
            let end = lens.end().map_or(1.0, |(x, _)| {
                x.distance(scene.rays.bounding_sphere.center) / scene.rays.bounding_sphere.radius
            });
            assert!((end - 1.0).abs() < 1e-14, "{}: {end}", lens.name);
        }
    }
}

#[test]
fn closed_forms_lead_through_lenses() {
    let lenses = lenses();
    let leaving: Vec<&Lens> = lenses.iter().filter(|lens| lens.fate == Fate::Exit && !needs_steps(lens)).collect();
    assert!(leaving.len() >= 24);
    hold(&leaving, EXACT, 5e-6, 40.0);
}

#[test]
fn closed_forms_in_64_bits_lead_through_lenses() {
    let lenses = lenses();
    let leaving: Vec<&Lens> = lenses.iter().filter(|lens| lens.fate == Fate::Exit && !needs_steps(lens)).collect();
    // In 64 bits the input is not rounded.
    hold(&leaving, EXACT_IN_64_BITS, 1e-9, 0.0);
}

#[test]
fn steps_lead_through_lenses() {
    let lenses = lenses();
    // Steps cannot follow a tight spiral in 32 bits, which has a closed form.
    let followed = |lens: &&Lens| lens.fate == Fate::Exit && !lens.object.contains("inverse-r");
    let leaving: Vec<&Lens> = lenses.iter().filter(followed).collect();
    hold(&leaving, STEPPED, 2e-5, 40.0);
}

/// Rays that wind into the center of an inverse-r sphere are captured there, including rays that its surface has reflected.
#[test]
fn spirals_into_a_centre_are_captured() {
    let lenses = lenses();
    let inward = |lens: &&Lens| {
        let turned_back = lens.fate == Fate::Total && lens.object.contains("inverse-r");
        lens.fate == Fate::Centre || turned_back
    };
    let inward: Vec<&Lens> = lenses.iter().filter(inward).collect();
    assert!(inward.len() >= 6);
    for (lens, end) in traced(&inward, EXACT) {
        assert_eq!(end.status.name(), "captured", "{}", lens.name);
    }
}

/// Parallel rays through a Luneburg lens with C = 2 meet at the point of its surface that is furthest along them.
#[test]
fn a_luneburg_lens_has_one_focus() {
    let (center, radius) = (DVec3::new(0.5, -0.25, 1.0), 2.0);
    let d = DVec3::new(2.0, 1.0, -2.0) / 3.0;
    let (across, up) = d.any_orthonormal_pair();
    let text = "[rays]\nbounding_sphere = { center = [0.5, -0.25, 1.0], radius = 4 }\n[[objects]]\nshape = \"sphere\"\n\
        center = [0.5, -0.25, 1.0]\nradius = 2\ninterior = { kind = \"luneburg\", c = 2 }\n";
    // The pattern of sunflower seeds: evenly distributed, and none at the same angle.
    let ray = |i: i32| {
        let (r, angle) = (radius * (0.998 * (f64::from(i) + 0.5) / 1000.0).sqrt(), 2.399_963 * f64::from(i));
        let x = center - 3.0 * d + r * (angle.cos() * across + angle.sin() * up);
        [x.x, x.y, x.z, d.x, d.y, d.z]
    };
    let rays: Vec<[f64; 6]> = (0..1000).map(ray).collect();
    let (ends, _) = trace(&gpu(), &scene(text), &RenderSettings::default(), &rays).unwrap();
    let focus = center + radius * d;
    for (i, end) in ends.iter().enumerate() {
        assert_eq!(end.status.name(), "escaped", "ray {i}");
        let direction = DVec3::from(end.v).normalize();
        let off = (focus - DVec3::from(end.x)).reject_from_normalized(direction).length() / radius;
        assert!(off <= 1e-5, "ray {i} passes the focus at {off:e} of the radius");
    }
}

/// If a path is drawn, a ray that leaps is cut into arcs, but it ends in the correct direction after up to fifteen turns.
#[test]
fn a_drawn_spiral_ends_where_its_leap_does() {
    let gpu = gpu();
    let scene = scene(
        "[rays]\nbounding_sphere = { radius = 10 }\n[[objects]]\nshape = \"sphere\"\nradius = 2\n\
         interior = { kind = \"inverse-r\", k = 2 }\n",
    );
    let ray = |i: u32| {
        let (sine, cosine) = f64::from(i).sin_cos();
        let climb = 0.05 * f64::from(1 + i % 4);
        let (outward, onward) = (DVec3::new(cosine, sine, 0.0), DVec3::new(-sine, cosine, 0.0));
        let x = (0.02 + 0.004 * f64::from(i)) * outward;
        let v = climb * outward + (1.0 - climb * climb).sqrt() * onward;
        [x.x, x.y, x.z, v.x, v.y, v.z]
    };
    let rays: Vec<[f64; 6]> = (0..60).map(ray).collect();
    let settings = RenderSettings::default();
    let (ends, _) = trace(&gpu, &scene, &settings, &rays).unwrap();
    let paths = trace_paths(&gpu, &scene, &settings, &rays).unwrap();
    let mut worst: f64 = 0.0;
    for (end, (status, path)) in ends.iter().zip(&paths) {
        assert_eq!((end.status, *status), (Status::Escaped, Status::Escaped));
        let drawn = path.last().unwrap().v;
        worst = worst.max(DVec3::from(end.v).angle_between(DVec3::from(drawn)));
    }
    println!("off by {worst:e} rad at most");
    // The rounding errors of the leap: a ray turns by ln(R/r)/climb, and the rounding of climb by 6e-8 is a relative error of up to 1e-6.
    assert!(worst < 3e-4, "{worst:e}");
}
