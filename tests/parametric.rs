//! Rays along curves in closed form: against exact answers, against brute force in 64 bits, and against solvers.

#![allow(clippy::unreadable_literal, reason = "answers are given as they were computed")]

use std::f64::consts::TAU;
use std::fmt::Write as _;

use bentray::render::{RenderSettings, Status, Traced, trace};
use glam::DVec3;

use crate::shaders::Random;
use crate::support::{gpu, scene};

type Curve = fn(f64) -> DVec3;

/// The two curves of G95 and others: as formulas, as functions, and the greatest speed.
const FAMILIES: [([&str; 3], Curve, f64); 10] = [
    (["t^2", "t", "2"], |t| DVec3::new(t * t, t, 2.0), 8.1),
    (["cos(2*t)", "t", "sin(2*t)"], |t| DVec3::new((2.0 * t).cos(), t, (2.0 * t).sin()), 2.3),
    (["t", "0.5*sin(3*t)", "0.2*t^2"], |t| DVec3::new(t, 0.5 * (3.0 * t).sin(), 0.2 * t * t), 2.5),
    (["t*cos(2*t)", "t*sin(2*t)", "t"], |t| DVec3::new(t * (2.0 * t).cos(), t * (2.0 * t).sin(), t), 8.2),
    (
        ["3*sin(t)", "2*sin(1.7*t)", "3*cos(t) - 3"],
        |t| DVec3::new(3.0 * t.sin(), 2.0 * (1.7 * t).sin(), 3.0 * t.cos() - 3.0),
        4.6,
    ),
    (["2*t", "-t", "0.3*t"], |t| DVec3::new(2.0 * t, -t, 0.3 * t), 2.3),
    (["exp(0.5*t) - 1", "t", "-0.5*t"], |t| DVec3::new((0.5 * t).exp() - 1.0, t, -0.5 * t), 4.0),
    (["3*tanh(t - 2)", "t", "log(1 + t)"], |t| DVec3::new(3.0 * (t - 2.0).tanh(), t, (1.0 + t).ln()), 3.4),
    (["abs(t - 1.5)", "max(t, 2)", "t"], |t| DVec3::new((t - 1.5).abs(), t.max(2.0), t), 1.8),
    (
        ["t^3/10 - t", "sqrt(t + 0.01)", "2*atan(t - 2)"],
        |t| DVec3::new(t.powi(3) / 10.0 - t, (t + 0.01).sqrt(), 2.0 * (t - 2.0).atan()),
        7.1,
    ),
];

/// The range of t.
const LAST: f64 = 4.0;
/// The radius of the bounding sphere.
const RADIUS: f64 = 18.0;

/// A box: its center and half its size.
type Cuboid = (DVec3, DVec3);

fn within(random: &mut Random, reach: f64) -> DVec3 {
    DVec3::new(random.within(-reach, reach), random.within(-reach, reach), random.within(-reach, reach))
}

fn boxes(random: &mut Random, count: usize, reach: f64) -> Vec<Cuboid> {
    let size = |random: &mut Random| DVec3::splat(0.35) + within(random, 0.25);
    (0..count).map(|_| (within(random, reach), 0.5 * size(random))).collect()
}

/// Returns the distance of a point from a box; at most 0 inside.
fn distance(x: DVec3, (middle, half): &Cuboid) -> f64 {
    let off = (x - *middle).abs() - *half;
    off.max(DVec3::ZERO).length() + off.max_element().min(0.0)
}

/// Returns the first box on the curve from `start`, and the point; `None` if the curve leaves the sphere or ends. Steps are
/// as long as the nearest box allows, but at least 1e-9. Also returns the least distance to the other boxes.
fn first_box(curve: Curve, fastest: f64, start: DVec3, all: &[Cuboid]) -> (Option<(usize, DVec3)>, f64) {
    let (mut t, mut passed) = (0.0, f64::INFINITY);
    loop {
        let x = start + curve(t) - curve(0.0);
        let nearest = all.iter().enumerate().map(|(i, own)| (distance(x, own), i));
        let (gap, which) = nearest.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        if gap <= 0.0 {
            return (Some((which, x)), passed);
        }
        let edge = RADIUS - x.length();
        if t >= LAST || edge < 0.0 {
            return (None, passed);
        }
        // A box that stays near the curve is hit, or narrowly missed.
        passed = passed.min(gap.max(edge.min(LAST - t)));
        t = (t + (gap / fastest).max(1e-9)).min(LAST);
    }
}

