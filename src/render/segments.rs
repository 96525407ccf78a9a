//! Chooses K, the number of segments of one fused pass, by measurement.
//!
//! *Theory.* With more segments per pass, less time goes into loading and storing the state; with fewer, active rays are compacted sooner.
//! The best number depends on the scene and the device.
//!
//! *Practice.* Before an image is rendered, it is rendered at a small size with a few values of K: K is only a number in its program, and
//! changes no bit of the image.

use std::time::Duration;

use super::{RenderError, Renderer};
use crate::program::{Features, Schedule};

/// The candidates for K.
const CHOICES: [u32; 3] = [8, 32, 128];
/// The number of rays below which the choice costs more than it gains.
const FEW: u64 = 1 << 21;
/// The number of trials of each K.
const RUNS: u32 = 3;
/// The ratio to the best time above which a K is not tried again.
const HOPELESS: f64 = 1.3;

impl Renderer<'_> {
    /// Chooses K if there is a choice and the render is long enough to benefit. Returns the K in use.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or has too little memory.
    pub fn choose_segments(&mut self) -> Result<u32, RenderError> {
        let [width, height] = self.window().size;
        let rays = u64::from(width) * u64::from(height) * u64::from(self.prepared.scene.image.samples);
        let Features { schedule, rounds, .. } = self.prepared.program.features;
        if schedule != Schedule::Fused || rounds > 1 || rays < FEW {
            return Ok(self.prepared.settings.segments);
        }
        let useful = 1 + CHOICES.iter().filter(|segments| **segments < self.prepared.max_segments).count();
        let mut times: Vec<_> = CHOICES.into_iter().take(useful).map(|segments| (segments, Duration::MAX)).collect();
        let stage = self.prepared.gpu.progress.measured("choosing the number of segments per pass", f64::from(RUNS));
        // Alternate between candidates, so that a slow moment affects all. The first run includes compilation, so its times exclude none.
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
