//! What a render is told besides its scene: what there is already, and who wants to know how far it is.

use std::time::Duration;

use super::band::{Band, Plane};
use super::records::Records;
use super::{RenderError, Window};
use crate::gpu::{Gpu, GpuError, Tile};
use crate::program::{Layer, Program, Role};
use crate::progress::Stage;

/// How a render is watched.
#[derive(Clone, Copy, Default)]
pub struct Watch<'w> {
    /// Samples that need not be taken again.
    pub earlier: Option<&'w Earlier>,
    /// Who looks at the picture while it is made. Not at adaptive ones, whose pixels do not take their samples together.
    pub preview: Option<&'w dyn Preview>,
}

/// Looks at a picture while it is made.
pub trait Preview {
    /// The time between two looks, about.
    fn every(&self) -> Duration;
    /// The whole window after so many samples.
    fn look(&self, picture: &Band, samples: u32) -> Result<(), RenderError>;
}

impl std::fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Watch").field("earlier", &self.earlier).finish_non_exhaustive()
    }
}

/// Some samples of every pixel of the window, and then no more before all tiles have theirs.
pub(super) struct Round<'r> {
    /// What there is before it.
    pub earlier: Option<&'r Earlier>,
    /// How many samples there are behind it.
    pub until: u32,
    /// Is the picture done then?
    pub is_last: bool,
    /// The stage of the whole picture, whose units are samples, and the first of them.
    told: Option<(&'r Stage, u32)>,
}

impl<'r> Round<'r> {
    pub fn new(earlier: Option<&'r Earlier>, until: u32, is_last: bool) -> Self {
        Self { earlier, until, is_last, told: None }
    }

    /// Reports the round to the stage of the whole picture, whose units are samples from `first` on.
    pub fn told(self, stage: &'r Stage, first: u32) -> Self {
        Self { told: Some((stage, first)), ..self }
    }

    /// The first sample that it takes.
    pub fn begins(&self) -> u32 {
        self.earlier.map_or(0, |earlier| earlier.samples)
    }

    /// Tells that a part of it is done. The last round is all that is left.
    pub fn tell(&self, part: f64) {
        let Some((stage, first)) = self.told else { return };
        stage.reach(f64::from(self.begins() - first) + part * f64::from(self.until - self.begins()));
    }

    /// The layers that are read behind it: those of the picture, and before its end what the next round goes on from.
    pub fn layers(&self, wanted: &[Layer]) -> Vec<Layer> {
        let sums = [Layer::Sums, Layer::Spread].into_iter().filter(|layer| !self.is_last && !wanted.contains(layer));
        wanted.iter().copied().chain(sums).collect()
    }
}

/// The samples of a picture that was rendered before, as its file keeps them.
///
/// A sample's ray does not depend on how many there will be, and sums are kept bit for bit, so that the picture that goes on from here is
/// the one that a single longer render would have made.
#[derive(Debug, Clone, PartialEq)]
pub struct Earlier {
    /// How many samples each pixel has.
    pub samples: u32,
    /// All rows of the window, with the layers [`Layer::Sums`] and [`Layer::Spread`].
    pub band: Band,
}

/// Returns the sum that has this mean: to the last digit if it is a count of samples, as it mostly is.
fn sum_of(mean: f32, samples: f32) -> f32 {
    let sum = mean * samples;
    let count = sum.round();
    if (sum - count).abs() <= f32::EPSILON * count { count } else { sum }
}

impl Earlier {
    /// Puts the sums of a part of the window into a tile of that size, beside what its pixels keep already.
    pub(super) fn put(&self, gpu: &Gpu, program: &Program, tile: &Tile, part: Window) -> Result<(), GpuError> {
        let band = &self.band;
        let mut pixels = Records::read(gpu, program, tile, &Role::Pixels)?;
        let Window { origin: [left, top], size: [columns, rows] } = part;
        let mut put = |name: &str, k: usize, value: &dyn Fn(usize) -> f32| {
            let Some(field) = pixels.field(name) else { return };
            for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
                let from = ((top + row) * band.width + left + column) as usize;
                pixels.set((row * tile.size[0] + column) as usize, field, k, value(from));
            }
        };
        if let Some(Plane::Vector(sums)) = band.layer(Layer::Sums) {
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
        if let Some(Plane::Scalar(spread)) = band.layer(Layer::Spread) {
            put("spread", 0, &|at| spread[at]);
        }
        tile.write(gpu, &Role::Pixels, 0, pixels.bytes());
        Ok(())
    }

    /// Layers of the first samples, which are not taken again, for the rows of a band.
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
                _ => {}
            }
        }
    }
}