fn text([x, y, z]: [&str; 3], all: &[Cuboid], rays: &str) -> String {
    let mut text = format!(
        "[law]\nkind = \"parametric\"\nx = \"{x}\"\ny = \"{y}\"\nz = \"{z}\"\nt = [0, {LAST}]\n\
         [rays]\nbounding_sphere = {{ radius = {RADIUS} }}\nmax_segments = 20000\n{rays}\n[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n"
    );
    for (middle, half) in all {
        let (middle, size) = (middle.to_array(), (2.0 * *half).to_array());
        writeln!(text, "[[objects]]\nshape = \"box\"\ncenter = {middle:?}\nsize = {size:?}\nmaterial = \"m\"").unwrap();
    }
    text
}

fn traced(text: &str, starts: &[DVec3]) -> Vec<Traced> {
    let rays: Vec<[f64; 6]> = starts.iter().map(|x| [x.x, x.y, x.z, 1.0, 0.0, 0.0]).collect();
    trace(&gpu(), &scene(text), &RenderSettings::default(), &rays).unwrap().0
}

/// Returns a vector of 32-bit numbers, so that both sides have the same scene.
fn rounded(x: DVec3) -> DVec3 {
    x.as_vec3().as_dvec3()
}

/// Checks the rays of one family, and returns the number of those that hit a box.
fn agrees(family: usize, count: usize, rays: &str) -> usize {
    let mut random = Random::new(40 + family as u64);
    let all: Vec<Cuboid> =
        boxes(&mut random, 1000, 9.0).into_iter().map(|(x, half)| (rounded(x), rounded(half))).collect();
    let mut starts = Vec::new();
    while starts.len() < count {
        let x = rounded(within(&mut random, 9.0));
        if all.iter().all(|own| distance(x, own) > 1e-3) {
            starts.push(x);
        }
    }
    let (formulas, curve, fastest) = FAMILIES[family];
    let ends = traced(&text(formulas, &all, rays), &starts);
    let mut met = 0;
    for (start, end) in starts.iter().zip(ends) {
        let (found, passed) = first_box(curve, fastest, *start, &all);
        let at = DVec3::from(end.x);
        let same = match found {
            Some((which, x)) => end.status == Status::Hit && end.object == Some(which as u32) && at.distance(x) < 1e-4,
            None => end.status != Status::Hit,
        };
        // A grazing ray may hit or miss, depending on rounding.
        let grazes = passed < 2e-5
            || found.is_some_and(|(which, x)| {
                let further = (0..50).map(|k| x + (curve(f64::from(k) * 1e-6) - curve(0.0)));
                further.map(|x| distance(x, &all[which])).fold(0.0, f64::min) > -1e-9
            });
        assert!(same || grazes, "{formulas:?} from {start:?}: {found:?}, but {end:?}; passed by {passed:e}");
        met += usize::from(found.is_some());
    }
    met
}

#[test]
fn hierarchical_rays_find_what_brute_force_finds() {
    for family in 0..FAMILIES.len() {
        let met = agrees(family, 200, "");
        assert!(met >= 20, "{family}: {met}");
    }
}

