//! The results of adaptive sampling, of clamping, and of the search for stars.

use std::fmt;

use super::records::Row;

/// The result of adaptive sampling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Adaptive {
    /// The number of pixels of the window.
    pub pixels: u64,
    /// The number of samples of all pixels together, with the rays through their corners.
    pub samples: u64,
    /// The number of pixels that took all allowed samples without reaching the tolerance.
    pub capped: u64,
    /// The maximum number of samples of a pixel.
    pub most: u32,
    /// The largest acceptable standard error of a mean, in display values.
    pub tolerance: f64,
}

impl Adaptive {
    /// Returns the average number of samples per pixel.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.samples as f64 / self.pixels as f64
    }
}

impl fmt::Display for Adaptive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixels, capped, most, tolerance, .. } = self;
        write!(f, "{:.2} samples per pixel, ", self.mean())?;
        if *capped == 0 {
            return write!(f, "all pixels within {tolerance}");
        }
        let share = 100.0 * *capped as f64 / *pixels as f64;
        write!(f, "{capped} pixels ({share:.2} %) not within {tolerance} after {most} samples")
    }
}

/// The numbers of images of stars. Tiles share those near their edges.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct StarImages {
    /// The number of images.
    pub images: u64,
    /// The number of images whose brightness the size of the star limits, because they are on a critical curve.
    pub limited: u64,
    /// The number of squares between pixels that show the mean light of many stars.
    pub averaged: u64,
}

impl StarImages {
    /// Adds the counts of a tile.
    pub(super) fn add(&mut self, counts: &Row) {
        let count = |name: &str| u64::from(counts.uint(name));
        self.images += count("images");
        self.limited += count("limited");
        self.averaged += count("averaged");
    }
}

impl fmt::Display for StarImages {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} images of stars", self.images)?;
        if self.limited > 0 {
            write!(f, ", {} as bright as their size allows", self.limited)?;
        }
        if self.averaged > 0 {
            write!(f, ", {} squares between pixels show the mean of many", self.averaged)?;
        }
        Ok(())
    }
}

/// The light removed from samples that were too bright.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Clamped {
    /// The number of these samples.
    pub samples: u64,
    /// The removed radiance, summed over all colors and all samples of the image.
    pub lost: f64,
    /// The remaining radiance of all samples.
    pub left: f64,
}

impl Clamped {
    /// Returns the removed fraction of all light.
    #[must_use]
    pub fn share(&self) -> f64 {
        let all = self.lost + self.left;
        if all > 0.0 { self.lost / all } else { 0.0 }
    }
}

impl fmt::Display for Clamped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} samples clamped, removing {:.2} % of the light", self.samples, 100.0 * self.share())
    }
}
