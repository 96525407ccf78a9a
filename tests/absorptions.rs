//! Tests the absorption and emission of media against quadrature along paths in closed form.

use bentray::program::{ProgramOptions, RaySkipping, Schedule};
use bentray::render::{RenderSettings, Renderer, Rendering};
use bentray::scene::Scene;
use glam::DVec3;

use crate::support::lens::{columns, vector};
use crate::support::{assert_same_image, gpu, scene};

const TABLE: &str = include_str!("tables/filters.tsv");

fn rendered(scene: &Scene, options: ProgramOptions) -> Rendering {
    Renderer::new(&gpu(), scene, RenderSettings { options, ..RenderSettings::default() }).unwrap().render().unwrap()
}

/// Returns a scene with one ray from a position in a direction, to a white screen at another position.
fn to_screen(medium: &str, filter: &str, [from, along, to]: [DVec3; 3], rays: &str) -> String {
    let ball: Vec<&str> = medium.split_whitespace().collect();
    let (law, object, normal, size) = match ball[..] {
        ["ball", n, radius] => {
            let interior = format!("{{ kind = \"constant\", n = {n}, absorption = {{ {filter} }} }}");
            let object = format!("[[objects]]\nshape = \"sphere\"\nradius = {radius}\ninterior = {interior}\n");
            (String::new(), object, along, 30.0)
        }
        ["straight"] => {
            (format!("[law]\nkind = \"straight\"\nabsorption = {{ {filter} }}\n"), String::new(), to - from, 0.1)
        }
        _ => (
            format!("[law]\nkind = \"medium\"\nindex = {{ {medium} }}\nabsorption = {{ {filter} }}\n"),
            String::new(),
            to - from,
            0.02,
        ),
    };
    let (from, look, to, normal) = (from.to_array(), (from + along).to_array(), to.to_array(), normal.to_array());
    format!(
        "[image]\nsize = [1, 1]\n[camera]\nposition = {from:?}\nlook_at = {look:?}\nup = [0.01, 0.02, 1]\nfov = 0.001\n\
         [rays]\nbounding_sphere = {{ radius = 100 }}\n{rays}\n{law}[materials.screen]\nkind = \"emissive\"\ncolor = [1, 1, 1]\n{object}\
         [[objects]]\nshape = \"disk\"\nmaterial = \"screen\"\ncenter = {to:?}\nnormal = {normal:?}\nradius = {size}\n"
    )
}

/// Checks straight, harmonic, circular and parabolic paths, through formulas and through textures.
#[test]
fn filters_are_as_exact_as_they_are_asked_to_be() {
    for (tolerance, allowed) in [(1e-3, 1e-4), (1e-6, 2e-6)] {
        for row in columns(TABLE) {
            let [medium, filter, from, along, to, left] = row[..] else { panic!("{row:?}") };
            let places = [from, along, to].map(|text| vector(text).unwrap());
            let filter = format!("{filter}, tolerance = {tolerance}");
            let branches = if medium.starts_with("ball") { "max_splits = 2" } else { "" };
            let picture = rendered(&scene(&to_screen(medium, &filter, places, branches)), ProgramOptions::default());
            let expected = vector(left).unwrap().to_array();
            for (channel, expected) in expected.into_iter().enumerate() {
                let found = f64::from(picture.band.color[channel][0]);
                assert!(
                    (found - expected).abs() < allowed * expected.max(1.0),
                    "{medium}, {filter}: {found} for {expected}"
                );
            }
            assert_eq!(picture.totals.unsettled, 0, "{medium}, {filter}");
        }
    }
}

/// Checks the absorption along paths of an integration method, with its accuracy.
#[test]
fn filters_follow_integrated_paths() {
    let rays = "method = \"dormand-prince\"\ntolerance = 1e-6";
    for row in columns(TABLE).filter(|row| row[0].starts_with("kind")) {
        let places = [row[2], row[3], row[4]].map(|text| vector(text).unwrap());
        let picture = rendered(&scene(&to_screen(row[0], row[1], places, rays)), ProgramOptions::default());
        for (channel, expected) in vector(row[5]).unwrap().to_array().into_iter().enumerate() {
            let found = f64::from(picture.band.color[channel][0]);
            assert!((found - expected).abs() < 2e-4 * expected.max(1.0), "{}: {found} for {expected}", row[0]);
        }
    }
}

