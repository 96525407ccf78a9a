//! Tests of the inside of closed and open meshes, and of point tests against sampling.

use super::{good, parse};
use crate::model::medium::{Constant, Luneburg, Rod};
use crate::model::shape::{Cuboid, Cylinder, Disk, Plane, Sphere, Triangles};
use crate::scene::{Interior, Medium, Mesh, Object, Shape, Substance, Transform};
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// The cube |x|, |y|, |z| ≤ 1 with its faces wound outwards.
const CUBE: &str = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const FACES: [&str; 6] = ["f 1 4 3 2\n", "f 5 6 7 8\n", "f 1 2 6 5\n", "f 4 8 7 3\n", "f 1 5 8 4\n", "f 2 3 7 6\n"];

fn mesh(text: &str) -> Mesh {
    Mesh::parse(text, Path::new("a.obj")).unwrap_or_else(|e| panic!("{e}"))
}

pub fn cube() -> Mesh {
    mesh(&format!("{CUBE}{}", FACES.concat()))
}

pub fn object(shape: impl Shape, transform: Transform) -> Object {
    placed(Arc::new(shape), transform)
}

fn placed(shape: Arc<dyn Shape>, transform: Transform) -> Object {
    let medium = Arc::new(Constant { n: 1.5 });
    Object::new(shape, transform, Substance::TransparentShadows(Interior::new(medium)))
}

#[test]
fn a_closed_mesh_has_no_hole() {
    assert_eq!(cube().hole(), None);
    // Corners with different normals still share one position, and so do 0 and -0.
    let apart = "vn 0 0 1\nvn 0 1 0\nv 0 0 0\nv -0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    let tetrahedron = mesh(&format!("{apart}f 1//1 4//1 3//1\nf 2//2 3//2 5//1\nf 3 4 5\nf 4 1 5\n"));
    assert_eq!(tetrahedron.hole(), None);
}

#[test]
fn a_missing_triangle_is_a_hole() {
    let mut open = cube();
    let missing = open.triangles.remove(5).map(|i| open.vertices[i as usize].position);
    let [x, y, z] = open.hole().expect("a hole");
    let middles = [0, 1, 2].map(|k| (missing[k] + missing[(k + 1) % 3]) / 2.0);
    assert!(middles.contains(&Vec3::new(x, y, z)), "[{x}, {y}, {z}] is not an edge of {missing:?}");
}

#[test]
fn triangles_that_wind_otherwise_than_their_neighbours_are_a_hole() {
    let mut mesh = cube();
    mesh.triangles[7].swap(0, 1);
    assert!(mesh.hole().is_some());
    // A cube that is inside out is still closed.
    let mut inverted = cube();
    inverted.triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
    assert_eq!(inverted.hole(), None);
    assert!((inverted.winding(DVec3::splat(0.3)) + 1.0).abs() < 1e-14);
    assert!(
        object(Triangles(Arc::new(inverted)), Transform::new(DVec3::ONE, DVec3::ZERO, DVec3::ZERO))
            .contains(DVec3::ZERO)
    );
}

/// Checks that the bunny is closed and wound outwards, and that the teapot's body is open under its lid.
#[test]
fn the_bunny_is_closed_and_the_teapot_open() {
    let load = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/data").join(name);
        Mesh::load(&path).unwrap_or_else(|e| panic!("{e}"))
    };
    let (bunny, teapot) = (load("bunny.obj"), load("teapot.obj"));
    assert_eq!(bunny.hole(), None);
    let [_, height, _] = teapot.hole().expect("a hole");
    assert!((height - 4.125).abs() < 1e-6, "the rim of the body is at 4.125, not {height}");
    for triangle in bunny.triangles.iter().step_by(100) {
        let [a, b, c] = triangle.map(|i| bunny.vertices[i as usize].position.as_dvec3());
        let out = (b - a).cross(c - a).normalize() * (1e-3 * (b - a).length());
        let middle = (a + b + c) / 3.0;
        for (x, expected) in [(middle - out, 1.0), (middle + out, 0.0)] {
            assert!((bunny.winding(x) - expected).abs() < 1e-9, "{x}: {}", bunny.winding(x));
        }
    }
}

