//! Reads the values of a finished tile: colors, layers, errors, and clamped light.

use super::adaptive::Moments;
use super::band::{Band, TilePlace, Words};
use super::crossings::{Crossings, crossings};
use super::noise::luminance;
use super::records::Records;
use super::watch::Round;
use super::{Clamped, FrequencyTotals, Noise, RenderError, Renderer};
use crate::gpu::Tile;
use crate::program::{Layer, Margin, Role};

/// The stored values of a tile's pixels.
pub(super) struct Values<'r> {
    pixels: Records<'r>,
    moments: Option<Vec<Moments>>,
    crossings: Vec<Crossings>,
    /// The intensity 1, in the units of layers.
    intensity: f64,
    /// The frequencies with a mean redshift, each with its place among the intensities.
    mean_redshifts: Vec<(usize, usize)>,
    size: [u32; 2],
    margin: Margin,
}

impl Renderer<'_> {
    /// Waits for a tile and reads its values.
    pub(super) fn read_values(&self, tile: &Tile) -> Result<Values<'_>, RenderError> {
        let roles = [&Role::Pixels, &Role::Moments];
        let [pixels, moments] = Records::read_all(self.prepared.gpu, &self.prepared.program, tile, roles)?;
        let features = &self.prepared.program.features;
        let crossings = if features.keeps_crossings { crossings(&pixels, &self.prepared.scene) } else { Vec::new() };
        let (size, margin, intensity) =
            (tile.size, features.margin(), self.prepared.scene.intensity_unit().unwrap_or(1.0));
        let mean_redshifts =
            features.mean_redshifts(&self.prepared.scene).zip(self.prepared.scene.frequencies()..).collect();
        Ok(Values { pixels, moments: Moments::of(&moments), crossings, intensity, mean_redshifts, size, margin })
    }
}

