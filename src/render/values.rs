//! What is read back of a finished tile: colours, layers, errors, and what was clamped.

use super::adaptive::Moments;
use super::band::{Band, TilePlace};
use super::noise::luminance;
use super::readback::read_texture;
use super::watch::Round;
use super::{Clamped, Noise, RenderError, Renderer};
use crate::gpu::Tile;
use crate::program::{Channel, Layer, Role};

impl Renderer<'_> {
    /// What a tile has come to after a round, into a band whose column `left` is the tile's first.
    pub(super) fn read_tile(
        &self,
        tile: &Tile,
        left: u32,
        round: &Round,
        band: &mut Band,
        noise: Option<&mut Noise>,
    ) -> Result<(), RenderError> {
        let samples = round.until;
        let moments = self.read_moments(tile)?;
        let errors = self.read_errors(tile, samples, moments.as_deref())?;
        let at = TilePlace { left, width: tile.size[0], margin: self.program.features.margin() };
        let weight = 1.0 / samples as f32;
        let planes = band.color.iter_mut().chain(&mut band.alpha);
        let channels = [Channel::Red, Channel::Green, Channel::Blue, Channel::Alpha];
        for (k, (plane, channel)) in planes.zip(channels).enumerate() {
            if let Some(moments) = &moments {
                at.put(plane, band.width, moments.iter().map(|moments| moments.color[k]));
            } else if let Some(texture) = tile.texture(&Role::Color(channel)) {
                let sums = read_texture(self.gpu, texture)?;
                // A sky that is seen from inside of a medium may be brighter than it is.
                let kept = |mean: f32| if channel == Channel::Alpha { mean.clamp(0.0, 1.0) } else { mean };
                at.put(plane, band.width, sums.iter().map(|bits| kept(f32::from_bits(*bits) * weight)));
            }
        }
        for layer in round.layers(&self.settings.choice.layers) {
            let words = match (layer, &moments, tile.texture(&Role::Layer(layer))) {
                (Layer::Error, ..) => match &errors {
                    Some(errors) => errors.iter().map(|error| error.to_bits()).collect(),
                    None => continue,
                },
                (Layer::Samples, Some(moments), _) => moments.iter().map(|moments| moments.rays).collect(),
                (Layer::Samples, None, _) => vec![samples; tile.size.map(|n| n as usize).iter().product()],
                (Layer::Sums, None, _) => self.read_three(tile, &COLORS.map(Role::Color), 1.0)?,
                (Layer::Orders, ..) => self.read_three(tile, &ORDERS.map(Role::Kept), weight)?,
                (Layer::Spread, None, _) => match tile.texture(&Role::Kept("spread")) {
                    Some(texture) => read_texture(self.gpu, texture)?,
                    None => continue,
                },
                (_, _, Some(texture)) => read_texture(self.gpu, texture)?,
                _ => continue,
            };
            at.put_layer(layer, band, &words);
        }
        if let (Some(errors), Some(noise)) = (errors, noise) {
            let mut own = vec![0.0; band.width as usize * band.rows as usize];
            at.put(&mut own, band.width, errors.into_iter());
            let columns = at.left..at.left + tile.size[0] - at.margin;
            for (row, errors) in own.chunks_exact(band.width as usize).enumerate() {
                for column in columns.clone().map(|column| column as usize) {
                    let at = row * band.width as usize + column;
                    noise.add(luminance(&band.color, at), errors[column]);
                }
            }
        }
        Ok(())
    }

    /// Adds what a tile's samples have lost because they were too bright, and what is left.
    pub(super) fn read_clamped(&self, tile: &Tile, round: &Round, sums: &mut Clamped) -> Result<(), RenderError> {
        let kept = |name| tile.texture(&Role::Kept(name));
        let (Some(samples), Some(light)) = (kept("clamped_samples"), kept("clamped_light")) else { return Ok(()) };
        sums.samples += read_texture(self.gpu, samples)?.into_iter().map(u64::from).sum::<u64>();
        sums.lost += floats(&read_texture(self.gpu, light)?).sum::<f64>();
        if !round.is_last {
            return Ok(());
        }
        if let Some(moments) = self.read_moments(tile)? {
            let light = |moments: &Moments| f64::from(moments.color[..3].iter().sum::<f32>()) / 3.0;
            sums.left += moments.iter().map(|moments| light(moments) * f64::from(moments.rays)).sum::<f64>();
            return Ok(());
        }
        for channel in COLORS {
            if let Some(texture) = tile.texture(&Role::Color(channel)) {
                sums.left += floats(&read_texture(self.gpu, texture)?).sum::<f64>() / 3.0;
            }
        }
        Ok(())
    }

    /// Sums of a tile, each times a weight, in fours as the texels of a layer are.
    fn read_three(&self, tile: &Tile, roles: &[Role; 3], weight: f32) -> Result<Vec<u32>, RenderError> {
        let texels = tile.size.map(|n| n as usize).iter().product::<usize>();
        let mut words = vec![0; 4 * texels];
        for (k, role) in roles.iter().enumerate() {
            if let Some(texture) = tile.texture(role) {
                let sums = read_texture(self.gpu, texture)?;
                let weighed = sums.into_iter().map(|bits| (f32::from_bits(bits) * weight).to_bits());
                words.iter_mut().skip(k).step_by(4).zip(weighed).for_each(|(word, sum)| *word = sum);
            }
        }
        Ok(words)
    }
}

const COLORS: [Channel; 3] = [Channel::Red, Channel::Green, Channel::Blue];
const ORDERS: [&str; 3] = ["order_first", "order_second", "order_third"];

fn floats(words: &[u32]) -> impl Iterator<Item = f64> {
    words.iter().map(|bits| f64::from(f32::from_bits(*bits)))
}