#[test]
fn the_winding_number_is_sure_on_lines_through_edges_and_corners() {
    let cube = cube();
    for (x, inside) in [
        (DVec3::ZERO, true),
        (DVec3::new(1.0 - 1e-9, 1.0 - 1e-9, 1.0 - 1e-9), true),
        (DVec3::new(1.0 + 1e-9, 1.0, 1.0), false),
        (DVec3::new(1.0, 5.0, 1.0), false),
        (DVec3::new(0.0, -2.0, 0.0), false),
        (DVec3::splat(1e9), false),
    ] {
        let winding = cube.winding(x);
        assert!((winding - f64::from(u8::from(inside))).abs() < 1e-6, "{x}: {winding}");
    }
}

#[test]
fn open_shapes_contain_nothing() {
    let place = Transform::new(DVec3::ONE, DVec3::ZERO, DVec3::ZERO);
    let mut open = cube();
    open.triangles.pop();
    let shapes: [Arc<dyn Shape>; 3] =
        [Arc::new(Plane), Arc::new(Disk { hole: 0.0 }), Arc::new(Triangles(Arc::new(open)))];
    for shape in shapes {
        let object = placed(shape, place);
        assert!(!object.contains(DVec3::ZERO), "{:?}", object.shape);
        assert_eq!(object.signed_distance(DVec3::ZERO), None);
    }
}

#[test]
fn gaps_are_distances() {
    let turn = DVec3::new(30.0, 40.0, 50.0);
    let at = DVec3::new(1.0, -2.0, 3.0);
    let near = |a: Option<f64>, b: f64| assert!((a.expect("a gap") - b).abs() < 1e-12, "{a:?} {b}");
    let ball = object(Sphere, Transform::new(DVec3::splat(2.0), turn, at));
    near(ball.signed_distance(at + 5.0 * DVec3::Y), 3.0);
    near(ball.signed_distance(at), -2.0);
    let place = Transform::new(DVec3::new(1.0, 2.0, 3.0), turn, at);
    let from = |own: DVec3| place.0.transform_point3(own);
    let cuboid = object(Cuboid, place);
    near(cuboid.signed_distance(from(DVec3::new(0.5, 0.5, 0.5))), -0.5);
    near(cuboid.signed_distance(from(DVec3::new(0.0, 0.9, 0.0))), -0.2);
    near(cuboid.signed_distance(from(DVec3::new(0.0, 0.0, 2.0))), 3.0);
    let place = Transform::new(DVec3::new(2.0, 5.0, 2.0), turn, at);
    let from = |own: DVec3| place.0.transform_point3(own);
    let cylinder = object(Cylinder, place);
    near(cylinder.signed_distance(from(DVec3::new(0.3, 0.0, 0.4))), -1.0);
    near(cylinder.signed_distance(from(DVec3::new(0.0, 0.9, 0.0))), -0.5);
    near(cylinder.signed_distance(from(DVec3::new(0.0, 0.0, -3.0))), 4.0);
    // The first-order distance of an ellipsoid is exact along its short axis.
    let flat = object(Sphere, Transform::new(DVec3::new(4.0, 1.0, 4.0), DVec3::ZERO, DVec3::ZERO));
    near(flat.signed_distance(DVec3::new(0.0, 1.25, 0.0)), 0.25);
}

