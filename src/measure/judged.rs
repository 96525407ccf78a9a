//! The measure of the errors of rays.

use crate::scene::{Accuracy, Scene};

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
            (Self::Light, Accuracy::Pixels(part), Some(radiation)) => PIXEL_OF_LIGHT * part * radiation.tolerance,
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
}
