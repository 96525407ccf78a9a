//! Estimates the noise of an image that consists of random paths.
//!
//! *Theory.* The samples of a pixel differ, and the error of their mean is about the standard error, √(Σ(x − mean)²/(n (n − 1))).
//!
//! *Practice.* The device stores the sum of squares of the luminance. The noise is printed for every image, and is a layer of its EXR file.

use std::fmt;

/// The luminance weights of linear sRGB colors, as in the shaders.
pub(super) const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// Returns the luminance of one pixel of three planes.
pub(super) fn luminance(color: &[Vec<f32>; 3], pixel: usize) -> f32 {
    color.iter().zip(LUMINANCE).map(|(plane, part)| part * plane[pixel]).sum()
}

/// The luminance of an image's pixels, with their errors.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Noise {
    pixels: Vec<[f32; 2]>,
}

impl Noise {
    /// Adds a pixel: its luminance, and the standard error of the luminance.
    pub(super) fn add(&mut self, luminance: f32, error: f32) {
        self.pixels.push([luminance, error]);
    }

    /// Returns the root mean square of all errors divided by the image's mean; `None` if the image is black or has one sample per pixel.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        let sum = |of: fn(&[f32; 2]) -> f64| self.pixels.iter().map(of).sum::<f64>() / self.pixels.len().max(1) as f64;
        let (light, squares) = (sum(|[light, _]| f64::from(*light)), sum(|[_, error]| f64::from(*error).powi(2)));
        (light > 0.0 && squares.is_finite()).then(|| squares.sqrt() / light)
    }

    /// Returns the median of the error divided by the luminance, over all pixels that are not black.
    #[must_use]
    pub fn median(&self) -> Option<f64> {
        let lit = self.pixels.iter().filter(|[light, error]| *light > 0.0 && error.is_finite());
        let mut all: Vec<f64> = lit.map(|[light, error]| f64::from(*error) / f64::from(*light)).collect();
        let middle = all.len() / 2;
        (!all.is_empty()).then(|| *all.select_nth_unstable_by(middle, f64::total_cmp).1)
    }
}

impl fmt::Display for Noise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.mean(), self.median()) {
            (Some(mean), Some(median)) => {
                write!(f, "noise {:.2} % of the image's mean (median pixel {:.2} %)", 100.0 * mean, 100.0 * median)
            }
            _ => write!(f, "noise unknown, because the image is black or has one sample per pixel"),
        }
    }
}
