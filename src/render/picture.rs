//! Rendering a picture: tiles, samples, and rows given out as they are finished.

use std::time::Instant;

use super::adaptive::Moments;
use super::band::{Band, Rendering, TilePlace};
use super::clock::Clock;
use super::noise::luminance;
use super::readback::read_texture;
use super::renderer::Walks;
use super::sample::Sample;
use super::watch::Watch;
use super::{Adaptive, Clamped, Noise, RenderError, Renderer, Totals, Window};
use crate::gpu::Tile;
use crate::program::{Channel, Layer, Role};

impl Renderer<'_> {
    /// Renders the picture tile by tile; `rows` is given bands of full rows from top to bottom, `progress` the fraction that
    /// is done.
    pub fn render(
        &self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        progress: &dyn Fn(f64),
    ) -> Result<Totals, RenderError> {
        self.render_watched(rows, &Watch::of(progress))
    }

    /// As [`render`](Self::render), with samples that there are already, and looked at while it is made.
    pub fn render_watched(
        &self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        watch: &Watch,
    ) -> Result<Totals, RenderError> {
        let started = Instant::now();
        let mut clock = Clock::new(self.gpu, self.settings.apart);
        let noise = self.scene.rays.paths.map(|_| Noise::default());
        let clamped = self.scene.output.clamp.map(|_| Clamped::default());
        let mut totals = Totals { adaptive: self.adaptive(), noise, clamped, ..Totals::default() };
        let height = self.window().size[1];
        let next = self.current().render_rows(0, rows, &mut clock, watch, &mut totals)?;
        if next < height {
            self.go_over()?.render_rows(next, rows, &mut clock, watch, &mut totals)?;
        }
        self.finish_totals(&mut totals, &clock, started)?;
        Ok(totals)
    }

    /// Renders from a row on. Returns the row that comes next: none of the picture, unless a path there outlived the pass that was to
    /// follow all of it.
    fn render_rows(
        &self,
        first: u32,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        clock: &mut Clock,
        watch: &Watch,
        totals: &mut Totals,
    ) -> Result<u32, RenderError> {
        let [width, height] = self.window().size;
        let [tile_width, tile_height] = self.tile_size()?;
        let margin = self.settings.choice.margin(&self.scene);
        let mut tile: Option<Tile> = None;
        let all = f64::from(width) * f64::from(height);
        let mut pixels_done = f64::from(width) * f64::from(first);
        for first_row in (first..height).step_by(tile_height as usize) {
            let tile_rows = tile_height.min(height - first_row);
            let mut band = self.band(first_row, tile_rows);
            let before_band = totals.clone();
            for left in (0..width).step_by(tile_width as usize) {
                let size = [tile_width.min(width - left), tile_rows];
                let mut made = match &tile {
                    Some(made) if made.size == size.map(|side| side + margin) => made,
                    _ => tile.insert(self.tile(size.map(|side| side + margin))?),
                };
                let pixels = f64::from(size[0]) * f64::from(size[1]);
                let at = Window { origin: [left, first_row], size };
                let progress = |done| (watch.progress)((pixels_done + done * pixels) / all);
                let part = Watch { progress: &progress, ..*watch };
                let before = totals.clone();
                self.render_tile(made, at, clock, &part, totals)?;
                // Adaptive sampling takes as many as it needs.
                let samples = u64::from(self.scene.image.samples - watch.earlier.map_or(0, |earlier| earlier.samples));
                let rays =
                    self.scene.image.adaptive.is_none().then(|| samples * size.map(u64::from).iter().product::<u64>());
                if self.read_tally(made, totals, rays)? == Walks::Unfinished {
                    if self.is_whole() {
                        *totals = before_band;
                        return Ok(first_row);
                    }
                    *totals = before;
                    let again = tile.insert(self.tile(size.map(|side| side + margin))?);
                    self.render_tile(again, at, clock, &part, totals)?;
                    self.read_tally(again, totals, None)?;
                    made = again;
                }
                pixels_done += pixels;
                self.read_tile(made, (left, self.scene.image.samples), &mut band, totals.noise.as_mut())?;
                if let Some(clamped) = &mut totals.clamped {
                    self.read_clamped(made, clamped)?;
                }
            }
            if let Some(earlier) = watch.earlier {
                earlier.put_first(&mut band);
            }
            rows(band)?;
        }
        Ok(height)
    }

    /// The whole picture at once.
    pub fn picture(&self) -> Result<Rendering, RenderError> {
        let mut whole: Option<Band> = None;
        let mut append = |band: Band| {
            match &mut whole {
                Some(all) => all.append(band),
                None => whole = Some(band),
            }
            Ok(())
        };
        let totals = self.render(&mut append, &|_| {})?;
        let band = whole.unwrap_or_else(|| self.band(0, 0));
        Ok(Rendering { band, totals })
    }

    /// What adaptive sampling is to do, if it is asked for.
    fn adaptive(&self) -> Option<Adaptive> {
        let [width, height] = self.window().size.map(u64::from);
        let image = &self.scene.image;
        let new =
            |tolerance| Adaptive { pixels: width * height, samples: 0, capped: 0, most: image.samples, tolerance };
        image.adaptive.map(new)
    }

    /// The layers of the picture's first sample, on one tile: for pictures that are no larger.
    pub fn first_sample(&self) -> Result<Rendering, RenderError> {
        if let Some(fused) = self.fused.get() {
            return fused.first_sample();
        }
        let size = self.scene.image.size;
        let (tile, mut band) = (self.tile(size)?, self.band(0, size[1]));
        let (mut totals, mut clock) = (Totals::default(), Clock::new(self.gpu, false));
        let started = Instant::now();
        self.run_sample(&tile, Sample::first(size), &mut clock, &|_| {})?;
        if self.read_tally(&tile, &mut totals, None)? == Walks::Unfinished {
            return if self.is_whole() { self.go_over()?.first_sample() } else { self.first_sample() };
        }
        self.read_tile(&tile, (0, 1), &mut band, None)?;
        self.finish_totals(&mut totals, &clock, started)?;
        Ok(Rendering { band, totals })
    }

    /// Some black rows of the picture.
    fn band(&self, first_row: u32, rows: u32) -> Band {
        let width = self.window().size[0];
        let black = || vec![0.0; rows as usize * width as usize];
        let color = [black(), black(), black()];
        let alpha = self.scene.is_transparent().then(black);
        Band { first_row, rows, width, color, alpha, layers: Vec::new() }
    }

    fn render_tile(
        &self,
        tile: &Tile,
        part: Window,
        clock: &mut Clock,
        watch: &Watch,
        totals: &mut Totals,
    ) -> Result<(), RenderError> {
        let window = self.window();
        let origin = [0, 1].map(|k| window.origin[k] + part.origin[k]);
        if let Some(sums) = &mut totals.adaptive {
            return self.sample_adaptively(tile, origin, clock, watch.progress, sums);
        }
        let samples = self.scene.image.samples;
        let first = watch.earlier.map_or(0, |earlier| earlier.samples);
        if let Some(earlier) = watch.earlier {
            earlier.put(self.gpu, tile, part);
        }
        for number in first..samples {
            let sample = Sample { origin, image: self.scene.image.size, number, refines: None };
            let done = |part: f64| (watch.progress)((f64::from(number - first) + part) / f64::from(samples - first));
            self.run_sample(tile, sample, clock, &done)?;
            let preview = watch.preview.filter(|_| part.size == window.size && number + 1 < samples);
            if let Some(preview) = preview.filter(|preview| preview.is_due()) {
                let mut band = self.band(0, window.size[1]);
                self.read_tile(tile, (0, number + 1), &mut band, None)?;
                if let Some(earlier) = watch.earlier {
                    earlier.put_first(&mut band);
                }
                preview.look(&band, number + 1)?;
            }
        }
        Ok(())
    }

    /// What a tile has come to after so many samples, into a band whose column `left` is the tile's first.
    fn read_tile(
        &self,
        tile: &Tile,
        (left, samples): (u32, u32),
        band: &mut Band,
        noise: Option<&mut Noise>,
    ) -> Result<(), RenderError> {
        let moments = self.read_moments(tile)?;
        let errors = self.read_errors(tile, samples, moments.as_deref())?;
        let at = TilePlace { left, width: tile.size[0], margin: self.settings.choice.margin(&self.scene) };
        let weight = 1.0 / samples as f32;
        let planes = band.color.iter_mut().chain(&mut band.alpha);
        let channels = [Channel::Red, Channel::Green, Channel::Blue, Channel::Alpha];
        for (k, (plane, channel)) in planes.zip(channels).enumerate() {
            if let Some(moments) = &moments {
                at.put(plane, band.width, moments.iter().map(|moments| moments.color[k]));
            } else if let Some(texture) = tile.texture(&Role::Color(channel)) {
                let sums = read_texture(self.gpu, texture)?;
                at.put(plane, band.width, sums.iter().map(|bits| f32::from_bits(*bits) * weight));
            }
        }
        for &layer in &self.settings.choice.layers {
            let words = match (layer, &moments, tile.texture(&Role::Layer(layer))) {
                (Layer::Error, ..) => match &errors {
                    Some(errors) => errors.iter().map(|error| error.to_bits()).collect(),
                    None => continue,
                },
                (Layer::Samples, Some(moments), _) => moments.iter().map(|moments| moments.rays).collect(),
                (Layer::Samples, None, _) => vec![samples; tile.size.map(|n| n as usize).iter().product()],
                (Layer::Sums, None, _) => self.read_sums(tile)?,
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
    fn read_clamped(&self, tile: &Tile, sums: &mut Clamped) -> Result<(), RenderError> {
        let kept = |name| tile.texture(&Role::Kept(name));
        let (Some(samples), Some(light)) = (kept("clamped_samples"), kept("clamped_light")) else { return Ok(()) };
        sums.samples += read_texture(self.gpu, samples)?.into_iter().map(u64::from).sum::<u64>();
        sums.lost += floats(&read_texture(self.gpu, light)?).sum::<f64>();
        if let Some(moments) = self.read_moments(tile)? {
            let light = |moments: &Moments| f64::from(moments.color[..3].iter().sum::<f32>()) / 3.0;
            sums.left += moments.iter().map(|moments| light(moments) * f64::from(moments.rays)).sum::<f64>();
            return Ok(());
        }
        for channel in [Channel::Red, Channel::Green, Channel::Blue] {
            if let Some(texture) = tile.texture(&Role::Color(channel)) {
                sums.left += floats(&read_texture(self.gpu, texture)?).sum::<f64>() / 3.0;
            }
        }
        Ok(())
    }

    /// The sums of a tile's colours, in fours as the texels of a layer are.
    fn read_sums(&self, tile: &Tile) -> Result<Vec<u32>, RenderError> {
        let texels = tile.size.map(|n| n as usize).iter().product::<usize>();
        let mut words = vec![0; 4 * texels];
        for (k, channel) in [Channel::Red, Channel::Green, Channel::Blue].into_iter().enumerate() {
            if let Some(texture) = tile.texture(&Role::Color(channel)) {
                let sums = read_texture(self.gpu, texture)?;
                words.iter_mut().skip(k).step_by(4).zip(sums).for_each(|(word, sum)| *word = sum);
            }
        }
        Ok(words)
    }
}

fn floats(words: &[u32]) -> impl Iterator<Item = f64> {
    words.iter().map(|bits| f64::from(f32::from_bits(*bits)))
}
