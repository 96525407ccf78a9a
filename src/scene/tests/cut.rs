//! Tests of the outlines in which surfaces cross planes.

use std::path::Path;
use std::sync::Arc;

use glam::DVec3;

use crate::model::Law;
use crate::model::law::{KerrNewman, RoundHole};
use crate::model::shape::{Cuboid, Plane, Sphere, Triangles};
use crate::scene::{CutPlane, Mesh, Object, Outline, Shape, Substance, Transform};

fn plane(point: [f64; 3], normal: [f64; 3]) -> CutPlane {
    CutPlane::new(point.into(), normal.into()).unwrap()
}

fn object(shape: impl Shape, scale: [f64; 3], rotate: [f64; 3], translate: [f64; 3]) -> Object {
    let transform = Transform::new(scale.into(), rotate.into(), translate.into());
    Object::new(Arc::new(shape), transform, Substance::Opaque(0))
}

/// Returns the only outline, and checks that all of its points are in the plane.
fn only(object: &Object, plane: &CutPlane) -> Outline {
    let mut outlines = object.cut(plane);
    assert_eq!(outlines.len(), 1, "{outlines:?}");
    let outline = outlines.remove(0);
    assert!(outline.points.iter().all(|p| plane.height(*p).abs() < 1e-6), "{outline:?}");
    outline
}

fn length(outline: &Outline) -> f64 {
    let closing = outline.closed.then(|| [*outline.points.last().unwrap(), outline.points[0]]);
    let sides = outline.points.windows(2).map(|ends| ends[0].distance(ends[1]));
    sides.sum::<f64>() + closing.map_or(0.0, |[a, b]| a.distance(b))
}

#[test]
fn a_plane_has_its_directions_on_paper() {
    for (normal, right, up) in [
        ([0.0, 0.0, -2.0], DVec3::X, DVec3::Y),
        ([0.0, 1.0, 0.0], DVec3::X, DVec3::Z),
        ([3.0, 1e-6, 0.0], DVec3::Y, DVec3::Z),
    ] {
        let plane = plane([1.0, 2.0, 3.0], normal);
        assert_eq!((plane.right, plane.up), (right, up));
    }
    let oblique = plane([0.0; 3], [1.0, 1.0, 0.0]);
    assert_eq!(oblique.names(), ["along [0.71, -0.71, 0.00]", "z"]);
    assert!(CutPlane::new(DVec3::ZERO, DVec3::ZERO).is_none());
}

#[test]
fn a_plane_is_fitted_to_points_that_have_one() {
    let spiral = |tilt: f64| -> Vec<DVec3> {
        let point = |i: i32| {
            let (sin, cos) = (0.1 * f64::from(i)).sin_cos();
            DVec3::new(0.05 * f64::from(i) * cos, 3.0 + tilt * cos, 0.05 * f64::from(i) * sin)
        };
        (0..100).map(point).collect()
    };
    let flat = CutPlane::fit(&spiral(1e-7)).unwrap();
    assert_eq!((flat.right, flat.up), (DVec3::X, DVec3::Z));
    assert!((flat.point.y - 3.0).abs() < 1e-6);
    assert!(CutPlane::fit(&spiral(0.5)).is_none());
    assert!(CutPlane::fit(&[DVec3::ZERO, DVec3::X, DVec3::X * 3.0]).is_none());
    assert!(CutPlane::fit(&[]).is_none());
}

#[test]
fn a_sphere_is_cut_in_a_circle_or_an_ellipse() {
    let ball = object(Sphere, [5.0; 3], [0.0; 3], [1.0, 2.0, 3.0]);
    let circle = only(&ball, &plane([0.0, 5.0, 0.0], [0.0, 1.0, 0.0]));
    assert!(circle.closed);
    let center = DVec3::new(1.0, 5.0, 3.0);
    assert!(circle.points.iter().all(|p| (p.distance(center) - 4.0).abs() < 1e-12));
    assert!(ball.cut(&plane([0.0, 7.1, 0.0], [0.0, 1.0, 0.0])).is_empty());
    // x²/9 + y² + z²/4 = 1, turned by 90° about z: x² + y²/9 + z²/4 = 1.
    let egg = object(Sphere, [3.0, 1.0, 2.0], [0.0, 0.0, 90.0], [0.0; 3]);
    let ellipse = only(&egg, &plane([0.5, 0.0, 0.0], [1.0, 0.0, 0.0]));
    let off = |p: &DVec3| (p.x * p.x + p.y * p.y / 9.0 + p.z * p.z / 4.0 - 1.0).abs();
    assert!(ellipse.points.iter().all(|p| off(p) < 1e-12));
    let highest = ellipse.points.iter().map(|p| p.y).fold(0.0, f64::max);
    assert!((highest - 3.0 * 0.75_f64.sqrt()).abs() < 1e-3);
}

