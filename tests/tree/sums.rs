//! Images in which every pixel is a sum in closed form.

use super::{difference, picture};
use crate::support::scene;
use crate::support::tree::Tracer;
use glam::DVec3;

const SLAB: &str = "[image]\nsize = [24, 16]\n[camera]\nposition = [0, 6, 5]\nfov = 60\n[sky]\ncolor = [0.3, 0.5, 0.9]\n\
    [materials.floor]\nkind = \"emissive\"\ncolor = [0.8, 0.2, 0.1]\n\
    [[objects]]\nshape = \"box\"\nsize = [400, 1.5, 400]\ninterior = 1.5\n\
    [[objects]]\nshape = \"plane\"\ncenter = [0, -2, 0]\nsize = [400, 400]\nmaterial = \"floor\"\n";

fn slab(branches: u32) -> String {
    format!("{SLAB}[rays]\nbounding_sphere = {{ radius = 400 }}\nmax_splits = {branches}\n")
}

/// Returns the angle between the vertical and the camera ray of a pixel of [`SLAB`], from the numbers in the file.
fn angle(i: usize) -> f64 {
    let (column, row) = ((i % 24) as f64, (i / 24) as f64);
    let half = 30_f64.to_radians().tan();
    let (right, up) = ((column + 0.5 - 12.0) / 8.0 * half, (8.0 - row - 0.5) / 8.0 * half);
    let look = (-DVec3::new(0.0, 6.0, 5.0)).normalize();
    let upward = DVec3::new(0.0, 5.0, -6.0).normalize();
    (-(look + right * DVec3::X + up * upward).normalize().y).acos()
}

/// Returns the reflectance by the Fresnel equations in angles.
fn reflectance(incident: f64, n: f64) -> f64 {
    let refracted = (incident.sin() / n).asin();
    let (sum, between) = (incident + refracted, incident - refracted);
    0.5 * ((between.sin() / sum.sin()).powi(2) + (between.tan() / sum.tan()).powi(2))
}

/// Light that is reflected k times inside a slab leaves on one side or the other: each additional split adds one term.
#[test]
fn a_slab_adds_up_its_inner_reflections() {
    let (sky, floor) = (DVec3::new(0.3, 0.5, 0.9), DVec3::new(0.8, 0.2, 0.1));
    for branches in [0, 1, 2, 3, 6, 20] {
        let found = picture(&slab(branches));
        let expected = (0..found.len()).map(|i| {
            let r = reflectance(angle(i), 1.5);
            // The first split reflects r; each later one transmits 1 − r and keeps r inside.
            let mut sum = if branches == 0 { DVec3::ZERO } else { r * sky };
            let mut inside = 1.0 - r;
            for branching in 2..=branches {
                sum += (1.0 - r) * inside * if branching % 2 == 0 { floor } else { sky };
                inside *= r;
            }
            sum
        });
        let off = difference(&found, &expected.collect::<Vec<_>>());
        assert!(off < 1e-13, "{branches} splits: off by {off:e}");
    }
}

/// The whole series: 2r/(1 + r) is reflected and the rest transmitted.
#[test]
fn a_slab_reflects_the_whole_series() {
    let (sky, floor) = (DVec3::new(0.3, 0.5, 0.9), DVec3::new(0.8, 0.2, 0.1));
    let found = picture(&slab(20));
    for (i, found) in found.into_iter().enumerate() {
        let r = reflectance(angle(i), 1.5);
        let back = 2.0 * r / (1.0 + r);
        // The light that remains inside after twenty splits.
        let off = (found - back * sky - (1.0 - back) * floor).abs().max_element();
        assert!(off < 1e-13 + r.powi(19), "pixel {i}: off by {off:e}");
    }
}

/// The white sky seen from the center of a glass ball is n² times as bright,
/// except for cut paths; of an emitter inside it, 1/n² of the radiance leaves.
#[test]
fn radiance_changes_with_the_square_of_the_index() {
    let ball = "[rays]\nbounding_sphere = { radius = 20 }\nmax_splits = BRANCHES\n[sky]\ncolor = [1, 1, 1]\n\
        [[objects]]\nshape = \"sphere\"\nradius = 2\ninterior = 1.5\n";
    for branches in 0..8_u8 {
        let scene = scene(&ball.replace("BRANCHES", &branches.to_string()));
        let seen = Tracer::new(&scene).seen(DVec3::ZERO, DVec3::new(0.6, 0.0, -0.8));
        let expected = 2.25 * (1.0 - 0.04_f64.powi(i32::from(branches)));
        assert!((seen - expected).abs().max_element() < 1e-13, "{branches} splits: {seen}");
    }
    let lamp = "[materials.lamp]\nkind = \"emissive\"\ncolor = [3, 2, 1]\n\
        [[objects]]\nshape = \"sphere\"\nradius = 0.5\nmaterial = \"lamp\"\n";
    let scene = scene(&format!("{lamp}{}", ball.replace("BRANCHES", "20").replace("[1, 1, 1]", "[0, 0, 0]")));
    // Along a radius, reflected light ends on the emitter inside, and the transmitted fraction is 0.96.
    let seen = Tracer::new(&scene).seen(DVec3::new(0.0, 5.0, 0.0), DVec3::NEG_Y);
    assert!((seen - 0.96 / 2.25 * DVec3::new(3.0, 2.0, 1.0)).abs().max_element() < 1e-14, "{seen}");
}

