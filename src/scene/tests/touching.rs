//! Tests of touching objects, and of the number of objects that can contain a ray.

use super::inside::{cube, object};
use super::{good, parse};
use crate::model::shape::{Cuboid, Plane, Triangles};
use crate::scene::{Scene, Transform};
use glam::{DAffine3, DVec3};
use std::sync::Arc;

fn objects(tables: &[&str]) -> Scene {
    let tables: String = tables.iter().map(|table| format!("[[objects]]\n{table}\n")).collect::<Vec<_>>().concat();
    good(&format!("[rays]\nbounding_sphere = {{ radius = 99 }}\n[materials.m]\n{tables}"))
}

fn touch(first: &str, second: &str) -> bool {
    let scene = objects(&[first, second]);
    let [a, b] = [&scene.objects[0], &scene.objects[1]];
    assert_eq!(a.may_touch(b), b.may_touch(a), "{first} and {second}");
    a.may_touch(b)
}

#[test]
fn faces_in_one_plane_touch() {
    let cuboid = "shape = \"box\"\nsize = [2, 2, 2]\ninterior = 1.5";
    let turn = "rotate = [33.3333, 47.1, -12]\ntranslate = [3, -7, 20]";
    for other in [
        "shape = \"box\"\nmin = [1, -3, -2]\nmax = [2, 2, -0.9]\ninterior = 1.3",
        "shape = \"box\"\nmin = [-0.5, -1, -0.5]\nmax = [0.5, 0.5, 0.5]\ninterior = 1.3",
        "shape = \"plane\"\ncenter = [0, -1, 0]\nsize = [50, 50]\nmaterial = \"m\"",
        "shape = \"disk\"\ncenter = [1, 0.2, 0]\nnormal = [-1, 0, 0]\nradius = 0.5\nmaterial = \"m\"",
        "shape = \"cylinder\"\ncenter = [0, 2, 0.8]\nradius = 0.5\nmaterial = \"m\"",
    ] {
        assert!(touch(cuboid, other), "{other}");
        assert!(touch(&format!("{cuboid}\n{turn}"), &format!("{other}\n{turn}")), "{other}, turned");
    }
}

#[test]
fn round_faces_touch_where_they_are_the_same() {
    let ball = "shape = \"sphere\"\nradius = 2\ncenter = [1, 2, 3]\ninterior = 1.5";
    assert!(touch(ball, ball));
    assert!(!touch(ball, &ball.replace("= 2\n", "= 1.999\n")));
    assert!(!touch(ball, &ball.replace("[1, 2", "[1, 2.001")));
    let egg = "shape = \"sphere\"\nscale = [1, 1.5, 1]\ninterior = 1.5";
    assert!(touch(egg, &format!("{egg}\nrotate = [0, 70, 0]")));
    assert!(!touch(egg, &format!("{egg}\nrotate = [70, 0, 0]")));
    // A section of one mantle, and one next to it.
    let rod = "shape = \"cylinder\"\naxis = [1, 2, 3]\nheight = 4\ninterior = 1.5";
    assert!(touch(rod, &rod.replace("height = 4", "height = 3")));
    assert!(!touch(rod, &rod.replace("height = 4", "height = 3\nradius = 0.9")));
}

#[test]
fn what_meets_in_points_or_lines_does_not_touch() {
    let ball = "shape = \"sphere\"\ninterior = 1.5";
    for other in [
        "shape = \"plane\"\ncenter = [0, -1, 0]\nmaterial = \"m\"",
        "shape = \"sphere\"\ncenter = [2, 0, 0]\ninterior = 1.3",
        "shape = \"cylinder\"\nheight = 5\ninterior = 1.3",
        "shape = \"box\"\nsize = [2, 2, 2]\ninterior = 1.3",
    ] {
        assert!(!touch(ball, other), "{other}");
    }
    let cuboid = "shape = \"box\"\nsize = [2, 2, 2]\ninterior = 1.5";
    // Objects apart in one plane, inside, across, and at a tiny distance.
    for other in [
        "shape = \"box\"\nmin = [1.5, -1, -1]\nmax = [2, 1, 1]\ninterior = 1.3",
        "shape = \"box\"\nsize = [1, 1, 1]\ninterior = 1.3",
        "shape = \"plane\"\nmaterial = \"m\"",
        "shape = \"box\"\nmin = [1.0001, -0.5, -0.5]\nmax = [2, 0.5, 0.5]\ninterior = 1.3",
    ] {
        assert!(!touch(cuboid, other), "{other}");
    }
}

/// Checks that a glass mesh may touch a table; two meshes are not compared.
#[test]
fn meshes_stand_on_flat_faces() {
    let place = Transform::new(DVec3::splat(0.7), DVec3::new(20.0, 30.0, 40.0), DVec3::new(1.0, 2.0, 3.0));
    let mesh = object(Triangles(Arc::new(cube())), place);
    let table = |gap: f64| {
        let under = DAffine3::from_translation(DVec3::new(0.3, -1.0 - gap, 0.2));
        object(Plane, Transform(place.0 * under))
    };
    assert!(mesh.may_touch(&table(0.0)));
    assert!(!mesh.may_touch(&table(1e-3)) && !mesh.may_touch(&mesh));
    let (lo, hi) = mesh.bounds();
    let cuboid = object(Cuboid, place);
    assert!(lo.abs_diff_eq(cuboid.bounds().0, 1e-6) && hi.abs_diff_eq(cuboid.bounds().1, 1e-6));
}

/// Checks the limit of 32 objects, one bit each.
#[test]
fn closed_mirrors_count_among_what_a_ray_can_be_in() {
    let text = |mirrors: usize| {
        let row = |i: usize, what: &str| {
            format!("[[objects]]\nshape = \"sphere\"\nradius = 0.1\ncenter = [{i}, 0, 0]\n{what}\n")
        };
        let glass: String = (0..20).map(|i| row(i, "interior = 1.5")).collect();
        let mirrors: String = (0..mirrors).map(|i| row(30 + i, "material = \"m\"")).collect();
        let flat = "[[objects]]\nshape = \"plane\"\ncenter = [0, 5, 0]\nsize = [1, 1]\nmaterial = \"m\"\n";
        format!("[rays]\nbounding_sphere = {{ radius = 99 }}\n[materials.m]\nkind = \"mirror\"\n{glass}{mirrors}{flat}")
    };
    assert_eq!(good(&text(12)).objects.len(), 33);
    let error = parse(&text(13)).expect_err("33 bits").to_string();
    assert!(error.contains("20 objects with an interior and 13 closed mirrors exceed the limit of 32"), "{error}");
}
