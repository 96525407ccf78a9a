//! The measure of the errors of rays.

use crate::model::volume::MOST_FREQUENCIES;
use crate::scene::{Accuracy, Precision, Scene};

/// The property of rays whose errors count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judged {
    /// The direction to the sky, or the position on a surface divided by the distance to it, in radians.
    Ends,
    /// The intensities at the frequencies of `[radiation]`, relative to them.
    Light,
}

/// The allowed error of light for a pixel, in units of the tolerance of `[radiation]`: a tenth of a pixel is ten times the error of a piece.
const PIXEL_OF_LIGHT: f64 = 100.0;

/// The errors of light below which methods are not compared, in 32 and in 64 bits, because the rounding of paths may add as much.
const FINEST_LIGHT: [f64; 2] = [3e-5, 3e-8];

impl Judged {
    /// Returns the measure for an image: light, if the image shows nothing else and no angle is required.
    #[must_use]
    pub fn of_image(scene: &Scene) -> Self {
        let asks_angle = scene.rays.auto.is_some_and(|auto| matches!(auto.accuracy, Accuracy::Radians(_)));
        if scene.radiation.is_some() && !asks_angle { Self::Light } else { Self::Ends }
    }

    /// Returns the required accuracy, or `None` if the scene specifies a method.
    #[must_use]
    pub fn accuracy(self, scene: &Scene) -> Option<f64> {
        let angle = scene.accuracy()?;
        Some(match (self, scene.rays.auto?.accuracy, &scene.radiation) {
            (Self::Light, Accuracy::Pixels(part), Some(radiation)) => {
                let least = FINEST_LIGHT[usize::from(scene.rays.precision == Precision::Double)];
                (PIXEL_OF_LIGHT * part * radiation.tolerance()).max(least)
            }
            _ => angle,
        })
    }

    /// Returns the words after an error.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Ends => "rad",
            Self::Light => "of their light",
        }
    }

    /// Returns the name of an error with its unit.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Ends => "error (rad)",
            Self::Light => "relative error of the light",
        }
    }
}

/// The intensities of a ray at up to this number of frequencies.
pub(super) type Spectrum = [f64; MOST_FREQUENCIES];

/// The part of the brightest intensity below which errors are relative to it, because they are not seen.
const FAINT: f64 = 1e-3;

/// Returns the intensities to which errors of fainter ones are relative.
pub(super) fn least_light<'a>(all: impl Iterator<Item = &'a [f64]>) -> Spectrum {
    let mut least = Spectrum::default();
    for light in all {
        least.iter_mut().zip(light).for_each(|(least, light)| *least = least.max(FAINT * light));
    }
    least
}

/// Returns the largest error of the intensities of a ray, relative to them and at least to `least`.
pub(super) fn light_error(light: &[f64], truth: &[f64], least: &Spectrum) -> f64 {
    let relative = |((light, truth), least): ((&f64, &f64), &f64)| match truth.max(*least) {
        0.0 => 0.0,
        counts => (light - truth).abs() / counts,
    };
    light.iter().zip(truth).zip(least).map(relative).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Faint light counts relative to the brightest of its frequency.
    #[test]
    fn light_is_compared_by_its_frequency() {
        let rays = [[8.0, 2e-3], [4.0, 1e-9]];
        let least = least_light(rays.iter().map(|ray| &ray[..]));
        assert!((least[0] - 8e-3).abs() < 1e-15 && (least[1] - 2e-6).abs() < 1e-18);
        assert!((light_error(&[4.0, 2e-9], &rays[1], &least) - 1e-9 / 2e-6).abs() < 1e-12);
        assert!((light_error(&[8.8, 2e-3], &rays[0], &least) - 0.1).abs() < 1e-12);
    }
}
