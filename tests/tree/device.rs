//! Compares the renderer's images with those of the tracer.

use super::with_objects;
use crate::support::tree::Tracer;
use crate::support::{gpu, scene};
use bentray::render::{RenderSettings, Renderer};
use glam::DVec3;

/// Returns the fraction of the pixels in which both agree to `tolerance`, in every channel.
pub fn agreement(text: &str, tolerance: f64) -> f64 {
    let scene = scene(text);
    let expected = Tracer::new(&scene).render();
    let rendered = Renderer::new(&gpu(), &scene, RenderSettings::default()).unwrap().render().unwrap().band.color;
    let at = |i: usize| DVec3::from([0, 1, 2].map(|channel: usize| f64::from(rendered[channel][i])));
    assert_eq!(expected.len(), rendered[0].len());
    let agree = |(i, color): (usize, &DVec3)| (at(i) - color).abs().max_element() <= tolerance;
    expected.iter().enumerate().filter(|pixel| agree(*pixel)).count() as f64 / expected.len() as f64
}

pub const ROOM: &str = "[image]\nsize = [128, 96]\n[camera]\nposition = [3, 2.5, 8]\nlook_at = [0, 0.2, 0]\nfov = 40\n\
    [rays]\nbounding_sphere = { radius = 25 }\nmax_splits = BRANCHES\n[sky]\ncolor = [0.2, 0.4, 0.7]\n\
    [materials.floor]\nkind = \"phong\"\nambient = 0.3\n\
    diffuse = { checker = [[0.8, 0.2, 0.1], [0.9, 0.9, 0.8]], repeat = [6, 6] }\n\
    [materials.shiny]\ndiffuse = [0.1, 0.4, 0.2]\nspecular = [0.6, 0.5, 0.4]\nshininess = 20\nemission = [0.02, 0, 0.05]\n\
    [materials.lamp]\nkind = \"emissive\"\ncolor = [2, 1.5, 1]\n[materials.mirror]\nkind = \"mirror\"\ncolor = [0.9, 0.8, 0.7]\n\
    [[lights]]\nkind = \"point\"\nposition = [8, 12, 10]\n\
    [[lights]]\nkind = \"directional\"\ndirection = [1, -2, -1]\ncolor = [0.3, 0.3, 0.4]\n\
    [[objects]]\nshape = \"plane\"\ncenter = [0, -1.5, 0]\nsize = [14, 14]\nmaterial = \"floor\"\n\
    [[objects]]\nshape = \"box\"\ncenter = [-2, -0.6, -2]\nsize = [1.5, 1.5, 1.5]\nrotate = [0, 25, 0]\nmaterial = \"shiny\"\n\
    [[objects]]\nshape = \"sphere\"\ncenter = [1.8, -0.6, -2.5]\nscale = [1, 1.6, 1]\nradius = 0.8\nmaterial = \"shiny\"\n\
    [[objects]]\nshape = \"sphere\"\ncenter = [-0.5, 1.6, -3]\nradius = 0.4\nmaterial = \"lamp\"\n";

pub fn room(branches: u32, objects: &[&str]) -> String {
    with_objects(&ROOM.replace("BRANCHES", &branches.to_string()), objects)
}

/// Without splits the renderer follows the same rays as the tracer.
#[test]
fn opaque_scenes_are_rendered_as_they_are_traced() {
    let part = agreement(&room(0, &[]), 1e-5);
    assert!(part >= 0.999, "{part}");
}

/// If every surface reflects strongly, the last of many splits still count.
#[test]
fn deep_trees_are_rendered_as_they_are_traced() {
    let block = "shape = \"box\"\ncenter = [0.3, -0.6, 0.5]\nsize = [1.6, 1.2, 1.2]\nrotate = [0, 20, 0]\ninterior = 4";
    let pane = "shape = \"box\"\ncenter = [1, -0.4, 2.5]\nsize = [2, 1.6, 0.2]\nrotate = [0, 15, 0]\ninterior = 3";
    let small = |branches| room(branches, &[block, pane]).replace("[128, 96]", "[40, 30]");
    let [less, all] = [10, 14].map(|branches| Tracer::new(&scene(&small(branches))).render());
    let grown = less.iter().zip(&all).filter(|(less, all)| (**all - **less).max_element() > 1e-4).count();
    assert!(grown * 30 > all.len(), "{grown} of {} pixels see more than ten splits", all.len());
    let part = agreement(&small(14), 1e-5);
    assert!(part >= 0.999, "{part}");
}