/// Compares the ray tree with a grid and with brute force, and with a solver in small steps.
#[test]
fn every_way_to_follow_a_curve_finds_the_same() {
    let mut random = Random::new(77);
    let all = boxes(&mut random, 300, 8.0);
    let starts: Vec<DVec3> = (0..400).map(|_| within(&mut random, 8.0)).collect();
    let usual = traced(&text(FAMILIES[1].0, &all, ""), &starts);
    for rays in ["acceleration = \"bvh\"", "acceleration = \"grid\"", "acceleration = \"none\""] {
        assert!(traced(&text(FAMILIES[1].0, &all, rays), &starts) == usual, "{rays}");
    }
    let solved = traced(&text(FAMILIES[1].0, &all, "method = \"rk4\"\nstep = 0.02\narc_tolerance = 1e-5"), &starts);
    let apart = |a: &Traced, b: &Traced| DVec3::from(a.x).distance(DVec3::from(b.x));
    let same = usual.iter().zip(&solved).filter(|(a, b)| a.object == b.object && apart(a, b) < 1e-4).count();
    assert!(same >= 398, "{same}");
    let met = usual.iter().filter(|end| end.status == Status::Hit).count();
    assert!(met > 25, "{met}");
}

/// Answers to 15 digits: the first t at which the curve is on the sphere.
#[test]
fn curves_meet_spheres_where_closed_forms_say() {
    let cases = [
        (0, [0.0; 3], [4.0, 2.0, 0.0], 0.5, Some((1.875062891621129, [3.515860847534589, 1.875062891621129, 0.0]))),
        (
            1,
            [0.0; 3],
            [-2.0, 4.0, 0.5],
            0.8,
            Some((4.10033286654853, [-1.3397810612477625, 4.10033286654853, 0.94050456161432])),
        ),
        (1, [0.2, -1.0, 0.1], [1.0, 5.0, 0.0], 0.3, None),
    ];
    for (bits, bound) in [("f32", 2e-6), ("f64", 1e-9)] {
        for (family, start, middle, radius, want) in cases {
            let [x, y, z] = FAMILIES[family].0;
            let text = format!(
                "[law]\nkind = \"parametric\"\nx = \"{x}\"\ny = \"{y}\"\nz = \"{z}\"\nt = [0, 12]\n\
                 [rays]\nbounding_sphere = {{ radius = 200 }}\nprecision = \"{bits}\"\n[materials.m]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n\
                 [[objects]]\nshape = \"sphere\"\ncenter = {middle:?}\nradius = {radius}\nmaterial = \"m\"\n"
            );
            let end = traced(&text, &[DVec3::from(start)])[0];
            match want {
                Some((t, place)) => {
                    assert_eq!(end.status, Status::Hit);
                    assert!((end.tau - t).abs() < bound, "{bits}: {end:?}");
                    assert!(DVec3::from(end.x).distance(DVec3::from(place)) < bound, "{bits}: {end:?}");
                }
                None => assert_eq!(end.status, Status::Ended),
            }
        }
    }
}

/// A curve with the camera's axes ends where the rotated curve does; closed curves return to their start.
#[test]
fn curves_turn_with_the_camera() {
    let law = |axes: &str| {
        format!(
            "[camera]\nkind = \"orthographic\"\nposition = [1, 2, 3]\nlook_at = [4, 2, 3]\nup = [0, 0, 1]\nheight = 2\n\
             [law]\nkind = \"parametric\"\nx = \"t\"\ny = \"2*t\"\nz = \"-3*t\"\nt = [0, 1]\naxes = \"{axes}\"\n[rays]\nbounding_sphere = {{ radius = 50 }}\n"
        )
    };
    // Looking along x with z up: right is −y.
    for (axes, want) in [("scene", DVec3::new(1.0, 2.0, -3.0)), ("camera", DVec3::new(3.0, -1.0, 2.0))] {
        let end = traced(&law(axes), &[DVec3::new(1.0, 2.0, 3.0)])[0];
        assert_eq!(end.status, Status::Ended);
        assert!((DVec3::from(end.x) - DVec3::new(1.0, 2.0, 3.0)).distance(want) < 1e-5, "{axes}: {end:?}");
    }
    let circle = format!(
        "[law]\nkind = \"parametric\"\nx = \"cos(t)\"\ny = \"sin(t)\"\nz = \"0\"\nt = [0, {TAU}]\n[rays]\nbounding_sphere = {{ radius = 50 }}\n"
    );
    let end = traced(&circle, &[DVec3::ZERO])[0];
    assert_eq!(end.status, Status::Ended, "{end:?}");
    assert!(DVec3::from(end.x).length() < 1e-5, "{end:?}");
}
