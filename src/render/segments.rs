//! K, the segments of one fused pass, chosen by measuring.
//!
//! *Theory.* With more segments a pass, less time goes into loading and storing the state; with fewer, the places of ended rays are
//! filled up sooner. Which counts for more depends on the scene and the device.
//!
//! *Practice.* The picture is rendered small with each of a few K before it starts, by its own program: K is only a number to it,
//! and changes no bit of the picture. A part of the picture in full would be no fair sample of its rays.

use std::time::{Duration, Instant};

use super::clock::Clock;
use super::sample::{Refines, Sample};
use super::{RenderError, Renderer, Totals, Window};
use crate::program::Schedule;

/// From which K is chosen.
const CHOICES: [u32; 3] = [8, 32, 128];
/// The longer side of the small picture.
const SMALL: u32 = 224;
/// Pictures of fewer rays gain less by a choice than it takes.
const FEW: u64 = 1 << 21;
/// Times that each K is tried.
const RUNS: u32 = 3;
/// A K that takes so many times the best one's time is not tried again.
const HOPELESS: f64 = 1.3;

impl Renderer<'_> {
    /// Chooses K, where there is a choice and time to make up for it. The K that it is then.
    pub fn choose_segments(&mut self) -> Result<u32, RenderError> {
        let image = &self.scene.image;
        let Window { origin: corner, size: [width, height] } = self.window();
        let rays = u64::from(width) * u64::from(height) * u64::from(image.samples);
        let choice = &self.settings.choice;
        if choice.schedule != Schedule::Fused || choice.rounds(&self.scene) > 1 || rays < FEW {
            return Ok(self.settings.segments);
        }
        let longer = width.max(height);
        let small = |side: u32| (u64::from(side) * u64::from(SMALL.min(longer)) / u64::from(longer)) as u32;
        let size = [width, height].map(|side| small(side).max(1));
        let refines = choice.adapts(&self.scene).then_some(Refines::FIRST);
        let image = image.size.map(|side| small(side).max(1));
        let sample = Sample { origin: corner.map(small), image, number: 0, refines };
        let useful = 1 + CHOICES.iter().filter(|segments| **segments < self.max_segments).count();
        let mut times: Vec<_> = CHOICES.into_iter().take(useful).map(|segments| (segments, Duration::MAX)).collect();
        // By turns, so that a slow moment is nobody's own. The first run of all compiles, and its times rule nothing out.
        for run in 0..RUNS {
            for (segments, least) in &mut times {
                self.set_segments(self.max_segments, *segments)?;
                *least = self.small_time(size, sample)?.min(*least);
            }
            let best = times.iter().map(|(_, time)| *time).min().unwrap_or_default();
            times.retain(|(_, time)| run == 0 || *time <= best.mul_f64(HOPELESS));
        }
        let chosen = times.into_iter().min_by_key(|(_, time)| *time).map_or(self.settings.segments, |(k, _)| k);
        self.set_segments(self.max_segments, chosen)?;
        Ok(chosen)
    }

    fn small_time(&self, size: [u32; 2], sample: Sample) -> Result<Duration, RenderError> {
        let tile = self.tile(size)?;
        let (mut totals, mut clock) = (Totals::default(), Clock::new(self.gpu, false));
        let started = Instant::now();
        self.run_sample(&tile, sample, &mut clock, &|_| {})?;
        self.finish_totals(&mut totals, &clock, started)?;
        Ok(totals.advance())
    }
}
