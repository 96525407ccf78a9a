//! Tests of `[animation]`: frames are the scene with the values of tracks substituted.

#![allow(clippy::float_cmp)] // values at key frames are exact

use super::{Override, RAYS, Scene, SceneError, mistakes_of};
use crate::assets::Files;
use crate::model::camera::Pinhole;
use glam::DVec3;
use proptest::prelude::*;

const SCENE: &str = "[camera]\nposition = [0, 0, 9]\n[animation]\nframes = 11\n";

fn track(key: &str, rest: &str) -> String {
    format!("[[animation.tracks]]\nkey = \"{key}\"\n{rest}\n")
}

fn frame(tracks: &str, overrides: &[&str], frame: u32) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, format!("{RAYS}{SCENE}{tracks}")).expect("a file");
    let overrides: Vec<Override> = overrides.iter().map(|o| o.parse().expect("an override")).collect();
    Scene::load_with(&mut Files::default(), &path, &overrides, Some(&|_| frame.into()))
}

fn fov(scene: &Scene) -> f64 {
    let Pinhole { fov } = scene.camera.as_ref().expect("a camera").projection.downcast().expect("a pinhole");
    *fov
}

#[test]
fn values_go_from_key_to_key() {
    let position = track("camera.position", "values = [[0, 0, 9], [10, 0, 9], [10, 0, 5]]\nkeyframes = [0, 4, 8]");
    for (k, expected) in [(0, [0.0, 9.0]), (1, [2.5, 9.0]), (4, [10.0, 9.0]), (6, [10.0, 7.0]), (10, [10.0, 5.0])] {
        let scene = frame(&position, &[], k).expect("a good frame");
        assert_eq!(scene.camera.expect("a camera").position, DVec3::new(expected[0], 0.0, expected[1]), "frame {k}");
        assert_eq!(
            scene.animation.map(|animation| (animation.frames, animation.keys.concat())),
            Some((11, "camera.position".to_owned()))
        );
    }
    // Frames are evenly spaced if none are specified, and a single value is constant.
    let evenly = track("camera.fov", "values = [20, 40, 50]") + &track("camera.up", "values = [[1, 0, 0]]");
    for (k, expected) in [(0, 20.0), (5, 40.0), (6, 42.0), (10, 50.0)] {
        let scene = frame(&evenly, &[], k).expect("a good frame");
        assert!((fov(&scene) - expected).abs() < 1e-12, "frame {k}");
        assert_eq!(scene.camera.expect("a camera").up, DVec3::X);
    }
}

proptest! {
    /// Checks that a smooth track passes through its values, has zero slope at both ends and no corner at a keyframe, and follows a
    /// straight line exactly away from its ends.
    #[test]
    fn smooth_tracks_have_no_corners(values in prop::collection::vec(20.0..60.0_f64, 3), middle in 200_u32..800) {
        let text = track("camera.fov", &format!("values = {values:?}\nkeyframes = [0, {middle}, 1000]\ninterpolation = \"smooth\""));
        let text = text.replace("frames = 11", "frames = 1001");
        let at = |k: u32| fov(&frame(&text, &[], k).expect("a good frame"));
        for (k, value) in [0, middle, 1000].into_iter().zip(&values) {
            prop_assert_eq!(at(k), *value);
        }
        // A frame is a thousandth of the track, so that the rise of a cubic from zero slope is of second order.
        prop_assert!((at(1) - at(0)).abs() < 1e-2 && (at(1000) - at(999)).abs() < 1e-2);
        let (before, after) = (at(middle) - at(middle - 1), at(middle + 1) - at(middle));
        prop_assert!((before - after).abs() < 2e-2, "{} {}", before, after);
        let slope = (values[2] - values[0]) / 1000.0;
        prop_assert!((0.5 * (before + after) - slope).abs() < 1e-2);
    }
}

#[test]
fn a_value_that_does_not_fit_is_found_at_its_track() {
    for (text, k, line, column, problem) in [
        (track("camera.fov", "values = [-3, 40]"), 0, 9, 11, "expected an angle between 0 and 180 degrees, found -3"),
        (track("camera.fav", "values = [3, 40]"), 3, 8, 7, "unknown key `fav`"),
        (track("objects.0.radius", "values = [3, 40]"), 3, 8, 7, "expected tables with the header [[objects]]"),
        (
            track("image.samples", "values = [1, 4]"),
            3,
            9,
            11,
            "expected a whole number from 1 to 1048576, found a number",
        ),
    ] {
        let mistakes = mistakes_of(frame(&text, &[], k));
        assert_eq!(mistakes.len(), 1, "{mistakes:?}");
        assert_eq!((mistakes[0].line, mistakes[0].column), (line, column), "{}", mistakes[0]);
        assert!(mistakes[0].problem.contains(problem), "{}", mistakes[0]);
    }
}

/// Checks that `--set` changes tracks, but not keys that a track animates.
#[test]
fn overrides_and_tracks_do_not_contradict() {
    let fovs = track("camera.fov", "values = [20, 40]");
    assert_eq!(fov(&frame(&fovs, &["animation.tracks.0.values=[30, 30]"], 7).expect("a good frame")), 30.0);
    let mistakes = mistakes_of(frame(&fovs, &["camera.fov=50"], 7));
    assert!(
        mistakes[0].to_string().starts_with("--set camera.fov=50:1:12: `camera.fov` is animated"),
        "{}",
        mistakes[0]
    );
}