#[test]
fn a_box_is_cut_in_three_to_six_corners() {
    let cube = object(Cuboid, [1.0, 2.0, 3.0], [0.0; 3], [10.0, 0.0, 0.0]);
    let square = only(&cube, &plane([0.0, 0.5, 0.0], [0.0, 1.0, 0.0]));
    assert!(square.closed && square.points.len() == 4);
    assert!((length(&square) - 16.0).abs() < 1e-7);
    let unit = object(Cuboid, [1.0; 3], [0.0; 3], [0.0; 3]);
    // The section through the center perpendicular to a diagonal is a regular hexagon of side √2; closer to a corner it is a triangle.
    let hexagon = only(&unit, &plane([0.0; 3], [1.0; 3]));
    assert_eq!(hexagon.points.len(), 6);
    assert!((length(&hexagon) - 6.0 * 2.0_f64.sqrt()).abs() < 1e-7);
    let triangle = only(&unit, &plane([0.9, 0.9, 0.9], [1.0; 3]));
    assert_eq!(triangle.points.len(), 3);
    assert!((length(&triangle) - 9.0 * 0.2 * 0.5_f64.sqrt()).abs() < 1e-7);
    // A plane in a face, and a plane beyond it.
    assert!((length(&only(&unit, &plane([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]))) - 8.0).abs() < 1e-6);
    assert!(unit.cut(&plane([1.001, 0.0, 0.0], [1.0, 0.0, 0.0])).is_empty());
}

#[test]
fn a_plane_is_cut_in_a_line() {
    let floor = object(Plane, [4.0, 1.0, 2.0], [0.0; 3], [1.0, -1.0, 0.0]);
    let line = only(&floor, &plane([0.0, 0.0, 0.5], [0.0, 0.0, 1.0]));
    assert!(!line.closed && line.points.len() == 2);
    let mut xs = [line.points[0].x, line.points[1].x];
    xs.sort_by(f64::total_cmp);
    assert!((xs[0] + 3.0).abs() < 1e-12 && (xs[1] - 5.0).abs() < 1e-12, "{xs:?}");
    assert!(floor.cut(&plane([0.0, 0.0, 2.5], [0.0, 0.0, 1.0])).is_empty());
    assert!(floor.cut(&plane([0.0; 3], [0.0, 1.0, 0.0])).is_empty());
    let edge = only(&floor, &plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]));
    assert!(edge.closed && (length(&edge) - 24.0).abs() < 1e-12);
    // A section across a corner, |x| + |z| = 1.5 in object space.
    let corner = only(&floor, &plane([7.0, 0.0, 0.0], [1.0, 0.0, 2.0]));
    assert!((length(&corner) - 0.5 * 20.0_f64.sqrt()).abs() < 1e-12, "{corner:?}");
}

#[test]
fn a_mesh_is_cut_in_closed_lines_where_it_is_closed() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    let closed = Arc::new(Mesh::parse(text, Path::new("tetrahedron.obj")).unwrap());
    let scaled = object(Triangles(closed), [2.0; 3], [0.0; 3], [0.0, 0.0, 5.0]);
    let triangle = only(&scaled, &plane([0.0, 0.0, 6.0], [0.0, 0.0, 1.0]));
    assert!(triangle.closed && triangle.points.len() == 3);
    assert!((length(&triangle) - (2.0 + 2.0_f64.sqrt())).abs() < 1e-12, "{triangle:?}");
    // A plane through corners.
    assert!(only(&scaled, &plane([0.0, 0.0, 5.0], [1.0, -1.0, 0.0])).closed);
    assert!(scaled.cut(&plane([0.0, 0.0, 7.1], [0.0, 0.0, 1.0])).is_empty());
    let without_a_face = text.rsplit_once("f 3").unwrap().0;
    let open = Arc::new(Mesh::parse(without_a_face, Path::new("open.obj")).unwrap());
    let open =
        only(&object(Triangles(open), [2.0; 3], [0.0; 3], [0.0, 0.0, 5.0]), &plane([0.0, 0.0, 6.0], [0.0, 0.0, 1.0]));
    assert!(!open.closed && open.points.len() == 3);
}

