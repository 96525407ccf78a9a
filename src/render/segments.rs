//! K, the segments of one fused pass, chosen by measuring.
//!
//! *Theory.* With more segments a pass, less time goes into loading and storing the state; with fewer, the places of ended rays are
//! filled up sooner. Which counts for more depends on the scene and the device.
//!
//! *Practice.* The picture is rendered small with each of a few K before it starts: K is only a number to its program, and changes no bit
//! of the picture.

use std::time::Duration;

use super::{RenderError, Renderer};
use crate::program::{Features, Schedule};

/// From which K is chosen.
const CHOICES: [u32; 3] = [8, 32, 128];
/// Pictures of fewer rays gain less by a choice than it takes.
const FEW: u64 = 1 << 21;
/// Times that each K is tried.
const RUNS: u32 = 3;
/// A K that takes so many times the best one's time is not tried again.
const HOPELESS: f64 = 1.3;

impl Renderer<'_> {
    /// Chooses K, where there is a choice and time to make up for it. The K that it is then.
    pub fn choose_segments(&mut self) -> Result<u32, RenderError> {
        let [width, height] = self.window().size;
        let rays = u64::from(width) * u64::from(height) * u64::from(self.prepared.scene.image.samples);
        let Features { schedule, rounds, .. } = self.prepared.program.features;
        if schedule != Schedule::Fused || rounds > 1 || rays < FEW {
            return Ok(self.prepared.settings.segments);
        }
        let useful = 1 + CHOICES.iter().filter(|segments| **segments < self.prepared.max_segments).count();
        let mut times: Vec<_> = CHOICES.into_iter().take(useful).map(|segments| (segments, Duration::MAX)).collect();
        let stage = self.prepared.gpu.progress.measured("choosing the segments per pass", f64::from(RUNS));
        // By turns, so that a slow moment is nobody's own. The first run of all compiles, and its times rule nothing out.
        for run in 0..RUNS {
            for (segments, least) in &mut times {
                self.prepared.set_segments(self.prepared.max_segments, *segments)?;
                *least = self.small_time()?.min(*least);
            }
            let best = times.iter().map(|(_, time)| *time).min().unwrap_or_default();
            times.retain(|(_, time)| run == 0 || *time <= best.mul_f64(HOPELESS));
            stage.advance(1.0);
        }
        let chosen =
            times.into_iter().min_by_key(|(_, time)| *time).map_or(self.prepared.settings.segments, |(k, _)| k);
        self.prepared.set_segments(self.prepared.max_segments, chosen)?;
        Ok(chosen)
    }
}
