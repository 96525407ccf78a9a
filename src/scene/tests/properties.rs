//! Properties for arbitrary input: nothing panics, and computed extents agree with sampling.

use super::{Override, Scene};
use crate::model::Shape;
use crate::model::shape::{Cylinder, Disk, Sphere, round_up};
use crate::scene::{Mesh, TEMPLATES, Transform};
use glam::DVec3;
use proptest::prelude::*;
use std::path::Path;

const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2 3 -1 \\\n# é\nf 1//1 2//1 3//1\n";

/// Returns `text` with a few characters replaced.
fn damaged(text: &'static str) -> impl Strategy<Value = String> {
    let place = 0..text.chars().count();
    let edits = prop::collection::vec((place, "[-a0.=\\[\\]{}\"#/\\\\\n é]{0,2}"), 1..4);
    edits.prop_map(move |edits| {
        let mut pieces: Vec<String> = text.chars().map(String::from).collect();
        for (place, piece) in edits {
            pieces[place] = piece;
        }
        pieces.concat()
    })
}

fn vector(range: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(range).prop_map(DVec3::from_array)
}

proptest! {
    #[test]
    fn damaged_scenes_do_not_panic(text in damaged(TEMPLATES[0].text), set in damaged("rays.bounding_sphere.radius=[3, \"a\"]")) {
        let sets: Vec<Override> = set.parse().into_iter().collect();
        if let Err(error) = Scene::parse(&text, Path::new("scene.toml"), &sets) {
            prop_assert!(!error.to_string().is_empty());
        }
    }

    #[test]
    fn damaged_meshes_do_not_panic(text in damaged(OBJ)) {
        match Mesh::parse(&text, Path::new("a.obj")) {
            Err(error) => prop_assert!(!error.to_string().is_empty()),
            Ok(mesh) => {
                let count = mesh.vertices.len() as u32;
                prop_assert!(mesh.triangles.iter().flatten().all(|i| *i < count));
                prop_assert!(mesh.vertices.iter().all(|v| (v.normal.length() - 1.0).abs() < 1e-5));
            }
        }
    }

    #[test]
    fn an_ellipsoid_reaches_as_far_as_its_points(
        scale in vector(0.1..5.0), rotate in vector(-180.0..180.0), translate in vector(-3.0..3.0),
        center in vector(-3.0..3.0),
    ) {
        let transform = Transform::new(scale, rotate, translate);
        let far = Sphere.reach(transform.0, center).expect("a reach");
        // A spiral of points, about 0.03 apart.
        let sampled = (0..16_000).map(|i| {
            let z = 1.0 - (2.0 * f64::from(i) + 1.0) / 16_000.0;
            let (y, x) = (f64::from(i) * 2.399_963).sin_cos();
            let s = (1.0 - z * z).sqrt();
            transform.0.transform_point3(DVec3::new(s * x, s * y, z)).distance(center)
        }).fold(0.0, f64::max);
        prop_assert!(sampled <= far * (1.0 + 1e-9), "{sampled} {far}");
        prop_assert!(far <= sampled * 1.003, "{sampled} {far}");
    }

    #[test]
    fn a_cylinder_reaches_as_far_as_its_rims(
        own in vector(0.1..5.0), tilt in vector(-180.0..180.0), scale in vector(0.1..5.0), rotate in vector(-180.0..180.0),
        translate in vector(-3.0..3.0), center in vector(-3.0..3.0),
    ) {
        // A tilted cylinder with a subsequent non-uniform scale is sheared.
        let own = Transform::new(own, tilt, DVec3::ZERO).0;
        let transform = Transform(Transform::new(scale, rotate, translate).0 * own);
        let sampled = |y: f64| (0..2000).map(|i| {
            let (z, x) = (f64::from(i) * std::f64::consts::TAU / 2000.0).sin_cos();
            transform.0.transform_point3(DVec3::new(x, y, z)).distance(center)
        }).fold(0.0, f64::max);
        let shapes: [(&dyn Shape, f64); 2] =
            [(&Cylinder, sampled(1.0).max(sampled(-1.0))), (&Disk { hole: 0.5 }, sampled(0.0))];
        for (shape, sampled) in shapes {
            let far = shape.reach(transform.0, center).expect("a reach");
            prop_assert!(sampled <= far * (1.0 + 1e-9), "{sampled} {far}");
            prop_assert!(far <= sampled * 1.0001, "{sampled} {far}");
        }
    }

    /// Checks a center that equals the object's up to rounding, where λ is indistinguishable from the square of the longest axis.
    #[test]
    fn reaches_from_the_middle_are_numbers(scale in vector(0.1..5.0), tilt in vector(-180.0..180.0)) {
        let transform = Transform::new(scale, tilt, DVec3::ZERO);
        let x = transform.0.matrix3.x_axis.length().max(transform.0.matrix3.z_axis.length());
        for center in [DVec3::ZERO, DVec3::splat(1e-18)] {
            let ball = Sphere.reach(transform.0, center).expect("a reach");
            prop_assert!((ball - scale.max_element()).abs() < 1e-9, "{ball}");
            let rims = Cylinder.reach(transform.0, center).expect("a reach");
            prop_assert!((rims - x.hypot(scale.y)).abs() < 1e-9, "{rims}");
        }
    }

    #[test]
    fn rounding_up_is_up_but_little(x in 1e-6..1e6_f64) {
        let up = round_up(x);
        prop_assert!(up >= x * (1.0 - 1e-12) && up <= x * 1.0101, "{x} {up}");
    }
}