impl Values<'_> {
    /// Copies the values of the tile after a round into a band; `left` is the tile's first column in the band.
    pub(super) fn put(&self, left: u32, round: &Round, band: &mut Band, noise: Option<&mut Noise>) {
        let errors = self.errors(round.until);
        let at = TilePlace { left, width: self.size[0], margin: self.margin };
        self.put_colors(&at, round.until, band);
        for layer in round.layers() {
            if let Some(words) = self.layer(layer, round.until, errors.as_deref()) {
                at.put_layer(layer, band, &*words);
            }
        }
        if let (Some(errors), Some(noise)) = (errors, noise) {
            let mut own = vec![0.0; band.width as usize * band.rows as usize];
            at.put([&mut own], band.width, |pixel| [errors[pixel]]);
            let columns = at.left..at.left + self.size[0] - at.margin.total();
            for (row, errors) in own.chunks_exact(band.width as usize).enumerate() {
                for column in columns.clone().map(|column| column as usize) {
                    let at = row * band.width as usize + column;
                    noise.add(luminance(&band.color, at), errors[column]);
                }
            }
        }
    }

    /// Copies the means of red, green, blue and alpha of each pixel over this number of samples.
    fn put_colors(&self, at: &TilePlace, samples: u32, band: &mut Band) {
        let width = band.width;
        let color = band.color.each_mut().map(Vec::as_mut_slice);
        if let Some(moments) = &self.moments {
            at.put(color, width, |pixel| moments[pixel].color.first_chunk().copied().unwrap_or_default());
            if let Some(alpha) = &mut band.alpha {
                at.put([alpha], width, |pixel| [moments[pixel].color[3]]);
            }
            return;
        }
        let weight = 1.0 / samples as f32;
        if let Some(sums) = self.pixels.column("color") {
            at.put(color, width, |pixel| [0, 1, 2].map(|k| f32::from_bits(sums(pixel, k)) * weight));
        }
        if let (Some(alpha), Some(sums)) = (&mut band.alpha, self.pixels.column("alpha")) {
            // From inside a medium, the sky may appear brighter than outside, so the mean may exceed 1.
            at.put([alpha], width, |pixel| [(f32::from_bits(sums(pixel, 0)) * weight).clamp(0.0, 1.0)]);
        }
    }

    /// Returns the standard error of every pixel after `samples` samples, infinite for one sample; `None` if no errors were stored.
    fn errors(&self, samples: u32) -> Option<Vec<f32>> {
        if let Some(moments) = &self.moments {
            return Some(moments.iter().map(Moments::error).collect());
        }
        let n = samples as f32;
        let error = |bits: u32| {
            if n > 1.0 { (f32::from_bits(bits) / (n * (n - 1.0))).max(0.0).sqrt() } else { f32::INFINITY }
        };
        let spread = self.pixels.column("spread")?;
        Some((0..self.pixels.count()).map(|pixel| error(spread(pixel, 0))).collect())
    }

    /// Returns the words of a layer, one or three per pixel; `None` if it was not stored.
    fn layer<'v>(&'v self, layer: Layer, samples: u32, errors: Option<&'v [f32]>) -> Option<Box<Words<'v>>> {
        let column = |name: &str| -> Option<Box<Words<'v>>> { Some(Box::new(self.pixels.column(name)?)) };
        match (layer, &self.moments) {
            (Layer::StandardError, _) => errors.map(|all| -> Box<Words> { Box::new(|pixel, _| all[pixel].to_bits()) }),
            (Layer::Samples, Some(moments)) => Some(Box::new(|pixel, _| moments[pixel].rays)),
            (Layer::Samples, None) => Some(Box::new(move |_, _| samples)),
            (Layer::Accumulated, None) => column("color"),
            (Layer::LuminanceM2, None) => column("spread"),
            (Layer::Accumulated | Layer::LuminanceM2, Some(_)) => None,
            (Layer::ImageOrder, _) => {
                let (sums, weight) = (self.pixels.column("orders")?, 1.0 / samples as f32);
                Some(Box::new(move |pixel, k| (f32::from_bits(sums(pixel, k)) * weight).to_bits()))
            }
            (Layer::Intensity(k) | Layer::OpticalDepth(k), _) => {
                let is_light = matches!(layer, Layer::Intensity(_));
                let sums = self.pixels.column(if is_light { "intensity" } else { "optical_depth" })?;
                let weight = if is_light { self.intensity as f32 } else { 1.0 } / samples as f32;
                Some(Box::new(move |pixel, _| (f32::from_bits(sums(pixel, usize::from(k))) * weight).to_bits()))
            }
            (Layer::MeanRedshift(k), _) => {
                let sums = self.pixels.column("intensity")?;
                let (own, place) = *self.mean_redshifts.iter().find(|(own, _)| *own == usize::from(k))?;
                let light = move |pixel, place| f32::from_bits(sums(pixel, place));
                let mean = move |pixel, _| match light(pixel, own) {
                    0.0 => 0.0,
                    all => light(pixel, place) / all,
                };
                Some(Box::new(move |pixel, k| mean(pixel, k).to_bits()))
            }
            (layer, _) if layer.is_of_crossings() => Some(Box::new(move |pixel, k| {
                let crossing = self.crossings.get(pixel).and_then(|crossings| crossings[k]);
                (crossing.map_or(0.0, |crossing| crossing.value(layer)) as f32).to_bits()
            })),
            (layer, _) => column(&format!("layer_{}", layer.name())),
        }
    }

    /// Adds the light of the tile's pixels after the last round at each of `count` frequencies.
    pub(super) fn add_radiation(&self, round: &Round, count: usize, sums: &mut Vec<FrequencyTotals>) {
        let (light, depth) = (self.pixels.column("intensity"), self.pixels.column("optical_depth"));
        let (Some(light), Some(depth)) = (light, depth) else { return };
        if !round.is_last {
            return;
        }
        sums.resize(count, FrequencyTotals::default());
        let weight = 1.0 / f64::from(round.until);
        let number = |bits: u32| f64::from(f32::from_bits(bits)) * weight;
        let own = self.size.map(|side| (side - self.margin.total()) as usize);
        for (k, sum) in sums.iter_mut().enumerate() {
            for pixel in (0..own[1]).flat_map(|y| (0..own[0]).map(move |x| (y, x))) {
                let before = self.margin.before as usize;
                let pixel = (pixel.0 + before) * self.size[0] as usize + pixel.1 + before;
                sum.add(self.intensity * number(light(pixel, k)), number(depth(pixel, k)));
            }
        }
    }

    /// Adds the light that clamping removed from the tile's samples and, in the last round, the remaining light.
    pub(super) fn add_clamped(&self, round: &Round, sums: &mut Clamped) {
        let (samples, light) = (self.pixels.column("clamped_samples"), self.pixels.column("clamped_light"));
        let (Some(samples), Some(light)) = (samples, light) else { return };
        let pixels = 0..self.pixels.count();
        sums.samples += pixels.clone().map(|pixel| u64::from(samples(pixel, 0))).sum::<u64>();
        sums.lost += pixels.clone().map(|pixel| f64::from(f32::from_bits(light(pixel, 0)))).sum::<f64>();
        if !round.is_last {
            return;
        }
        if let Some(moments) = &self.moments {
            let light = |moments: &Moments| f64::from(moments.color[..3].iter().sum::<f32>()) / 3.0;
            sums.left += moments.iter().map(|moments| light(moments) * f64::from(moments.rays)).sum::<f64>();
        } else if let Some(color) = self.pixels.column("color") {
            let channel = |k| pixels.clone().map(|pixel| f64::from(f32::from_bits(color(pixel, k)))).sum::<f64>();
            sums.left += (0..3).map(|k| channel(k) / 3.0).sum::<f64>();
        }
    }
}
