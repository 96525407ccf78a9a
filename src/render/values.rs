//! Reads the values of a finished tile: colors, layers, errors, and clamped light.

use super::adaptive::Moments;
use super::band::{Band, TilePlace};
use super::noise::luminance;
use super::records::Records;
use super::watch::Round;
use super::{Clamped, Noise, RenderError, Renderer};
use crate::gpu::Tile;
use crate::program::{Layer, LayerKind, Role};

/// The stored values of a tile's pixels.
pub(super) struct Values<'r> {
    pixels: Records<'r>,
    moments: Option<Vec<Moments>>,
    size: [u32; 2],
    margin: u32,
}

impl Renderer<'_> {
    /// Waits for a tile and reads its values.
    pub(super) fn read_values(&self, tile: &Tile) -> Result<Values<'_>, RenderError> {
        let roles = [&Role::Pixels, &Role::Moments];
        let [pixels, moments] = Records::read_all(self.prepared.gpu, &self.prepared.program, tile, roles)?;
        let margin = self.prepared.program.features.margin();
        Ok(Values { pixels, moments: Moments::of(&moments), size: tile.size, margin })
    }
}

impl Values<'_> {
    /// Copies the values of the tile after a round into a band; `left` is the tile's first column in the band.
    pub(super) fn put(&self, left: u32, round: &Round, wanted: &[Layer], band: &mut Band, noise: Option<&mut Noise>) {
        let errors = self.errors(round.until);
        let at = TilePlace { left, width: self.size[0], margin: self.margin };
        for (k, plane) in band.color.iter_mut().chain(&mut band.alpha).enumerate() {
            at.put(plane, band.width, self.channel(k, round.until).into_iter());
        }
        for layer in round.layers(wanted) {
            if let Some(words) = self.layer(layer, round.until, errors.as_deref()) {
                at.put_layer(layer, band, &words);
            }
        }
        if let (Some(errors), Some(noise)) = (errors, noise) {
            let mut own = vec![0.0; band.width as usize * band.rows as usize];
            at.put(&mut own, band.width, errors.into_iter());
            let columns = at.left..at.left + self.size[0] - at.margin;
            for (row, errors) in own.chunks_exact(band.width as usize).enumerate() {
                for column in columns.clone().map(|column| column as usize) {
                    let at = row * band.width as usize + column;
                    noise.add(luminance(&band.color, at), errors[column]);
                }
            }
        }
    }

    /// Returns the mean of a channel (red, green, blue or alpha) over this number of samples.
    fn channel(&self, k: usize, samples: u32) -> Vec<f32> {
        let weight = 1.0 / samples as f32;
        if let Some(moments) = &self.moments {
            return moments.iter().map(|moments| moments.color[k]).collect();
        }
        if k < 3 {
            return self.sums(k).map(|sum| sum * weight).collect();
        }
        let sums = self.pixels.column("alpha").into_iter().flatten();
        // From inside a medium, the sky may appear brighter than outside, so the mean may exceed 1.
        sums.map(|[sum]| (f32::from_bits(sum) * weight).clamp(0.0, 1.0)).collect()
    }

    /// Returns the sums of a channel's samples.
    fn sums(&self, k: usize) -> impl Iterator<Item = f32> {
        let sums = self.pixels.column::<3>("color").into_iter().flatten();
        sums.map(move |color| f32::from_bits(color[k]))
    }

    /// Returns the standard error of every pixel after `samples` samples, infinite for one sample; `None` if no errors were stored.
    fn errors(&self, samples: u32) -> Option<Vec<f32>> {
        if let Some(moments) = &self.moments {
            return Some(moments.iter().map(Moments::error).collect());
        }
        let n = samples as f32;
        let error = |[bits]: [u32; 1]| {
            if n > 1.0 { (f32::from_bits(bits) / (n * (n - 1.0))).max(0.0).sqrt() } else { f32::INFINITY }
        };
        Some(self.pixels.column("spread")?.map(error).collect())
    }

    /// Returns a layer, in one or three words per pixel; `None` if it was not stored.
    fn layer(&self, layer: Layer, samples: u32, errors: Option<&[f32]>) -> Option<Vec<u32>> {
        let number = |name: &str| Some(self.pixels.column::<1>(name)?.flatten().collect());
        let vector = |name: &str| Some(self.pixels.column::<3>(name)?.flatten().collect::<Vec<_>>());
        match (layer, &self.moments) {
            (Layer::StandardError, _) => Some(errors?.iter().map(|error| error.to_bits()).collect()),
            (Layer::Samples, Some(moments)) => Some(moments.iter().map(|moments| moments.rays).collect()),
            (Layer::Samples, None) => Some(vec![samples; self.size.map(|n| n as usize).iter().product()]),
            (Layer::Accumulated, None) => vector("color"),
            (Layer::LuminanceM2, None) => number("spread"),
            (Layer::Accumulated | Layer::LuminanceM2, Some(_)) => None,
            (Layer::ImageOrder, _) => {
                let weight = 1.0 / samples as f32;
                let mean = |sum: u32| (f32::from_bits(sum) * weight).to_bits();
                Some(vector("orders")?.into_iter().map(mean).collect())
            }
            (layer, _) if layer.kind() == LayerKind::Vector => vector(&format!("layer_{}", layer.name())),
            (layer, _) => number(&format!("layer_{}", layer.name())),
        }
    }

    /// Adds the light that clamping removed from the tile's samples and, in the last round, the remaining light.
    pub(super) fn add_clamped(&self, round: &Round, sums: &mut Clamped) {
        let (samples, light) = (self.pixels.column("clamped_samples"), self.pixels.column("clamped_light"));
        let (Some(samples), Some(light)) = (samples, light) else { return };
        sums.samples += samples.map(|[n]| u64::from(n)).sum::<u64>();
        sums.lost += light.map(|[bits]| f64::from(f32::from_bits(bits))).sum::<f64>();
        if !round.is_last {
            return;
        }
        sums.left += match &self.moments {
            Some(moments) => {
                let light = |moments: &Moments| f64::from(moments.color[..3].iter().sum::<f32>()) / 3.0;
                moments.iter().map(|moments| light(moments) * f64::from(moments.rays)).sum::<f64>()
            }
            None => (0..3).map(|k| self.sums(k).map(f64::from).sum::<f64>() / 3.0).sum(),
        };
    }
}
