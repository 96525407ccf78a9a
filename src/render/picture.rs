//! Renders an image: tiles, samples, and rows that are passed on when they are complete.

use std::time::Instant;

use super::band::{Band, Bands, Rendering};
use super::clock::Clock;
use super::sample::Sample;
use super::tile::TileEnd;
use super::watch::{EarlierSamples, Preview, Round, Watch};
use super::{Adaptive, Clamped, Noise, RenderError, Renderer, Totals, Window};
use crate::gpu::Tile;
use crate::program::Layer;
use crate::progress::Stage;

impl Renderer<'_> {
    /// Renders the image tile by tile, and passes bands of complete rows to `rows`, from top to bottom.
    ///
    /// The host stores one band at a time, so that images may be larger than its memory.
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::Gpu`] if the device fails, or if `memory` of the settings is too small for any tile. Returns an error of
    /// `rows` unchanged and stops; [`RenderError::Output`] wraps errors of other types.
    ///
    /// # Examples
    ///
    /// ```no_run
    /// use bentray::output::{FileSettings, open};
    /// use bentray::{gpu::Gpu, render::{RenderError, Renderer, RenderSettings}, scene::Scene};
    ///
    /// let scene = Scene::load("scenes/black_hole.toml".as_ref(), &["image.size=[16000, 9000]".parse()?])?;
    /// let gpu = Gpu::open(None)?;
    /// let mut writer = open("large.png".as_ref(), &FileSettings::new(scene.image.size))?;
    /// let failed = |error| RenderError::Output(Box::new(error));
    /// Renderer::new(&gpu, &scene, RenderSettings::default())?.render_bands(&mut |band| writer.write_band(&band).map_err(failed))?;
    /// writer.finish()?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn render_bands(
        &mut self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
    ) -> Result<Totals, RenderError> {
        self.render_watched(rows, &Watch::default())
    }

    /// Renders the image like [`render_bands`](Self::render_bands), with earlier samples and a preview.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`render_bands`](Self::render_bands) and of the preview.
    pub fn render_watched(
        &mut self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        watch: &Watch,
    ) -> Result<Totals, RenderError> {
        let started = Instant::now();
        let mut clock = Clock::new(self.prepared.gpu, self.prepared.settings.apart);
        let noise = self.prepared.scene.rays.path_tracing.map(|_| Noise::default());
        let clamped = self.prepared.scene.output.clamp.map(|_| Clamped::default());
        let mut totals = Totals { adaptive: self.adaptive(), noise, clamped, ..Totals::default() };
        let (first, samples) = (watch.earlier.map_or(0, |earlier| earlier.samples), self.prepared.scene.image.samples);
        let stage = self.prepared.gpu.progress.part("rendering", f64::from(samples.saturating_sub(first)), 1.0);
        let kept = self.prepared.settings.options.layers.clone();
        let wanted = watch.layers.unwrap_or(&kept);
        let own = match watch.preview {
            Some(preview) => self.preview((preview, &stage), watch, wanted, &mut clock, &mut totals)?,
            None => None,
        };
        let last = Round::new(own.as_ref().or(watch.earlier), samples, true, wanted);
        self.render_round(rows, &mut clock, &last.told(&stage, first), &mut totals)?;
        self.prepared.finish_totals(&mut totals, &clock, started)?;
        Ok(totals)
    }

    /// Renders some samples of the whole image, shows them, and repeats this until too few samples remain for another preview. Returns the
    /// samples so far, if there was a preview.
    fn preview(
        &mut self,
        (preview, stage): (&dyn Preview, &Stage),
        watch: &Watch,
        wanted: &[Layer],
        clock: &mut Clock,
        totals: &mut Totals,
    ) -> Result<Option<EarlierSamples>, RenderError> {
        let first = watch.earlier.map_or(0, |earlier| earlier.samples);
        let mut own: Option<EarlierSamples> = None;
        let mut samples = 1;
        loop {
            let before = own.as_ref().or(watch.earlier);
            let until = before.map_or(0, |earlier| earlier.samples).saturating_add(samples);
            // Adaptive pixels take all their samples at once, so a preview has none to add to later.
            if until >= self.prepared.scene.image.samples || totals.adaptive.is_some() {
                return Ok(own);
            }
            let begun = Instant::now();
            let mut all = Bands::default();
            let round = Round::new(before, until, false, wanted).told(stage, first);
            self.render_round(&mut all.sink(), clock, &round, totals)?;
            let band = all.whole.unwrap_or_else(|| self.band(0, 0));
            preview.look(&band, until)?;
            own = Some(EarlierSamples { samples: until, band });
            let each = begun.elapsed().as_secs_f64() / f64::from(samples);
            samples = ((preview.every().as_secs_f64() / each) as u32).clamp(1, 2 * samples);
        }
    }

    /// Renders a round, band by band.
    fn render_round(
        &mut self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        clock: &mut Clock,
        round: &Round,
        totals: &mut Totals,
    ) -> Result<(), RenderError> {
        let mut tile = self.tile.take();
        let mut first_row = 0;
        while first_row < self.window().size[1] {
            let before = totals.clone();
            let Some(mut band) = self.render_band(first_row, &mut tile, clock, round, totals)? else {
                (*totals, tile) = (before, None);
                continue;
            };
            first_row += band.rows;
            if let Some(earlier) = round.earlier {
                earlier.put_first(&mut band);
            }
            rows(band)?;
        }
        self.tile = tile;
        Ok(())
    }

    /// Renders the rows of one tile's height, tile by tile. Returns `None` if they must be rendered again with more passes.
    fn render_band(
        &mut self,
        first_row: u32,
        tile: &mut Option<Tile>,
        clock: &mut Clock,
        round: &Round,
        totals: &mut Totals,
    ) -> Result<Option<Band>, RenderError> {
        let [width, height] = self.window().size;
        let [tile_width, tile_height] = self.tile_size()?;
        let margin = self.prepared.program.features.margin();
        let tile_rows = tile_height.min(height - first_row);
        let mut band = self.band(first_row, tile_rows);
        for left in (0..width).step_by(tile_width as usize) {
            let size = [tile_width.min(width - left), tile_rows];
            let made = self.prepared.tile_after(tile.take(), size.map(|side| side + margin.total()))?;
            let made = &*tile.insert(made);
            let [all, done, own] =
                [[width, height], [width, first_row], size].map(|[x, y]| f64::from(x) * f64::from(y));
            let done = done + f64::from(left) * f64::from(tile_rows);
            let progress = |part| round.tell((done + part * own) / all);
            let at = Window { origin: [left, first_row], size };
            self.render_tile(made, at, clock, (round, &progress), totals)?;
            // The number of adaptive samples is unknown.
            let rays = self.prepared.scene.image.adaptive.is_none().then(|| self.rays_of(size, round));
            if self.prepared.read_tally(made, totals, rays)? == TileEnd::Again {
                return Ok(None);
            }
            let noise = totals.noise.as_mut().filter(|_| round.is_last);
            let values = self.read_values(made)?;
            values.put(left, round, &mut band, noise);
            if let Some(radiation) = &self.prepared.scene.radiation {
                values.add_radiation(round, radiation.frequencies.len(), &mut totals.radiation);
            }
            if let Some(clamped) = &mut totals.clamped {
                values.add_clamped(round, clamped);
            }
        }
        Ok(Some(band))
    }

    /// Returns the number of rays of a tile in a round of samples.
    fn rays_of(&self, size: [u32; 2], round: &Round) -> u64 {
        let features = &self.prepared.program.features;
        let count = |margin: u32| size.map(|side| u64::from(side + margin)).iter().product::<u64>();
        let all = count(features.margin().total());
        let samples = (round.begins()..round.until).map(|number| {
            let separate = if self.follows_grid(round, number) { all } else { 0 };
            separate + if features.samples_grid(number) { all } else { count(0) }
        });
        samples.sum()
    }

    /// Returns `true` if the rays of a separate grid are followed before a sample: the first, or all if stars may be elsewhere at other
    /// moments.
    fn follows_grid(&self, round: &Round, number: u32) -> bool {
        let features = &self.prepared.program.features;
        let changes = features.has_stars && self.prepared.moments.len() > 1;
        features.has_grid && !features.samples_grid(number) && (changes || number == round.begins())
    }

    /// Renders the whole image into memory. [`Renderer::new`] has an example; [`render_bands`](Self::render_bands) needs less memory.
    ///
    /// # Errors
    ///
    /// Returns [`RenderError::Gpu`] if the device fails, or if `memory` of the settings is too small for any tile.
    pub fn render(&mut self) -> Result<Rendering, RenderError> {
        let mut all = Bands::default();
        let totals = self.render_bands(&mut all.sink())?;
        let band = all.whole.unwrap_or_else(|| self.band(0, 0));
        Ok(Rendering { band, totals })
    }

    /// Returns empty totals of adaptive sampling, if it is enabled.
    fn adaptive(&self) -> Option<Adaptive> {
        let [width, height] = self.window().size.map(u64::from);
        let image = &self.prepared.scene.image;
        let new =
            |tolerance| Adaptive { pixels: width * height, samples: 0, capped: 0, most: image.samples, tolerance };
        image.adaptive.map(new)
    }

    /// Returns the layers of single rays in the image's first sample on one tile, for images that fit into one. Returns `None` if a path
    /// outlives the pass that should follow all of it.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or has too little memory.
    pub fn first_sample(&mut self) -> Result<Option<Rendering>, RenderError> {
        let size = self.prepared.scene.image.size;
        let margin = self.prepared.program.features.margin();
        let started = Instant::now();
        let rays = self.prepared.scene.image.adaptive.is_none().then(|| size.map(u64::from).into_iter().product());
        loop {
            let (mut totals, mut clock) = (Totals::default(), Clock::new(self.prepared.gpu, false));
            let tile = self.prepared.tile(size.map(|side| side + margin.total()))?;
            let sample = Sample { ends_only: true, ..Sample::first(size).before(margin.before) };
            self.prepared.run_sample(&tile, sample, &mut clock, &|_| {})?;
            let unfinished = self.prepared.add_tally(&tile, &mut totals, rays)?;
            if unfinished && self.prepared.is_whole() {
                return Ok(None);
            }
            if unfinished && self.prepared.make_room()? {
                continue;
            }
            let mut band = self.band(0, size[1]);
            let wanted = &self.prepared.settings.options.layers;
            self.read_values(&tile)?.put(0, &Round::new(None, 1, true, wanted), &mut band, None);
            self.prepared.finish_totals(&mut totals, &clock, started)?;
            return Ok(Some(Rendering { band, totals }));
        }
    }

    /// Returns black rows of the image.
    pub(super) fn band(&self, first_row: u32, rows: u32) -> Band {
        let width = self.window().size[0];
        let black = || vec![0.0; rows as usize * width as usize];
        let color = [black(), black(), black()];
        let alpha = self.prepared.scene.is_transparent().then(black);
        Band { first_row, rows, width, color, alpha, layers: Vec::new() }
    }

    fn render_tile(
        &self,
        tile: &Tile,
        part: Window,
        clock: &mut Clock,
        (round, progress): (&Round, &dyn Fn(f64)),
        totals: &mut Totals,
    ) -> Result<(), RenderError> {
        let window = self.window();
        // Positions to the left of the image and above it wrap around, as in the passes.
        let before = self.prepared.program.features.margin().before;
        let origin = [0, 1].map(|k| (window.origin[k] + part.origin[k]).wrapping_sub(before));
        if let Some(sums) = &mut totals.adaptive {
            return self.sample_adaptively(tile, origin, clock, progress, sums);
        }
        if let Some(map) = &self.ends {
            return self.shade_tile(tile, Window { origin, size: part.size }, clock, map);
        }
        let first = round.begins();
        if let Some(earlier) = round.earlier {
            earlier.put(self.prepared.gpu, &self.prepared.program, tile, part, before)?;
        }
        let image = self.prepared.scene.image.size;
        let samples = (first..round.until).flat_map(|number| {
            let sample = Sample { origin, image, number, is_grid: false, ends_only: false, refines: None };
            self.follows_grid(round, number).then(|| sample.grid()).into_iter().chain([sample])
        });
        self.prepared.run_samples(tile, samples.collect::<Vec<_>>().into_iter(), clock, progress)?;
        Ok(())
    }
}
