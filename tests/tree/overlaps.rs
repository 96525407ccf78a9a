//! Tests objects inside objects: different descriptions of one interior have equal images.

use super::{difference, picture, with_objects};

const VIEW: &str = "[image]\nsize = [24, 18]\n[camera]\nposition = [1, 2, 7]\nlook_at = [0, 0, 0]\nfov = 35\n\
    [rays]\nbounding_sphere = { radius = 20 }\nmax_splits = 4\n[sky]\nimage = \"data/stars.png\"\n\
    [materials.m]\nkind = \"emissive\"\ncolor = { checker = [[1, 0.2, 0.1], [0.9, 0.9, 0.9]] }\n\
    [[objects]]\nshape = \"plane\"\ncenter = [0, -1.7, 0]\nsize = [8, 8]\nmaterial = \"m\"\n";

fn view(objects: &[&str]) -> String {
    with_objects(VIEW, objects)
}

fn alike(a: &[&str], b: &[&str]) {
    let off = difference(&picture(&view(a)), &picture(&view(b)));
    assert!(off < 1e-10, "{a:?} and {b:?} differ by {off}");
}

fn unlike(a: &[&str], b: &[&str]) {
    let off = difference(&picture(&view(a)), &picture(&view(b)));
    assert!(off > 1e-2, "{a:?} and {b:?} look equal");
}

const GLASS: &str = "shape = \"sphere\"\nradius = 1.5\ninterior = 1.5";
const BUBBLE: &str = "shape = \"sphere\"\nradius = 1.2\ncenter = [0.1, 0, 0.1]\ninterior = 1";
const WATER: &str =
    "shape = \"box\"\nsize = [1, 2.8, 2]\ncenter = [1, 0, 0.2]\nrotate = [0, 30, 0]\ninterior = \"water\"";

#[test]
fn what_is_filled_with_air_is_not_there() {
    alike(&[BUBBLE], &[]);
    unlike(&[GLASS], &[]);
    alike(&[GLASS, "shape = \"box\"\nsize = [1, 1, 1]\ninterior = 1.5"], &[GLASS]);
}

/// At equal priority the inner object wins, whatever the order in the file.
#[test]
fn a_bubble_is_hollow() {
    alike(&[GLASS, BUBBLE], &[BUBBLE, GLASS]);
    unlike(&[GLASS, BUBBLE], &[GLASS]);
    let first = format!("{BUBBLE}\npriority = 1");
    alike(&[GLASS, BUBBLE], &[GLASS, &first]);
}

/// An object inside a medium of a higher priority is hidden, and its surfaces have no effect.
#[test]
fn the_higher_priority_is_there() {
    let glass = format!("{GLASS}\npriority = 2");
    alike(&[&glass, BUBBLE], &[&glass]);
    // Outside the ball the box is water; in the ball it is glass.
    unlike(&[&glass, WATER], &[GLASS, &format!("{WATER}\npriority = 3")]);
    alike(&[&glass, WATER], &[WATER, &glass]);
    // Three kinds at one point: the middle one is hidden by the highest.
    let small = "shape = \"sphere\"\nradius = 1\ncenter = [0.2, 0, 0]\ninterior = 2\npriority = 1";
    alike(&[&glass, small, WATER], &[&glass, WATER]);
}

/// Two adjacent halves of a ball's box are equivalent to one box: at touching surfaces, light goes directly from one to the other.
#[test]
fn touching_objects_have_one_surface_between_them() {
    let whole = "shape = \"box\"\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\ninterior = 1.5";
    let left = "shape = \"box\"\nmin = [-1, -1, -1]\nmax = [0.2, 1, 1]\ninterior = 1.5";
    let right = "shape = \"box\"\nmin = [0.2, -1, -1]\nmax = [1, 1, 1]\ninterior = 1.5";
    alike(&[left, right], &[whole]);
}

/// The camera may be inside one object or two, with the interiors that rays from outside would have.
#[test]
fn cameras_can_be_inside() {
    let around = "shape = \"sphere\"\nradius = 10\ninterior = 1.33";
    let air = "shape = \"sphere\"\nradius = 9.5\ninterior = 1";
    alike(&[around, air, GLASS], &[air, around, GLASS]);
    alike(&[around, &format!("{air}\npriority = 1"), &format!("{GLASS}\npriority = 1")], &[around, air, GLASS]);
    unlike(&[around, air, GLASS], &[around, GLASS]);
}

/// Media that hardly vary, with each kind of path, give the images of a constant
/// index, which are computed in a different way. They contain shapes of every kind.
#[test]
fn paths_that_hardly_bend_show_what_lines_show() {
    let media = [
        "{ kind = \"luneburg\", c = 2.25, radius = 1e8 }",
        "{ kind = \"gaussian\", a = 1.5, b = 1e-17, radius = 1 }",
        "{ kind = \"maxwell-fisheye\", n0 = 1.5, a = 1e8 }",
        "{ kind = \"rod\", n0 = 1.5, g = 1e-8, axis = [0, 0.6, 0.8] }",
        "{ kind = \"linear\", n0 = 1.5, gradient = [1e-14, -1e-14, 0] }",
    ];
    let water = format!("{WATER}\npriority = 1");
    let inside: [&str; 5] = [
        "shape = \"box\"\nsize = [0.3, 0.4, 0.5]\ncenter = [0.4, 0.3, 0.5]\nrotate = [10, 20, 30]\nmaterial = \"m\"",
        "shape = \"plane\"\nsize = [1, 0.6]\ncenter = [-0.3, 0.3, 0]\nnormal = [0.5, 1, 0.4]\nmaterial = \"m\"",
        "shape = \"sphere\"\nradius = 0.1\ncenter = [-0.6, 0, 0.9]\nmaterial = \"m\"",
        "shape = \"sphere\"\nradius = 0.4\ncenter = [-0.4, -0.6, 0.2]\nscale = [1, 0.5, 1]\ninterior = 1\npriority = 2",
        &water,
    ];
    let glass = |medium: &str| format!("shape = \"sphere\"\nradius = 1.5\ninterior = {medium}");
    let scene = |medium: &str| {
        let own = glass(medium);
        let objects: Vec<&str> = inside.into_iter().chain([own.as_str()]).collect();
        view(&objects)
    };
    let expected = picture(&scene("1.5"));
    for medium in media {
        let off = difference(&picture(&scene(medium)), &expected);
        assert!(off < 1e-6, "{medium}: off by {off:e}");
    }
}
