//! Tests of profiles: the spline, and valid and invalid files.

#![allow(clippy::float_cmp, reason = "numbers of few bits, which the spline keeps whole")]

use super::{Scene, mistakes_of};
use crate::model::law::InMedium;
use crate::model::medium::Layers;
use crate::scene::{Diagnostic, Medium, Profile, SceneError};
use std::fs;
use std::path::Path;

const POINTS: [[f64; 2]; 5] = [[-1.0, 1.5], [0.5, 1.25], [1.0, 1.75], [4.0, 1.125], [4.25, 1.0]];

fn through(points: &[[f64; 2]]) -> Profile {
    Profile::through(points).unwrap_or_else(|flaw| panic!("{flaw:?}"))
}

fn wrong(text: &str) -> Vec<Diagnostic> {
    match Profile::parse(text, Path::new("air.csv")) {
        Err(SceneError::Diagnostics(mistakes)) => mistakes,
        other => panic!("{other:?}"),
    }
}

/// Checks the properties of a natural spline: it passes through its points, has two continuous derivatives, and no second derivative at its
/// ends.
#[test]
fn a_profile_is_a_natural_spline() {
    let points = through(&POINTS).points;
    assert_eq!(points[0].bend, 0.0);
    for (k, [height, n]) in POINTS.iter().enumerate() {
        assert_eq!((points[k].height, points[k].n), (*height, *n));
        let Some(before) = k.checked_sub(1).map(|k| points[k]) else { continue };
        let t = height - before.height;
        let value = before.n + t * (before.slope + t * (before.bend + t * before.twist));
        let slope = before.slope + t * (2.0 * before.bend + 3.0 * t * before.twist);
        let bend = before.bend + 3.0 * t * before.twist;
        assert!((value - n).abs() < 1e-14, "{k}: {value}");
        // The last point starts no cubic, and the second derivative there is 0.
        let next = (k + 1 < POINTS.len()).then_some(points[k].slope);
        assert!(next.is_none_or(|next| (slope - next).abs() < 1e-14), "{k}: {slope} {next:?}");
        assert!((bend - points[k].bend).abs() < 1e-14, "{k}: {bend}");
    }
}

#[test]
fn a_profile_is_constant_outside_and_straight_between_two_points() {
    let profile = through(&POINTS);
    assert_eq!([-9.0, -1.0, 4.25, 9.0].map(|y| profile.index(y)), [1.5, 1.5, 1.0, 1.0]);
    let line = through(&[[2.0, 1.5], [6.0, 1.25]]);
    assert_eq!([2.0, 3.0, 5.0, 7.0].map(|y| line.index(y)), [1.5, 1.4375, 1.3125, 1.25]);
}

#[test]
fn mistakes_in_a_profile_have_their_places() {
    let many = "height,n\n0,1\n,1\n2,zero\n3,-1\n4\n5,1,1\n 1e31 , 1\n".replace('\n', "\r\n");
    let found: Vec<_> = wrong(&many).iter().map(|m| (m.line, m.column, m.excerpt.clone(), m.problem.clone())).collect();
    let expected = [
        (3, 1, ",1", "expected a number, found ``"),
        (4, 3, "zero", "expected a number, found `zero`"),
        (5, 3, "-1", "n must be above 0, found -1"),
        (6, 1, "4", "expected 2 numbers, found 1"),
        (7, 1, "5,1,1", "expected 2 numbers, found 3"),
        (8, 2, "1e31", "expected a number, found `1e31`"),
    ];
    assert_eq!(
        found,
        expected.map(|(line, column, part, problem)| (line, column, part.to_owned(), problem.to_owned()))
    );
    for (text, line, excerpt, problem) in [
        ("", 1, "", "expected the columns height,n, found ``"),
        ("n,height\n1,0\n", 1, "n,height", "expected the columns height,n, found `n,height`"),
        ("height,n\n", 1, "", "a profile requires at least two points, found 0"),
        ("height, n\n\n0,1\n\n2,1\n 2 ,1\n", 6, "2", "the height 2 is not above the previous height, 2"),
        ("height,n\n0,1\n1,0.1\n2,0.1\n3,1\n", 1, "", "the curve through the points falls to n = -0.0350"),
    ] {
        let mistakes = wrong(text);
        assert_eq!(mistakes.len(), 1);
        let m = &mistakes[0];
        assert_eq!((m.line, m.excerpt.as_str()), (line, excerpt), "{m}");
        assert!(m.problem.starts_with(problem), "{m}");
    }
    assert_eq!(wrong(&format!("height,n\n{}", "x,1\n".repeat(20))).len(), 10);
}

#[test]
fn a_scene_finds_its_profile() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("scene.toml");
    let text = "[rays]\nbounding_sphere = { radius = 10 }\n[law]\nkind = \"medium\"\nindex = { kind = \"profile\", file = \"air.csv\", up = [0, 0, 2] }";
    fs::write(folder.path().join("air.csv"), "\u{feff}height, n\n\n 0, 1.5 \n4,1.25\n").expect("written");
    let law = Scene::parse(text, &scene, &[]).unwrap_or_else(|e| panic!("{e}")).law;
    let InMedium(medium) = law.downcast().expect("a medium");
    let medium: &Layers = medium.downcast().expect("a profile");
    assert_eq!(medium.index(glam::DVec3::new(7.0, 8.0, 1.0)), Some(1.4375));
    fs::write(folder.path().join("air.csv"), "height,n\n0,1.5\n4,none\n").expect("written");
    let mistakes = mistakes_of(Scene::parse(text, &scene, &[]));
    assert_eq!(mistakes.len(), 1);
    assert_eq!((mistakes[0].line, mistakes[0].column), (3, 3));
    assert!(mistakes[0].file.ends_with("air.csv"));
}
