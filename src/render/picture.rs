//! Rendering a picture: tiles, samples, and rows given out as they are finished.

use std::time::Instant;

use super::band::{Band, Bands, Rendering};
use super::clock::Clock;
use super::renderer::Walks;
use super::sample::Sample;
use super::watch::{Earlier, Preview, Round, Watch};
use super::{Adaptive, Clamped, Noise, RenderError, Renderer, Totals, Window};
use crate::gpu::Tile;
use crate::progress::Stage;

impl Renderer<'_> {
    /// Renders the picture tile by tile; `rows` is given bands of full rows from top to bottom.
    pub fn render(&self, rows: &mut dyn FnMut(Band) -> Result<(), RenderError>) -> Result<Totals, RenderError> {
        self.render_watched(rows, &Watch::default())
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
        let (first, samples) = (watch.earlier.map_or(0, |earlier| earlier.samples), self.scene.image.samples);
        let stage = self.gpu.progress.part("rendering", f64::from(samples.saturating_sub(first)), 1.0);
        let own = match watch.preview {
            Some(preview) => self.preview((preview, &stage), watch, &mut clock, &mut totals)?,
            None => None,
        };
        let last = Round::new(own.as_ref().or(watch.earlier), samples, true);
        self.render_round(rows, &mut clock, &last.told(&stage, first), &mut totals)?;
        self.finish_totals(&mut totals, &clock, started)?;
        Ok(totals)
    }

    /// Renders some samples of the whole picture, shows it, and goes on so until too few are left for another look. What comes back is
    /// what there is then, if there was any look.
    fn preview(
        &self,
        (preview, stage): (&dyn Preview, &Stage),
        watch: &Watch,
        clock: &mut Clock,
        totals: &mut Totals,
    ) -> Result<Option<Earlier>, RenderError> {
        let first = watch.earlier.map_or(0, |earlier| earlier.samples);
        let mut own: Option<Earlier> = None;
        let mut samples = 1;
        loop {
            let before = own.as_ref().or(watch.earlier);
            let until = before.map_or(0, |earlier| earlier.samples).saturating_add(samples);
            // Adaptive pixels take as many as they need, of which none are left for later.
            if until >= self.scene.image.samples || totals.adaptive.is_some() {
                return Ok(own);
            }
            let begun = Instant::now();
            let mut all = Bands::default();
            let round = Round::new(before, until, false).told(stage, first);
            self.render_round(&mut all.sink(), clock, &round, totals)?;
            let band = all.whole.unwrap_or_else(|| self.band(0, 0));
            preview.look(&band, until)?;
            own = Some(Earlier { samples: until, band });
            let each = begun.elapsed().as_secs_f64() / f64::from(samples);
            samples = ((preview.every().as_secs_f64() / each) as u32).clamp(1, 2 * samples);
        }
    }

    /// Renders a round, by another schedule from where it has to be.
    fn render_round(
        &self,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        clock: &mut Clock,
        round: &Round,
        totals: &mut Totals,
    ) -> Result<(), RenderError> {
        let next = self.current().render_rows(0, rows, clock, round, totals)?;
        if next < self.window().size[1] {
            self.go_over()?.render_rows(next, rows, clock, round, totals)?;
        }
        Ok(())
    }

    /// Renders from a row on. Returns the row that comes next: none of the picture, unless a path there outlived the pass that was to
    /// follow all of it.
    fn render_rows(
        &self,
        first: u32,
        rows: &mut dyn FnMut(Band) -> Result<(), RenderError>,
        clock: &mut Clock,
        round: &Round,
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
                let progress = |done| round.tell((pixels_done + done * pixels) / all);
                let before = totals.clone();
                self.render_tile(made, at, clock, (round, &progress), totals)?;
                // Adaptive sampling takes as many as it needs.
                let rays = self.scene.image.adaptive.is_none().then(|| self.rays_of(size, round));
                while self.read_tally(made, totals, rays)? == Walks::Unfinished {
                    if self.is_whole() {
                        *totals = before_band;
                        return Ok(first_row);
                    }
                    *totals = before.clone();
                    made = tile.insert(self.tile(size.map(|side| side + margin))?);
                    self.render_tile(made, at, clock, (round, &progress), totals)?;
                }
                pixels_done += pixels;
                let noise = totals.noise.as_mut().filter(|_| round.is_last);
                self.read_tile(made, left, round, &mut band, noise)?;
                if let Some(clamped) = &mut totals.clamped {
                    self.read_clamped(made, round, clamped)?;
                }
            }
            if let Some(earlier) = round.earlier {
                earlier.put_first(&mut band);
            }
            rows(band)?;
        }
        Ok(height)
    }

    /// Rays of a tile in a round of samples.
    fn rays_of(&self, size: [u32; 2], round: &Round) -> u64 {
        let count = |margin: u32| size.map(|side| u64::from(side + margin)).iter().product::<u64>();
        let corners = if self.settings.choice.keeps_footprints(&self.scene) { count(1) } else { 0 };
        u64::from(round.until - round.begins()) * count(0) + corners
    }

    /// The whole picture at once.
    pub fn picture(&self) -> Result<Rendering, RenderError> {
        let mut all = Bands::default();
        let totals = self.render(&mut all.sink())?;
        let band = all.whole.unwrap_or_else(|| self.band(0, 0));
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

    /// The layers of the picture's first sample, on one tile: for pictures that are no larger. None where a path outlives the pass
    /// that was to follow all of it.
    pub fn first_sample(&self) -> Result<Option<Rendering>, RenderError> {
        let size = self.scene.image.size;
        let margin = self.settings.choice.margin(&self.scene);
        let (mut totals, mut clock) = (Totals::default(), Clock::new(self.gpu, false));
        let started = Instant::now();
        loop {
            let tile = self.tile(size.map(|side| side + margin))?;
            self.run_sample(&tile, Sample::first(size), &mut clock, &|_| {})?;
            let rays = self.scene.image.adaptive.is_none().then(|| size.map(u64::from).into_iter().product());
            if self.read_tally(&tile, &mut totals, rays)? == Walks::Ended {
                let mut band = self.band(0, size[1]);
                self.read_tile(&tile, 0, &Round::new(None, 1, true), &mut band, None)?;
                self.finish_totals(&mut totals, &clock, started)?;
                return Ok(Some(Rendering { band, totals }));
            }
            if self.is_whole() {
                return Ok(None);
            }
        }
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
        (round, progress): (&Round, &dyn Fn(f64)),
        totals: &mut Totals,
    ) -> Result<(), RenderError> {
        let window = self.window();
        let origin = [0, 1].map(|k| window.origin[k] + part.origin[k]);
        if let Some(sums) = &mut totals.adaptive {
            return self.sample_adaptively(tile, origin, clock, progress, sums);
        }
        let first = round.begins();
        if self.settings.choice.keeps_footprints(&self.scene) {
            self.run_sample(tile, Sample::corners(origin, self.scene.image.size), clock, &|_| {})?;
        }
        if let Some(earlier) = round.earlier {
            earlier.put(self.gpu, tile, part);
        }
        for number in first..round.until {
            let sample = Sample { origin, image: self.scene.image.size, number, refines: None };
            let done = |part: f64| progress((f64::from(number - first) + part) / f64::from(round.until - first));
            self.run_sample(tile, sample, clock, &done)?;
        }
        Ok(())
    }
}
