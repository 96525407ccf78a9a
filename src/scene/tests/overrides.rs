//! Tests of `--set KEY=VALUE`.

use super::{Override, RAYS, Scene, mistakes_of};
use crate::model::camera::Pinhole;
use crate::model::law::{HoleForm, RoundHole};
use crate::scene::{Bound, SceneError};
use glam::DVec3;
use std::path::Path;

const SCENE: &str = "[camera]\nposition = [0, 0, 9]\n[law]\nkind = \"schwarzschild\"\n[materials.\"light red\"]\n\
                     [[objects]]\nshape = \"sphere\"\nmaterial = \"light red\"\n";

fn with(overrides: &[&str]) -> Result<Scene, SceneError> {
    let overrides: Vec<Override> = overrides.iter().map(|o| o.parse().expect(o)).collect();
    Scene::parse(&format!("{RAYS}{SCENE}"), Path::new("scene.toml"), &overrides)
}

#[test]
fn values_are_replaced_and_added() {
    let scene = with(&[
        "image.size=[10, 12]",
        "camera.fov = 40",
        "law.form=geodesic",
        "law.center=[0,0,1]",
        "objects.0.radius=2",
        "rays.bounding_sphere.radius=20",
        "rays.bounding_sphere={ radius = 30 }",
        "materials.\"light red\".ambient=0.5",
        "output.bit_depth=16",
    ])
    .expect("good overrides");
    assert_eq!(scene.image.size, [10, 12]);
    let projection = scene.camera.expect("a camera").projection;
    assert_eq!(projection.downcast(), Some(&Pinhole { fov: 40.0 }));
    let RoundHole { form, center, .. } = scene.law.downcast().expect("a hole");
    assert_eq!(*form, HoleForm::Geodesic);
    assert_eq!(*center, DVec3::Z);
    assert_eq!(scene.objects[0].transform.uniform_scale(), Some(2.0));
    let center = DVec3::ZERO;
    assert_eq!(scene.rays.bounding_sphere, Bound { center, radius: 30.0 });
    assert_eq!(scene.output.bits, 16);
}

#[test]
fn mistakes_are_found_on_the_command_line() {
    for (text, column, excerpt, problem) in [
        ("rays.step=abc", 11, "abc", "expected a number, found the string \"abc\""),
        ("rays.step= 0.0.5", 12, "0.0.5", "expected a number, found the string \"0.0.5\""),
        ("image.size=[10, 0]", 17, "0", "expected a whole number from 1 to 65536, found 0"),
        ("rays.bounding_sphere={ radius = 3, radios = 4 }", 36, "radios", "unknown key `radios`"),
        ("image.sise=3", 1, "image.sise", "unknown key `sise`"),
        ("objects.1.radius=3", 1, "objects.1.radius", "`objects` has 1 entry, counted from 0, and no `1`"),
        ("law.kind.x=3", 1, "law.kind.x", "`law.kind` is not a table"),
        ("sky.intensity=3", 1, "sky.intensity", "`intensity` cannot be combined with the rest of this table"),
    ] {
        let mistakes = mistakes_of(with(&[text]));
        assert_eq!(mistakes.len(), 1, "{mistakes:?}");
        let mistake = &mistakes[0];
        assert_eq!(mistake.file, Path::new(&format!("--set {text}")));
        assert_eq!((mistake.line, mistake.column), (1, column), "{mistake}");
        assert_eq!(mistake.excerpt, excerpt);
        assert_eq!(mistake.problem, problem);
    }
}

#[test]
fn what_is_no_override_is_refused_at_once() {
    for (text, problem) in [
        ("rays.step", "expected KEY=VALUE"),
        ("=3", "the key must be names joined by dots"),
        ("rays..step=3", "the key must be names joined by dots"),
        ("image.size=[1, 2", "the value is not valid TOML"),
        ("sky.image=\"a", "the value is not valid TOML"),
    ] {
        let error = text.parse::<Override>().expect_err(text).to_string();
        assert!(error.contains(problem), "{error}");
    }
}

#[test]
fn without_a_value_a_key_is_left_out() {
    let scene = with(&["rays.method=rk4", "rays.accuracy=1e-3", "rays.accuracy="]);
    assert_eq!(scene.expect("a scene").rays.auto, None);
    let objects = with(&["objects=[{ shape = \"sphere\", material = \"none\" }]", "objects.0="]);
    assert!(objects.expect("a scene").objects.is_empty());
    for (key, column) in [("rays.frob=", 1), ("objects.7.radius=", 1), ("rays.method.x=", 1)] {
        let told = with(&[key]).expect_err(key).to_string();
        let name = key.trim_end_matches('=');
        let said = [
            format!("--set {key}:1:{column}: cannot remove `{name}`, which does not exist"),
            "write a value after".to_owned(),
        ];
        assert!(said.iter().all(|said| told.contains(said)), "{told}");
    }
}

/// Checks that the text of a scene's ray settings gives another scene identical settings.
#[test]
fn how_rays_are_followed_goes_over_to_another_scene() {
    let ways: [&[&str]; 9] = [
        &[],
        &["rays.method=planar", "rays.scaled_step=0.1234567890123"],
        &["rays.method=rk4", "rays.step=1e-5", "rays.scaled_step=3", "rays.precision=f64"],
        &["rays.method=euler", "rays.curvature_step=0.3"],
        &["rays.method=dormand-prince", "rays.tolerance=1.5e-11", "rays.max_segments=123456"],
        &["rays.method=bogacki-shampine", "rays.tolerance=1e-3", "rays.scaled_step=12345.678"],
        &["rays.method=rk4-doubling", "rays.tolerance=1e-4", "rays.grow_below=3e-6", "rays.closed_forms=true"],
        &["rays.method=euler-doubling", "rays.doubling=paper", "rays.tolerance=1e-2"],
        &["rays.method=planar", "rays.closed_forms=false", "rays.precision=f16"],
    ];
    let scenes: Vec<Scene> = ways.iter().map(|way| with(way).expect("a table of ray settings")).collect();
    for (of, from) in scenes.iter().zip(&ways) {
        let followed: Vec<Override> = crate::scene::follow_as(&of.rays.followed()).expect("a separate text");
        for way in ways {
            let own = way.iter().map(|o| o.parse().expect(o));
            let overrides: Vec<Override> = own.chain(followed.iter().cloned()).collect();
            let scene = Scene::parse(&format!("{RAYS}{SCENE}"), Path::new("scene.toml"), &overrides).expect("both");
            let mut expected = of.rays.clone();
            expected.auto = None;
            assert_eq!(scene.rays, expected, "{from:?} over {way:?}");
        }
    }
    for text in ["", "3", "{ }", "{ method = \"rk4\", step }", "{ method = \"rk4\", bound = 3 }"] {
        assert!(crate::scene::follow_as(text).is_err(), "{text}");
    }
}
