//! Renders an image at a small size by its own program, to predict the time of the whole image. A part of the image at full size would not
//! be a representative sample of its rays.

use std::time::{Duration, Instant};

use super::clock::Clock;
use super::sample::{Refines, Sample};
use super::{RenderError, Renderer, Totals, Window};

/// The longer side of the small image, in pixels.
const SMALL: u32 = 224;

impl Renderer<'_> {
    /// Returns the device's time for one sample of the small image.
    pub(super) fn small_time(&self) -> Result<Duration, RenderError> {
        let (tile, sample) = (self.prepared.tile(self.small_size())?, self.small_sample());
        let (mut totals, mut clock) = (Totals::default(), Clock::new(self.prepared.gpu, false));
        let started = Instant::now();
        self.prepared.run_sample(&tile, sample, &mut clock, &|_| {})?;
        self.prepared.finish_totals(&mut totals, &clock, started)?;
        Ok(totals.advance())
    }

    /// Estimates the time for all samples of the image; for an adaptive image, the samples that every pixel takes.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or has too little memory.
    pub fn expected_time(&mut self) -> Result<Duration, RenderError> {
        let size = self.small_size();
        let mut taken = Duration::ZERO;
        let _stage = self.prepared.gpu.progress.stage("estimating the time");
        // The first run includes compilation.
        for _ in 0..2 {
            let tile = self.prepared.tile(size)?;
            let started = Instant::now();
            self.prepared.run_sample(&tile, self.small_sample(), &mut Clock::new(self.prepared.gpu, false), &|_| {})?;
            let _ = self.prepared.read_tally(&tile, &mut Totals::default(), None)?;
            taken = started.elapsed();
        }
        let pixels = |size: [u32; 2]| size.map(f64::from).into_iter().product::<f64>();
        let many = pixels(self.window().size) / pixels(size) * f64::from(self.prepared.scene.image.samples);
        Ok(Duration::try_from_secs_f64(taken.as_secs_f64() * many).unwrap_or(Duration::MAX))
    }

    fn small_size(&self) -> [u32; 2] {
        self.window().size.map(|side| self.small(side).max(1))
    }

    fn small_sample(&self) -> Sample {
        let Window { origin, .. } = self.window();
        let refines = self.prepared.program.features.adapts.then_some(Refines::FIRST);
        let image = self.prepared.scene.image.size.map(|side| self.small(side).max(1));
        Sample {
            origin: origin.map(|side| self.small(side)),
            image,
            number: 0,
            is_grid: false,
            ends_only: false,
            refines,
        }
    }

    /// Returns a length in the small image, in pixels.
    fn small(&self, side: u32) -> u32 {
        let [width, height] = self.window().size;
        let longer = u64::from(width.max(height));
        (u64::from(side) * u64::from(SMALL).min(longer) / longer) as u32
    }
}