#[test]
fn a_real_mesh_has_as_much_outline_as_edges() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/data/bunny.obj");
    let mesh = Arc::new(Mesh::load(&path).unwrap());
    let middle = mesh.vertices.iter().map(|v| v.position.as_dvec3()).sum::<DVec3>() / mesh.vertices.len() as f64;
    let plane = CutPlane::new(middle, DVec3::new(0.3, 0.2, 1.0)).unwrap();
    // Every triangle with corners on both sides adds its crossing, in any order.
    let mut expected = 0.0;
    for corners in &mesh.triangles {
        let corners = corners.map(|i| mesh.vertices[i as usize].position.as_dvec3());
        let mut ends = Vec::new();
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let (from, to) = (plane.height(corners[a]), plane.height(corners[b]));
            if from * to < 0.0 {
                ends.push(corners[a] + (corners[b] - corners[a]) * (from / (from - to)));
            }
        }
        if let [a, b] = ends[..] {
            expected += a.distance(b);
        }
    }
    let outlines = object(Triangles(mesh), [1.0; 3], [0.0; 3], [0.0; 3]).cut(&plane);
    let found: f64 = outlines.iter().map(length).sum();
    assert!(expected > 0.0 && (found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    assert!(outlines.len() < 10, "{} pieces", outlines.len());
}

#[test]
fn a_horizon_is_cut_like_a_sphere() {
    let hole = RoundHole::new(1.5, DVec3::X);
    let [horizon] = &hole.landmarks()[..] else { panic!() };
    assert_eq!(horizon.name, "horizon");
    let cut = |height: f64| horizon.cut(&plane([0.0, 0.0, height], [0.0, 0.0, 1.0]));
    let outline = cut(1.8).expect("an outline");
    let center = DVec3::new(1.0, 0.0, 1.8);
    assert!(outline.points.iter().all(|p| (p.distance(center) - 2.4).abs() < 1e-12));
    assert!(cut(3.1).is_none());
}

/// Checks that a rotating black hole has a spheroidal horizon inside an ergosphere, which touches it only at the poles.
#[test]
fn horizons_and_ergospheres_are_cut_as_they_are() {
    let (mass, spin, center) = (2.0, 1.5, DVec3::new(1.0, -2.0, 0.5));
    let axis = DVec3::new(1.0, 2.0, -2.0) / 3.0;
    let hole = KerrNewman { mass, spin, axis, charge: 0.5, center };
    let [ergosphere, horizon] = &hole.landmarks()[..] else { panic!() };
    assert_eq!([ergosphere.name, horizon.name], ["ergosphere", "horizon"]);
    let left = mass * mass - 0.25;
    for (height, normal) in [(0.0, axis.any_orthonormal_vector()), (0.0, axis), (0.8, DVec3::Y)] {
        let plane = CutPlane::new(center + height * normal, normal).unwrap();
        for (landmark, edge) in [
            (horizon, &(|_: f64| mass + (left - spin * spin).sqrt()) as &dyn Fn(f64) -> f64),
            (ergosphere, &|cos2: f64| mass + (left - spin * spin * cos2).sqrt()),
        ] {
            let outline = landmark.cut(&plane).expect("an outline");
            assert_eq!(outline.points.len(), 180);
            for p in outline.points {
                let d = p - center;
                let (up, aside) = (d.dot(axis), d.reject_from_normalized(axis).length());
                // The radius follows from ρ²/(r² + a²) + z²/r² = 1.
                let excess = d.length_squared() - spin * spin;
                let r2 = 0.5 * (excess + (excess * excess + 4.0 * spin * spin * up * up).sqrt());
                assert!((aside * aside / (r2 + spin * spin) + up * up / r2 - 1.0).abs() < 1e-9);
                let off = r2.sqrt() - edge(up * up / r2);
                assert!(off.abs() < 1e-9 && plane.height(p).abs() < 1e-12, "{} at {p}: {off:e}", landmark.name);
            }
        }
    }
    assert!(horizon.cut(&CutPlane::new(center + 9.0 * DVec3::X, DVec3::X).unwrap()).is_none());
}
