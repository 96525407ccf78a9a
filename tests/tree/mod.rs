//! Tests the recursive tracer itself, because it is the reference for images.

mod device;
mod interfaces;
mod overlaps;
mod paths;
mod sums;
mod touching;

use crate::support::scene;
use crate::support::tree::Tracer;
use glam::DVec3;

/// Returns the text of a scene with these objects added to it.
fn with_objects(text: &str, objects: &[&str]) -> String {
    objects.iter().fold(text.to_owned(), |text, object| text + "[[objects]]\n" + object + "\n")
}

/// Returns the image of a scene's text.
fn picture(text: &str) -> Vec<DVec3> {
    Tracer::new(&scene(text)).render()
}

/// Returns the largest difference between two images.
fn difference(a: &[DVec3], b: &[DVec3]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs().max_element()).fold(0.0, f64::max)
}