/// Total reflection, a mirror and a surface between equal media do not branch: rays pass them even without allowed splits.
#[test]
fn what_does_not_branch_is_not_counted() {
    let text = "[rays]\nbounding_sphere = { radius = 20 }\nmax_splits = 0\n[sky]\ncolor = [9, 9, 9]\n\
        [materials.lamp]\nkind = \"emissive\"\ncolor = [3, 2, 1]\n[materials.mirror]\nkind = \"mirror\"\ncolor = [0.9, 0.8, 0.7]\n\
        [[objects]]\nshape = \"box\"\nsize = [4, 4, 4]\ninterior = 1.5\n\
        [[objects]]\nshape = \"box\"\ncenter = [1.5, 1.5, 0]\nsize = [0.8, 0.8, 0.8]\ninterior = 1.5\n\
        [[objects]]\nshape = \"sphere\"\ncenter = [1.5, 1.5, 0]\nradius = 0.2\nmaterial = \"lamp\"\n\
        [[objects]]\nshape = \"plane\"\ncenter = [0, -1, 0]\nsize = [1, 1]\nmaterial = \"mirror\"\n";
    let scene = scene(text);
    let lamp = DVec3::new(3.0, 2.0, 1.0);
    // At 45 degrees: by the upper wall to the emitter; by the mirror and the wall on the right; and straight out, which is cut.
    let ways = [([1.0, 1.0], DVec3::ONE), ([1.0, -1.0], DVec3::new(0.9, 0.8, 0.7)), ([0.0, 1.0], DVec3::ZERO)];
    for ([x, y], part) in ways {
        let seen = Tracer::new(&scene).seen(DVec3::NEG_X, DVec3::new(x, y, 0.0).normalize());
        assert!((seen - part * lamp).abs().max_element() < 1e-14, "towards ({x}, {y}): {seen}");
    }
}

/// If everything is as bright as the sky, transparent objects are invisible, except for cut paths.
#[test]
fn clear_objects_vanish_in_a_white_sky() {
    let scene = |branches: u32| {
        format!(
            "[image]\nsize = [16, 12]\n[camera]\nposition = [1, 2, 7]\nfov = 40\n[sky]\ncolor = [1, 1, 1]\n\
             [rays]\nbounding_sphere = {{ radius = 20 }}\nmax_splits = {branches}\n\
             [[objects]]\nshape = \"sphere\"\nradius = 1.5\ninterior = {{ kind = \"luneburg\", c = 3 }}\n\
             [[objects]]\nshape = \"box\"\ncenter = [1.5, 0, 0]\nsize = [2, 2, 2]\nrotate = [10, 20, 30]\ninterior = \"water\"\npriority = 2\n\
             [[objects]]\nshape = \"sphere\"\ncenter = [-1, 0.5, 1]\nradius = 0.7\ninterior = 1.2\npriority = 1\n"
        )
    };
    let mut cut = [0, 3, 6, 9].map(|branches| {
        let picture = picture(&scene(branches));
        assert!(picture.iter().all(|seen| seen.max_element() < 1.0 + 1e-12));
        1.0 - picture.iter().map(|seen| seen.x).sum::<f64>() / picture.len() as f64
    });
    assert!(cut[0] > 0.1 && cut[3] < 3e-3, "{cut:?}");
    // Each three additional splits leave less than half of the missing light.
    cut.reverse();
    assert!(cut.windows(2).all(|pair| pair[0] < 0.5 * pair[1]), "{cut:?}");
}

/// A mirror shows the scene from its mirrored viewpoint, in its color; two mirrors that face each other never end, and stay black.
#[test]
fn mirrors_show_the_mirrored_scene() {
    let room = "[rays]\nbounding_sphere = { radius = 30 }\n[sky]\nimage = \"data/stars.png\"\n\
        [materials.m]\ndiffuse = { checker = [[1, 0.2, 0.1], [0.9, 0.9, 0.9]] }\nspecular = [0.5, 0.5, 0.5]\n\
        [[objects]]\nshape = \"sphere\"\ncenter = [0.5, 2, 0]\nradius = 1\nmaterial = \"m\"\n\
        [[lights]]\nkind = \"point\"\nposition = [10, 10, 20]\n[materials.mirror]\nkind = \"mirror\"\ncolor = [0.9, 0.8, 0.7]\n";
    let mirror = "[[objects]]\nshape = \"plane\"\nmaterial = \"mirror\"\ncenter = [0, -1, 0]\n";
    let (with, without) = (scene(&format!("{room}{mirror}")), scene(room));
    let flip = DVec3::new(1.0, -1.0, 1.0);
    for i in 0..200 {
        let d = DVec3::new(0.01 * f64::from(i) - 1.0, -0.7, -1.0 + 0.1 * f64::from(i % 10)).normalize();
        let x = DVec3::new(0.21, 0.3, 3.0);
        let seen = Tracer::new(&with).seen(x, d);
        let image = Tracer::new(&without).seen(DVec3::new(0.21, -2.3, 3.0), d * flip);
        let off = (seen - DVec3::new(0.9, 0.8, 0.7) * image).abs().max_element();
        assert!(off < 1e-9, "ray {i}: {seen} in the mirror, {image} without");
    }
    let ceiling = "[[objects]]\nshape = \"plane\"\nmaterial = \"mirror\"\ncenter = [0, 5, 0]\n";
    let both = scene(&format!("{room}{mirror}{ceiling}"));
    assert_eq!(Tracer::new(&both).seen(DVec3::new(5.0, 1.0, 5.0), DVec3::Y), DVec3::ZERO);
}
