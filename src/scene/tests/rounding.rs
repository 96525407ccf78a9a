//! Tests of the warning about details that 32 bits cannot resolve.

use super::good;

/// Returns the warning for a ball seen from a position with an opening angle in degrees.
fn ball(position: [f64; 3], center: [f64; 3], radius: f64, fov: f64, precision: &str) -> Option<String> {
    let text = format!(
        "[image]\nsize = [320, 240]\n[camera]\nposition = {position:?}\nlook_at = {center:?}\nfov = {fov}\n\
         [rays]\nprecision = \"{precision}\"\nbounding_sphere = {{ radius = 1e8 }}\n[materials.m]\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"m\"\ncenter = {center:?}\nradius = {radius}\n"
    );
    good(&text).rounded_away()
}

/// Checks both sides of the threshold at which pixels differ between 32 and 64 bits, as measured with cameras not aligned with an axis.
#[test]
fn scenes_that_are_too_fine_for_32_bits_are_named() {
    let oblique = |distance: f64| [0.6, 0.48, 0.64].map(|x| x * distance);
    let beside = |x: f64| [x + 2.1, 2.3, 3.1];
    for (position, center, radius, fov, expected) in [
        (oblique(1e4), [0.0; 3], 1e-6, 2.3e-8, Some("a pixel is 2e-12 rad wide")),
        (oblique(1e4), [0.0; 3], 1e-6, 50.0, Some("32-bit positions are 8e-4 apart, and objects[0] is 2e-6 across")),
        (oblique(1e3), [0.0; 3], 1e-3, 2.3e-4, Some("the resolution of 32-bit directions is 1e-7")),
        (oblique(1e3), [0.0; 3], 1.0, 0.23, None),
        (oblique(1e2), [0.0; 3], 0.01, 0.023, None),
        (beside(1e6), [1e6, 0.0, 0.0], 1.0, 50.0, Some("objects[0]: at 1e6 from the origin")),
        (beside(1e5), [1e5, 0.0, 0.0], 1.0, 50.0, Some("objects[0]: at 1e5 from the origin")),
        (beside(1e4), [1e4, 0.0, 0.0], 1.0, 50.0, None),
    ] {
        let found = ball(position, center, radius, fov, "f32");
        assert_eq!(found.is_some(), expected.is_some(), "{position:?} {radius}: {found:?}");
        assert!(found.unwrap_or_default().contains(expected.unwrap_or_default()), "{position:?} {radius}");
        assert_eq!(ball(position, center, radius, fov, "f64"), None);
    }
}
