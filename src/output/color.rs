//! From linear light to what a screen shows: exposure, tone map, the sRGB curve.
//!
//! A pixel with a component that is negative, infinite or not a number is the mark of a fault somewhere; it is shown
//! in magenta rather than clamped to look like the others. The arithmetic is in `f64`, where no `f32` overflows.

use crate::scene::Tonemap;

/// The mapped value of a linear one, from 0 to 1: cut off at 1, or bent by Narkowicz's fit of the ACES film curve (2015),
/// `x(2.51x + 0.03) / (x(2.43x + 0.59) + 0.14)`, per channel.
#[must_use]
pub fn tonemapped(tonemap: Tonemap, x: f64) -> f64 {
    let mapped = match tonemap {
        Tonemap::None => x,
        Tonemap::Filmic => x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14),
    };
    mapped.clamp(0.0, 1.0)
}

/// What is shown for a pixel that cannot be right.
const FAULT: [f64; 3] = [1.0, 0.0, 1.0];

/// The sRGB encoding (IEC 61966-2-1) of a linear value from 0 to 1.
#[must_use]
pub fn srgb_from_linear(x: f64) -> f64 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
}

/// The sRGB values, from 0 to 1, of a linear colour multiplied by `gain`.
#[must_use]
pub fn display(color: [f32; 3], gain: f64, tonemap: Tonemap) -> [f64; 3] {
    if color.iter().any(|c| !c.is_finite() || *c < 0.0) {
        return FAULT;
    }
    color.map(|c| srgb_from_linear(tonemapped(tonemap, f64::from(c) * gain)))
}