#[test]
fn branches_are_rendered_as_they_are_traced() {
    let glass = "shape = \"sphere\"\ncenter = [0.2, -0.3, 0.5]\nradius = 1.1\ninterior = 1.5";
    let bubble = "shape = \"sphere\"\ncenter = [0.3, -0.2, 0.6]\nradius = 0.6\ninterior = 1";
    let water =
        "shape = \"box\"\ncenter = [1.1, -0.6, 0.8]\nsize = [1.2, 1.2, 1.2]\nrotate = [0, 20, 0]\ninterior = \"water\"";
    let mirror = "shape = \"plane\"\ncenter = [-3.5, 0, 0]\nnormal = [1, 0, 0.3]\nsize = [4, 4]\nmaterial = \"mirror\"";
    let lens = |medium: &str| {
        format!("shape = \"sphere\"\ncenter = [0.2, -0.3, 0.5]\nradius = 1.1\ninterior = {{ {medium} }}")
    };
    let lenses = [
        "kind = \"luneburg\"",
        "kind = \"luneburg\", c = 3",
        "kind = \"maxwell-fisheye\", n0 = 2",
        "kind = \"maxwell-fisheye\", n0 = 1.8, a = 1.6",
        "kind = \"inverse-r\", k = 1.6",
    ];
    let inside = "shape = \"sphere\"\ncenter = [0, 0, 8]\nradius = 6\ninterior = 1.33";
    let mut scenes: Vec<(String, String)> = (0..5).map(|d| (format!("glass, {d}"), room(d, &[glass]))).collect();
    scenes.push(("mirror".to_owned(), room(2, &[mirror, glass])));
    scenes.push(("bubble".to_owned(), room(4, &[glass, bubble])));
    scenes.push(("hidden".to_owned(), room(4, &[&format!("{glass}\npriority = 1"), bubble])));
    scenes.push(("overlap".to_owned(), room(3, &[&format!("{glass}\npriority = 1"), water])));
    scenes.push(("camera in water".to_owned(), room(3, &[inside, mirror])));
    scenes.extend(lenses.map(|medium| (medium.to_owned(), room(3, &[&lens(medium)]))));
    let parts: Vec<_> = scenes.iter().map(|(name, text)| (name, agreement(text, 1e-5))).collect();
    assert!(parts.iter().all(|(_, part)| *part >= 0.999), "fractions of the pixels that agree: {parts:#?}");
}

/// Straight shadows agree with those of the tracer, except at their edges: of several lights, behind transparent and opaque
/// objects, of objects in lists, in a hierarchy or a grid, for straight and bent paths, in all schedules.
#[test]
fn shadows_are_rendered_as_they_are_traced() {
    let glass = "shape = \"sphere\"\ncenter = [0.2, -0.3, 0.5]\nradius = 1.1\ninterior = 1.5";
    let mirror = "shape = \"plane\"\ncenter = [-3.5, 0, 0]\nnormal = [1, 0, 0.3]\nsize = [4, 4]\nmaterial = \"mirror\"";
    let ball = "shape = \"sphere\"\ncenter = [2.5, 1, 1]\nradius = 0.5\nmaterial = \"shiny\"";
    let many: Vec<String> = (0..40)
        .map(|i| {
            let angle = 0.7 * f64::from(i);
            let (x, y, z) = (3.0 * angle.cos(), -1.2 + 0.08 * f64::from(i), 3.0 * angle.sin());
            format!("shape = \"sphere\"\ncenter = [{x}, {y}, {z}]\nradius = 0.2\nmaterial = \"shiny\"")
        })
        .collect();
    let many: Vec<&str> = many.iter().map(String::as_str).collect();
    let shadowed = |text: String| {
        text.replace(
            "kind = \"point\"",
            "kind = \"point\"\nshadows = \"straight-rays\"\nfalloff = \"inverse-square\"\ncolor = [250, 220, 200]",
        )
        .replace("kind = \"directional\"", "kind = \"directional\"\nshadows = \"straight-rays\"")
    };
    let keys = |text: String, keys: &str| text.replace("[rays]\n", &format!("[rays]\n{keys}\n"));
    let scenes = [
        ("opaque", shadowed(room(0, &[ball]))),
        ("without a structure", keys(shadowed(room(0, &[ball])), "acceleration = \"none\"")),
        ("glass and mirror", shadowed(room(3, &[mirror, glass, ball]))),
        ("hierarchy", shadowed(room(0, &many))),
        ("grid", keys(shadowed(room(0, &many)), "acceleration = \"grid\"")),
        ("solver", keys(shadowed(room(0, &many)), "method = \"rk4\"\nscaled_step = 0.05")),
    ];
    for (name, text) in &scenes {
        let part = agreement(text, 2e-5);
        assert!(part >= 0.998, "{name}: {part}");
        let dark = agreement(&text.replace("shadows = \"straight-rays\"", ""), 2e-5);
        assert!(dark >= 0.998, "{name} without shadows: {dark}");
    }
    let [lit, plain] = [scenes[0].1.clone(), scenes[0].1.replace("shadows = \"straight-rays\"", "")]
        .map(|text| Tracer::new(&scene(&text)).render());
    let shaded = lit.iter().zip(&plain).filter(|(a, b)| **a != **b).count();
    assert!(shaded * 40 > lit.len(), "{shaded} pixels in shadow");
}
