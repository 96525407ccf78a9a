//! How noisy a picture is that is made of random paths.
//!
//! *Theory.* A pixel's samples differ, and their mean is wrong by about its standard error, √(Σ(x − mean)²/(n (n − 1))).
//!
//! *Practice.* The device keeps the sum of squares, of luminance; what it comes to is said of every picture, and is a layer of its EXR.

use std::fmt;

/// The luminance of linear light in sRGB's primaries, as the shaders have it.
pub(super) const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// Of one pixel of three planes.
pub(super) fn luminance(color: &[Vec<f32>; 3], pixel: usize) -> f32 {
    color.iter().zip(LUMINANCE).map(|(plane, part)| part * plane[pixel]).sum()
}

/// Errors of a picture's pixels, beside what they show.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Noise {
    pixels: Vec<[f32; 2]>,
}

impl Noise {
    /// One more pixel: its luminance, and the standard error of that.
    pub(super) fn add(&mut self, luminance: f32, error: f32) {
        self.pixels.push([luminance, error]);
    }

    /// The root mean square of all errors over the picture's mean; none where that is black, or one sample says nothing of it.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        let sum = |of: fn(&[f32; 2]) -> f64| self.pixels.iter().map(of).sum::<f64>() / self.pixels.len().max(1) as f64;
        let (light, squares) = (sum(|[light, _]| f64::from(*light)), sum(|[_, error]| f64::from(*error).powi(2)));
        (light > 0.0 && squares.is_finite()).then(|| squares.sqrt() / light)
    }

    /// The median of each pixel's error over its own luminance, of those that are not black.
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
                write!(f, "noise {:.2} % of the picture's mean (median pixel {:.2} %)", 100.0 * mean, 100.0 * median)
            }
            _ => write!(f, "its noise is not known: nothing is lit, or pixels have one sample"),
        }
    }
}