/// A lens that reflects nothing at its edge transmits c^d of the sky along the chord d.
#[test]
fn lenses_filter_by_the_length_of_their_paths() {
    let text = "[image]\nsize = [1, 1]\n[camera]\nposition = [-10, 0.4, 0]\nlook_at = [0, 0.4, 0]\nfov = 0.001\n\
                [rays]\nbounding_sphere = { radius = 20 }\n[sky]\ncolor = [1, 1, 1]\n[[objects]]\nshape = \"sphere\"\n\
                interior = { kind = \"luneburg\", c = 2, absorption = [0.9, 0.6, 0.3] }\n";
    for rays in ["", "closed_forms = false\nmethod = \"rk4\"\n"] {
        let text = text.replace("[sky]", &format!("{rays}[sky]"));
        let picture = rendered(&scene(&text), ProgramOptions::default());
        for (channel, expected) in [0.812_713_1_f32, 0.365_884_1, 0.093_505_6].into_iter().enumerate() {
            let found = picture.band.color[channel][0];
            assert!((found - expected).abs() < 2e-5, "{rays}: {found} for {expected}");
        }
    }
}

/// A medium that absorbs and emits in front of a wall gives c^d L + ε (c^d − 1)/ln c.
#[test]
fn media_glow() {
    for transport in ["direct", "path-tracing"] {
        let text = format!(
            "[image]\nsize = [3, 3]\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\nfov = 0.001\n\
             [law]\nkind = \"straight\"\nabsorption = {{ transmittance = [0.9, 0.5, 1], emission = [0.1, 0.2, 0.3] }}\n\
             [rays]\nbounding_sphere = {{ radius = 20 }}\nlighting = \"{transport}\"\n\
             [materials.wall]\nkind = \"emissive\"\ncolor = [1, 0.5, 0]\n[[objects]]\nshape = \"box\"\nmaterial = \"wall\"\n\
             center = [0, 0, -3]\nsize = [4, 4, 2]\n"
        );
        let picture = rendered(&scene(&text), ProgramOptions::default());
        for (channel, expected) in [0.990_333_2_f32, 0.341_404_26, 0.6].into_iter().enumerate() {
            let found = picture.band.color[channel][4];
            assert!((found - expected).abs() < 1e-6, "{transport}: {found} for {expected}");
        }
    }
}

/// An absorbing ball under a uniform sky: R + (1 − R)² t/(1 − R t) with t = c^chord, for ray splitting and for path tracing.
const BALL: &str = "[image]\nsize = [24, 24]\nsamples = 64\n[camera]\nkind = \"orthographic\"\nheight = 1.6\nposition = [0, 0, 4]\n\
    [sky]\ncolor = [1, 1, 1]\n[rays]\nbounding_sphere = { radius = 9 }\n[[objects]]\nshape = \"sphere\"\n\
    interior = { kind = \"constant\", n = 1.5, absorption = { transmittance = [0.65, 0.45, 0.1], emission = [0.2, 0, 0] } }\n";

fn ball(sin: f64, color: f64, glow: f64) -> f64 {
    let index = 1.5_f64;
    let (cos, inner) = ((1.0 - sin * sin).sqrt(), (1.0 - sin * sin / (index * index)).sqrt());
    let across = (cos - index * inner) / (cos + index * inner);
    let along = (index * cos - inner) / (index * cos + inner);
    let back = 0.5 * (across * across + along * along);
    let left = color.powf(2.0 * inner);
    // For the outgoing light L/n² is constant.
    let added = glow / (index * index) * (left - 1.0) / color.ln();
    back + (1.0 - back) * ((1.0 - back) * left + added) / (1.0 - back * left)
}

#[test]
fn balls_absorb_in_every_order_of_reflection() {
    let exact: Vec<[f64; 3]> = (0..24 * 24)
        .map(|i| {
            let at = |k: usize| (k as f64 + 0.5) / 24.0 * 1.6 - 0.8;
            let b = at(i % 24).hypot(at(i / 24));
            [(0.65, 0.2), (0.45, 0.0), (0.1, 0.0)]
                .map(|(color, glow)| if b < 0.97 { ball(b, color, glow) } else { f64::NAN })
        })
        .collect();
    // Of the 2^20 paths that may be, the first few are left.
    for (rays, allowed) in [
        ("max_splits = 8", 2e-3),
        ("max_splits = 20", 2e-3),
        ("max_splits = \"stochastic\"", 0.04),
        ("lighting = \"path-tracing\"", 0.04),
    ] {
        let samples =
            if rays.starts_with("max_splits = ") && !rays.contains('"') { "samples = 1" } else { "samples = 64" };
        let text = BALL.replace("samples = 64", samples).replace("[[objects]]", &format!("{rays}\n[[objects]]"));
        let picture = rendered(&scene(&text), ProgramOptions::default());
        for channel in 0..3 {
            let own = picture.band.color[channel].iter().map(|x| f64::from(*x));
            let off: Vec<f64> = own.zip(&exact).map(|(x, e)| x - e[channel]).filter(|x| x.is_finite()).collect();
            let mean = (off.iter().map(|x| x * x).sum::<f64>() / off.len() as f64).sqrt();
            assert!(mean < allowed, "{rays}, {channel}: {mean}");
        }
    }
}

