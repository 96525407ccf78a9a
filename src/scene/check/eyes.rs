//! The check of eyes against objects.

use crate::document::reader::TableReader;
use crate::model::{Camera, Object};

/// The relative resolution of float32 positions.
const TOLD_APART: f64 = 1e-6;

/// Reports an eye on a surface, because its side is undefined.
pub fn check(root: &TableReader, camera: &Camera, objects: &[Object]) {
    if !camera.projection.is_from_a_point() {
        return;
    }
    for eye in camera.eyes() {
        let on = |object: &Object| {
            let slack = TOLD_APART * (eye.length() + object.transform.0.translation.length());
            object.travel.is_none() && object.near_surface(eye, slack)
        };
        if let Some(i) = objects.iter().position(on) {
            let who = if camera.stereo.is_some() { "an eye of the camera" } else { "the camera" };
            let problem = format!("{who} is exactly on the surface of objects[{i}]");
            root.fault_within("camera", "position", problem, "move it off the surface".to_owned());
            return;
        }
    }
}
