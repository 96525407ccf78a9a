//! K, the segments of one fused pass, chosen by measuring.
//!
//! *Theory.* With more segments a pass, less time goes into loading and storing the state; with fewer, the places of ended rays are
//! filled up sooner. Which counts for more depends on the scene and the device.
//!
//! *Practice.* A part of the picture's middle is rendered with each of a few K before the picture starts, by the picture's own
//! program: K is only a number to it, and changes no bit of the picture.

use std::time::{Duration, Instant};

use super::clock::Clock;
use super::renderer::{Frame, Refines};
use super::{RenderError, Renderer, Totals, Window};
use crate::program::Schedule;

/// From which K is chosen.
const CHOICES: [u32; 4] = [8, 32, 128, 512];
/// Width and height of the part that is rendered.
const PART: u32 = 128;
/// Pictures of fewer rays are done sooner than it takes to choose.
const FEW: u64 = 1 << 17;
/// A K is left for another that takes this part of its time: less is noise.
const BETTER: f64 = 0.95;

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
        let size = [width, height].map(|side| side.min(PART));
        let origin = [corner[0] + (width - size[0]) / 2, corner[1] + (height - size[1]) / 2];
        let refines = choice.adapts(&self.scene).then_some(Refines::FIRST);
        let frame = Frame { origin, image: image.size, sample: 0, refines };
        let mut best: Option<(Duration, u32)> = None;
        for segments in CHOICES {
            self.set_segments(self.max_segments, segments)?;
            let time = self.part_time(size, frame)?;
            if best.is_none_or(|(least, _)| time < least.mul_f64(BETTER)) {
                best = Some((time, segments));
            }
            if segments >= self.max_segments {
                break;
            }
        }
        let chosen = best.map_or(self.settings.segments, |(_, segments)| segments);
        self.set_segments(self.max_segments, chosen)?;
        Ok(chosen)
    }

    /// The better of two runs: the first of all compiles.
    fn part_time(&self, size: [u32; 2], frame: Frame) -> Result<Duration, RenderError> {
        let tile = self.tile(size)?;
        let mut least = Duration::MAX;
        for _ in 0..2 {
            let (mut totals, mut clock) = (Totals::default(), Clock::new(self.gpu, false));
            let started = Instant::now();
            self.run_sample(&tile, frame, &mut clock, &|_| {})?;
            self.finish_totals(&mut totals, &clock, started)?;
            least = least.min(totals.advance());
        }
        Ok(least)
    }
}
