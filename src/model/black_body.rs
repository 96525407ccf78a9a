//! The color of black bodies.
//!
//! *Theory.* Planck's law, weighted by the CIE 1931 standard observer in the multi-lobe fit of Wyman, Sloan and Shirley (2013), in linear
//! sRGB. Black-body radiation with redshift g is black-body radiation of g times the temperature, including its brightness.
//!
//! *Practice.* Below about 1900 K the color is outside the sRGB gamut, and its blue channel is 0 instead of negative.

use glam::{DMat3, DVec3};

/// Returns the linear sRGB color with luminance 1 and the natural logarithm of the luminance, for a temperature in kelvins.
#[must_use]
pub fn color(kelvin: f64) -> (DVec3, f64) {
    // h c / k, in nm K. The exponents are relative to the middle of the visible range, so that no power of e overflows.
    const C2: f64 = 1.438_776_877e7;
    let middle = C2 / (560.0 * kelvin);
    let steps = 94;
    let xyz: DVec3 = (0..=steps)
        .map(|i| {
            let nm = 360.0 + 5.0 * f64::from(i);
            let x = C2 / (nm * kelvin);
            let radiance = (560.0 / nm).powi(5) * ((middle - x).exp() / -(-x).exp_m1());
            radiance * observer(nm)
        })
        .sum();
    let to_srgb = DMat3::from_cols(
        DVec3::new(3.2406, -0.9689, 0.0557),
        DVec3::new(-1.5372, 1.8758, -0.2040),
        DVec3::new(-0.4986, 0.0415, 1.0570),
    );
    ((to_srgb * xyz / xyz.y).max(DVec3::ZERO), xyz.y.ln() - middle)
}

fn observer(nm: f64) -> DVec3 {
    let lobe = |height: f64, at: f64, below: f64, above: f64| {
        let off = (nm - at) / if nm < at { below } else { above };
        height * (-0.5 * off * off).exp()
    };
    DVec3::new(
        lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) - lobe(0.065, 501.1, 20.4, 26.2),
        lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
        lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8),
    )
}
