//! Rendering a picture: tiles, samples, and rows given out as they are finished.

use std::time::Instant;

use super::clock::Clock;
use super::noise::luminance;
use super::readback::read_texture;
use super::renderer::Walks;
use super::sample::Sample;
use super::{Adaptive, Noise, RenderError, Renderer, Totals, Window};
use crate::gpu::Tile;
use crate::program::{Channel, Layer, Role};

/// Values of a layer, row by row.
#[derive(Debug, Clone, PartialEq)]
pub enum Plane {
    /// One number a pixel.
    Scalar(Vec<f32>),
    /// Three numbers a pixel, by component.
    Vector([Vec<f32>; 3]),
    /// One whole number a pixel.
    Id(Vec<u32>),
}

/// Some full rows of the window that is rendered.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The first row, from the window's top.
    pub first_row: u32,
    /// How many.
    pub rows: u32,
    /// The window's width.
    pub width: u32,
    /// Linear red, green and blue, the mean of the samples.
    pub color: [Vec<f32>; 3],
    /// The share of the samples that show something, by which the colours are multiplied already; none where all do.
    pub alpha: Option<Vec<f32>>,
    /// The layers that the settings ask for, in their order.
    pub layers: Vec<(Layer, Plane)>,
}

/// A whole picture in memory, for tests and comparisons.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// All its rows in one band.
    pub band: Band,
    /// What rendering it took.
    pub totals: Totals,
}

impl Renderer<'_> {
    /// Renders the picture tile by tile; `rows` is given bands of full rows from top to bottom, `progress` the fraction that
    /// is done.
    pub fn render(
        &self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        progress: &dyn Fn(f64),
    ) -> Result<Totals, RenderError> {
        let started = Instant::now();
        let mut clock = Clock::new(self.gpu, self.settings.apart);
        let noise = self.scene.rays.paths.map(|_| Noise::default());
        let mut totals = Totals { adaptive: self.adaptive(), noise, ..Totals::default() };
        let height = self.window().size[1];
        let next = self.current().render_rows(0, rows, &mut clock, progress, &mut totals)?;
        if next < height {
            self.go_over()?.render_rows(next, rows, &mut clock, progress, &mut totals)?;
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
        progress: &dyn Fn(f64),
        totals: &mut Totals,
    ) -> Result<u32, RenderError> {
        let Window { origin, size: [width, height] } = self.window();
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
                let corner = [origin[0] + left, origin[1] + first_row];
                let progress = |done| progress((pixels_done + done * pixels) / all);
                let before = totals.clone();
                self.render_tile(made, corner, clock, &progress, totals)?;
                // Adaptive sampling takes as many as it needs.
                let samples = u64::from(self.scene.image.samples);
                let rays =
                    self.scene.image.adaptive.is_none().then(|| samples * size.map(u64::from).iter().product::<u64>());
                if self.read_tally(made, totals, rays)? == Walks::Unfinished {
                    if self.is_whole() {
                        *totals = before_band;
                        return Ok(first_row);
                    }
                    *totals = before;
                    let again = tile.insert(self.tile(size.map(|side| side + margin))?);
                    self.render_tile(again, corner, clock, &progress, totals)?;
                    self.read_tally(again, totals, None)?;
                    made = again;
                }
                pixels_done += pixels;
                self.read_tile(made, left, &mut band, totals.noise.as_mut())?;
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
        self.read_tile(&tile, 0, &mut band, None)?;
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
        origin: [u32; 2],
        clock: &mut Clock,
        progress: &dyn Fn(f64),
        totals: &mut Totals,
    ) -> Result<(), RenderError> {
        if let Some(sums) = &mut totals.adaptive {
            return self.sample_adaptively(tile, origin, clock, progress, sums);
        }
        let samples = self.scene.image.samples;
        for number in 0..samples {
            let sample = Sample { origin, image: self.scene.image.size, number, refines: None };
            let part = |done: f64| progress((f64::from(number) + done) / f64::from(samples));
            self.run_sample(tile, sample, clock, &part)?;
        }
        Ok(())
    }

    fn read_tile(&self, tile: &Tile, left: u32, band: &mut Band, noise: Option<&mut Noise>) -> Result<(), RenderError> {
        let moments = self.read_moments(tile)?;
        let errors = self.read_errors(tile, moments.as_deref())?;
        let at = TilePlace { left, width: tile.size[0], margin: self.settings.choice.margin(&self.scene) };
        let weight = 1.0 / self.scene.image.samples as f32;
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
                (Layer::Samples, None, _) => {
                    vec![self.scene.image.samples; tile.size.map(|n| n as usize).iter().product()]
                }
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
}

/// Where in the rows of a band a tile's values go.
struct TilePlace {
    left: u32,
    /// The tile's width, with its margin.
    width: u32,
    margin: u32,
}

impl TilePlace {
    /// A tile's values without its margin, row by row, into full rows of the picture.
    fn put<T: Copy>(&self, rows: &mut [T], width: u32, values: impl Iterator<Item = T>) {
        for (i, value) in values.enumerate() {
            let (row, column) = (i / self.width as usize, i % self.width as usize);
            let own = column < (self.width - self.margin) as usize;
            if let Some(place) = rows.get_mut(row * width as usize + self.left as usize + column).filter(|_| own) {
                *place = value;
            }
        }
    }

    fn put_layer(&self, layer: Layer, band: &mut Band, words: &[u32]) {
        let (width, pixels) = (band.width, band.width as usize * band.rows as usize);
        let at = if let Some(at) = band.layers.iter().position(|(l, _)| *l == layer) {
            at
        } else {
            band.layers.push((layer, empty_plane(layer, pixels)));
            band.layers.len() - 1
        };
        let floats = |step: usize, k: usize| words.iter().skip(k).step_by(step).map(|bits| f32::from_bits(*bits));
        match &mut band.layers[at].1 {
            Plane::Scalar(values) => self.put(values, width, floats(1, 0)),
            Plane::Id(values) => self.put(values, width, words.iter().copied()),
            Plane::Vector(values) => {
                for (k, values) in values.iter_mut().enumerate() {
                    self.put(values, width, floats(4, k));
                }
            }
        }
    }
}

fn empty_plane(layer: Layer, pixels: usize) -> Plane {
    match layer {
        Layer::Depth | Layer::Error => Plane::Scalar(vec![0.0; pixels]),
        Layer::Position | Layer::Normal | Layer::Way => {
            Plane::Vector([vec![0.0; pixels], vec![0.0; pixels], vec![0.0; pixels]])
        }
        Layer::Object | Layer::Status | Layer::Steps | Layer::Samples => Plane::Id(vec![0; pixels]),
    }
}

impl Band {
    /// The plane of a layer, if the band has one.
    #[must_use]
    pub fn layer(&self, layer: Layer) -> Option<&Plane> {
        self.layers.iter().find_map(|(l, plane)| (*l == layer).then_some(plane))
    }

    fn append(&mut self, below: Self) {
        self.rows += below.rows;
        let planes = self.color.iter_mut().chain(&mut self.alpha);
        for (channel, more) in planes.zip(below.color.into_iter().chain(below.alpha)) {
            channel.extend(more);
        }
        for ((_, plane), (_, more)) in self.layers.iter_mut().zip(below.layers) {
            match (plane, more) {
                (Plane::Scalar(values), Plane::Scalar(more)) => values.extend(more),
                (Plane::Id(values), Plane::Id(more)) => values.extend(more),
                (Plane::Vector(values), Plane::Vector(more)) => {
                    values.iter_mut().zip(more).for_each(|(values, more)| values.extend(more));
                }
                _ => {}
            }
        }
    }
}
