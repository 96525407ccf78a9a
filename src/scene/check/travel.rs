//! The requirements of moving objects on a scene.

use glam::DVec3;

use crate::document::reader::TableReader;
use crate::model::{Camera, Object};
use crate::scene::Bound;
use crate::scene::optics::Optics;

pub fn check(root: &TableReader, camera: Option<&Camera>, bound: Option<Bound>, chords: bool, optics: &Optics) {
    if !optics.objects.iter().any(|object| object.travel.is_some()) {
        return;
    }
    let fault = |problem: &str, help: &str| root.fault(&["objects"], format!("an object moves, and {problem}"), help);
    if optics.law.is_some_and(|law| !law.facts().keeps_time) {
        let help = "use law.kind = \"straight\", \"kerr-newman\", \"wormhole\" or \"metric\"; a Schwarzschild black \
                    hole is kerr-newman without spin";
        fault("this law does not define the travel time of light", help);
    }
    if optics.paths.is_some() {
        fault("path tracing supports only static objects", "use lighting = \"direct\"");
    }
    if optics.objects.iter().any(|object| object.interior().is_some()) {
        fault("the travel time of light in interiors is not defined", "remove the interiors");
    }
    if chords {
        fault("these rays are chords, which do not record time", "use segment = \"arc\"");
    }
    let goes_on = |object: &Object| {
        let material = object.material().and_then(|i| optics.materials.get(i));
        object.travel.is_some() && material.is_some_and(|material| material.surface.facts().continues)
    };
    if optics.objects.iter().any(goes_on) {
        fault(
            "its material reflects or transmits rays, which is supported only for static objects",
            "use another material",
        );
    }
    let centers = bound.map(|bound| (bound.centers(optics.law), bound.radius));
    let is_outside = |camera: &Camera, (centers, radius): (Vec<DVec3>, f64)| {
        centers.iter().all(|center| center.distance(camera.position) > radius)
    };
    if camera.zip(centers).is_some_and(|(camera, balls)| is_outside(camera, balls)) {
        fault(
            "the camera is outside the bounding sphere, where the travel time of light is not recorded",
            "use a larger rays.bounding_sphere.radius",
        );
    }
}
