//! Configures a render beyond its scene: the samples that exist already, and a preview.

use std::time::Duration;

use super::band::{Band, Plane};
use super::records::Records;
use super::{RenderError, Window};
use crate::gpu::{Gpu, GpuError, Tile};
use crate::program::{Layer, Program, Role};
use crate::progress::Stage;

/// The earlier samples and the preview of a render.
#[derive(Clone, Copy, Default)]
pub struct Watch<'w> {
    /// Samples that need not be taken again.
    pub earlier: Option<&'w EarlierSamples>,
    /// The preview of the unfinished image; not available for adaptive images, whose pixels do not take their samples together.
    pub preview: Option<&'w dyn Preview>,
    /// The layers to read back; `None` for all that the program keeps.
    pub layers: Option<&'w [Layer]>,
}

/// Receives an image while it is rendered.
pub trait Preview {
    /// Returns the approximate time between two previews.
    fn every(&self) -> Duration;
    /// Receives the whole window after `samples` samples.
    ///
    /// # Errors
    ///
    /// Returns an error to end the render, for example if the preview cannot be written.
    fn look(&self, picture: &Band, samples: u32) -> Result<(), RenderError>;
}

impl std::fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Watch").field("earlier", &self.earlier).finish_non_exhaustive()
    }
}

/// A number of samples of every pixel of the window, which all tiles complete before the next round.
pub(super) struct Round<'r> {
    /// The samples taken before this round.
    pub earlier: Option<&'r EarlierSamples>,
    /// The number of samples after this round.
    pub until: u32,
    /// `true` if the image is complete after this round.
    pub is_last: bool,
    /// The layers of the image.
    wanted: &'r [Layer],
    /// The stage of the whole image, whose units are samples, and its first sample.
    told: Option<(&'r Stage, u32)>,
}

impl<'r> Round<'r> {
    pub fn new(earlier: Option<&'r EarlierSamples>, until: u32, is_last: bool, wanted: &'r [Layer]) -> Self {
        Self { earlier, until, is_last, wanted, told: None }
    }

    /// Reports the round to the stage of the whole image, whose units are samples, starting at `first`.
    pub fn told(self, stage: &'r Stage, first: u32) -> Self {
        Self { told: Some((stage, first)), ..self }
    }

    /// Returns the first sample of the round.
    pub fn begins(&self) -> u32 {
        self.earlier.map_or(0, |earlier| earlier.samples)
    }

    /// Reports that the fraction `part` of the round is done. The last round contains all remaining samples.
    pub fn tell(&self, part: f64) {
        let Some((stage, first)) = self.told else { return };
        stage.reach(f64::from(self.begins() - first) + part * f64::from(self.until - self.begins()));
    }

    /// Returns the layers that are read after the round: the layers of the image, and before its end the sums for the next round.
    pub fn layers(&self) -> Vec<Layer> {
        let sums = [Layer::Accumulated, Layer::LuminanceM2]
            .into_iter()
            .filter(|layer| !self.is_last && !self.wanted.contains(layer));
        self.wanted.iter().copied().chain(sums).collect()
    }
}

/// The samples of an earlier render, as its file stores them.
///
/// The ray of a sample does not depend on the number of samples, and sums are stored exactly. The continued image is therefore
/// bit-identical to the image of a single longer render.
#[derive(Debug, Clone, PartialEq)]
pub struct EarlierSamples {
    /// The number of samples of each pixel.
    pub samples: u32,
    /// All rows of the window, with the layers [`Layer::Accumulated`] and [`Layer::LuminanceM2`].
    pub band: Band,
}

/// Returns the sum for this mean: exactly, if it is a count of samples, as is usual.
fn sum_of(mean: f32, samples: f32) -> f32 {
    let sum = mean * samples;
    let count = sum.round();
    if (sum - count).abs() <= f32::EPSILON * count { count } else { sum }
}

impl EarlierSamples {
    /// Writes the sums of a part of the window into a tile of that size with a margin before it, and keeps the other values of its pixels.
    pub(super) fn put(
        &self,
        gpu: &Gpu,
        program: &Program,
        tile: &Tile,
        part: Window,
        margin: u32,
    ) -> Result<(), GpuError> {
        let band = &self.band;
        let pixels = Records::read(gpu, program, tile, &Role::Pixels)?;
        let mut bytes = pixels.bytes().to_vec();
        let Window { origin: [left, top], size: [columns, rows] } = part;
        let mut put = |name: &str, k: usize, value: &dyn Fn(usize) -> f32| {
            for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
                let from = ((top + row) * band.width + left + column) as usize;
                let Some(at) = pixels.offset(((row + margin) * tile.size[0] + column + margin) as usize, name, k)
                else {
                    return;
                };
                bytes[at..at + 4].copy_from_slice(&value(from).to_ne_bytes());
            }
        };
        if let Some(Plane::Vector(sums)) = band.layer(Layer::Accumulated) {
            for (k, sums) in sums.iter().enumerate() {
                put("color", k, &|at| sums[at]);
            }
        }
        if let Some(alpha) = &band.alpha {
            put("alpha", 0, &|at| sum_of(alpha[at], self.samples as f32));
        }
        for counted in ["clamped_samples", "clamped_light"] {
            put(counted, 0, &|_| 0.0);
        }
        if let Some(Plane::Scalar(spread)) = band.layer(Layer::LuminanceM2) {
            put("spread", 0, &|at| spread[at]);
        }
        tile.write(gpu, &Role::Pixels, 0, &bytes);
        Ok(())
    }

    /// Copies the layers of the first samples, which are not taken again, into the rows of a band.
    pub(super) fn put_first(&self, band: &mut Band) {
        let (start, count) = ((band.first_row * band.width) as usize, (band.rows * band.width) as usize);
        let range = start..start + count;
        for (layer, plane) in band.layers.iter_mut().filter(|(layer, _)| layer.is_of_a_ray()) {
            match (plane, self.band.layer(*layer)) {
                (Plane::Scalar(own), Some(Plane::Scalar(all))) => own.copy_from_slice(&all[range.clone()]),
                (Plane::Id(own), Some(Plane::Id(all))) => own.copy_from_slice(&all[range.clone()]),
                (Plane::Vector(own), Some(Plane::Vector(all))) => {
                    own.iter_mut().zip(all).for_each(|(own, all)| own.copy_from_slice(&all[range.clone()]));
                }
                (Plane::Crossings(own), Some(Plane::Crossings(all))) => {
                    own.iter_mut().zip(all).for_each(|(own, all)| own.copy_from_slice(&all[range.clone()]));
                }
                _ => {}
            }
        }
    }
}