#[test]
fn every_schedule_filters_alike() {
    let texts = [
        BALL.replace("samples = 64", "samples = 1"),
        BALL.replace("samples = 64", "samples = 2").replace("[[objects]]", "lighting = \"path-tracing\"\n[[objects]]"),
        BALL.replace("samples = 64", "samples = 1")
            .replace("[sky]", "[law]\nkind = \"medium\"\nindex = { kind = \"gaussian\", a = 1.6, radius = 9 }\nabsorption = [0.9, 0.8, 0.7]\n[sky]")
            .replace("interior = {", "material = \"m\" #")
            .replace("[[objects]]", "method = \"rk4\"\n[materials.m]\nkind = \"mirror\"\n[[objects]]"),
    ];
    for text in texts.map(|text| text.replace("[rays]", "[rays]\nmax_segments = 60")) {
        let scene = scene(&text);
        let usual = rendered(&scene, ProgramOptions::default());
        for schedule in Schedule::ALL {
            for masks in [RaySkipping::List, RaySkipping::Off] {
                let other = rendered(&scene, ProgramOptions { schedule, masks, ..ProgramOptions::default() });
                assert_same_image(&other, &usual, &format_args!("{schedule:?} {masks:?}\n{text}"));
            }
        }
    }
}

/// Invalid absorption is counted, and so are values that did not converge to the tolerance.
#[test]
fn bad_filters_are_counted() {
    let straight = [DVec3::ZERO, DVec3::X, DVec3::X * 3.0];
    for filter in ["coefficient = 'x - 1'", "transmittance = '1.5 - x'"] {
        let picture = rendered(&scene(&to_screen("straight", filter, straight, "")), ProgramOptions::default());
        assert_eq!((picture.totals.undefined, picture.band.color[0][0]), (1, 0.0), "{filter}");
    }
    let ripples = "coefficient = '0.5 + 0.5*sin(2e4*x)', tolerance = 1e-6";
    let picture = rendered(&scene(&to_screen("straight", ripples, straight, "")), ProgramOptions::default());
    assert!(picture.totals.unsettled > 0 && picture.totals.undefined == 0, "{}", picture.totals);
}

/// Each object has a separate formula, whatever the order of regions: higher priorities come first.
#[test]
fn formulas_belong_to_their_objects() {
    let ball = |x: f64, density: &str, priority: u32| {
        format!(
            "[[objects]]\nshape = \"sphere\"\ncenter = [{x}, 0, 0]\nradius = 0.5\npriority = {priority}\n\
             interior = {{ kind = \"constant\", n = 1, absorption = {{ coefficient = {density} }} }}\n"
        )
    };
    let text = format!(
        "[image]\nsize = [2, 1]\n[camera]\nkind = \"orthographic\"\nheight = 2\nposition = [0, 0, 4]\n[sky]\ncolor = [1, 1, 1]\n\
         [rays]\nbounding_sphere = {{ radius = 9 }}\n{}{}",
        ball(-1.0, "\"1 + 0*x\"", 0),
        ball(1.0, "\"2 + 0*x\"", 5)
    );
    let picture = rendered(&scene(&text), ProgramOptions::default());
    for (found, expected) in picture.band.color[0].iter().zip([(-1.0_f32).exp(), (-2.0_f32).exp()]) {
        assert!((found - expected).abs() < 1e-5, "{found} for {expected}");
    }
}

/// Orbits in empty space take few steps, but these do not skip absorbing regions.
#[test]
fn filters_follow_orbits() {
    let text = "[image]\nsize = [8, 6]\n[camera]\nposition = [0, 0, 12]\nlook_at = [5, 0, 0]\nfov = 30\n[sky]\ncolor = [1, 1, 1]\n\
                [law]\nkind = \"schwarzschild\"\nabsorption = { coefficient = \"0.02 + 0.2*exp(-r^2/20)\" }\n\
                [rays]\nbounding_sphere = { radius = 30 }\nmethod = ";
    let [planar, solved] = ["\"planar\"\n", "\"dormand-prince\"\ntolerance = 1e-6\n"]
        .map(|method| rendered(&scene(&format!("{text}{method}")), ProgramOptions::default()).band.color);
    assert!(planar[0].iter().filter(|x| **x > 0.1).count() > 12);
    for (found, expected) in planar[0].iter().zip(&solved[0]) {
        assert!((found - expected).abs() < 1e-3, "{found} for {expected}");
    }
}