#[test]
fn a_cylinder_gives_its_medium_its_radius_and_axis() {
    let rod = |keys: &str, medium: &str| -> Arc<dyn Medium> {
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = 99 }}\n[[objects]]\nshape = \"cylinder\"\n{keys}\ninterior = {{ {medium} }}\n"
        );
        match good(&text).objects[0].interior().map(|interior| interior.medium.clone()) {
            Some(medium) => medium,
            None => panic!("no medium"),
        }
    };
    let keys = "center = [1, 0, 0]\naxis = [0, 2, 0]\nradius = 2\nscale = [3, 7, 3]\nrotate = [90, 0, 0]\ntranslate = [0, 0, 4]";
    let medium = rod(keys, "kind = \"rod\", n0 = 1.6, g = 0.1");
    let Rod { center, axis, .. } = medium.downcast().expect("a rod");
    assert!(center.abs_diff_eq(DVec3::new(3.0, 0.0, 4.0), 1e-12), "{center}");
    assert!(axis.abs_diff_eq(DVec3::Z, 1e-12), "{axis}");
    let medium = rod(keys, "kind = \"luneburg\"");
    let Luneburg { radius, .. } = medium.downcast().expect("a lens");
    assert!((radius - 6.0).abs() < 1e-12, "{radius}");
    // An elliptic or sheared cylinder has no radius.
    for place in ["scale = [3, 7, 2]", "axis = [0, 1, 1]\nscale = [1, 1, 2]"] {
        let text = format!(
            "[rays]\nbounding_sphere = {{ radius = 99 }}\n[[objects]]\nshape = \"cylinder\"\n{place}\ninterior = {{ kind = \"eaton\" }}\n"
        );
        let error = parse(&text).expect_err("no radius").to_string();
        assert!(error.contains("missing key `radius`"), "{error}");
    }
}

fn vector(range: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(range).prop_map(DVec3::from_array)
}

proptest! {
    /// Compares with inequalities in object space, and checks the gap after a small displacement.
    #[test]
    fn points_are_where_their_own_coordinates_say(
        own in vector(-1.5..1.5), scale in vector(0.1..5.0), rotate in vector(-180.0..180.0), translate in vector(-3.0..3.0),
    ) {
        let place = Transform::new(scale, rotate, translate);
        let x = place.0.transform_point3(own);
        let [a, b, c] = own.to_array();
        let square = a.abs().max(b.abs()).max(c.abs());
        let shapes: [(Arc<dyn Shape>, f64); 4] = [
            (Arc::new(Sphere), (a * a + b * b + c * c).sqrt()),
            (Arc::new(Cuboid), square),
            (Arc::new(Cylinder), a.hypot(c).max(b.abs())),
            (Arc::new(Triangles(Arc::new(cube()))), square),
        ];
        for (shape, size) in shapes {
            if (size - 1.0).abs() < 1e-9 {
                continue;
            }
            let what = format!("{shape:?}");
            let object = placed(shape, place);
            prop_assert_eq!(object.contains(x), size < 1.0, "{} at {}", what, own);
            if let Some(signed_distance) = object.signed_distance(x) {
                prop_assert_eq!(signed_distance < 0.0, size < 1.0, "{} at {}", what, own);
                // From a point inside a box, no face is closer than the gap in any direction.
                let moved = x + DVec3::new(0.6, -0.64, 0.48) * (0.999 * signed_distance);
                prop_assert!(signed_distance >= 0.0 || object.shape.downcast::<Cuboid>().is_none() || object.contains(moved), "{} of {}", signed_distance, own);
            }
        }
    }
}

/// Checks that the plane of a triangle as thin as rounding does not affect distant points.
#[test]
fn nothing_is_near_a_sliver_that_is_far_away() {
    let sliver = mesh("v 0 1 0\nv 1.2246e-16 1 0\nv 0.0044 0.99999 -1e-19\nf 1 2 3\n");
    let triangles = Triangles(Arc::new(sliver));
    let near = |x: DVec3| triangles.near_surface(x - triangles.0.origin, 1e-3);
    assert!(!near(DVec3::new(0.0, 0.0, 3.0)));
    assert!(near(DVec3::new(0.0, 1.0, 0.0)));
}
