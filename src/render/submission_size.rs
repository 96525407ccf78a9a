//! Adapts the size of submissions to the device, and estimates the fraction of a sample that has ended. A submission should be long enough
//! that the device does not wait for the host, and short enough for any driver.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};
use std::time::Duration;

/// The number of ray steps of the first submission: a few tenths of a second on a CPU, and less than a millisecond on a fast GPU.
const FIRST: u64 = 1 << 26;
/// The limits of the number of ray steps.
const LIMITS: [u64; 2] = [1 << 20, 1 << 40];
/// The largest number for the first submission of a tile: its rays may take far longer than those of the tile before, which ended early.
const FIRST_OF_TILE: u64 = 1 << 34;
/// A submission that takes less time may grow, and one that takes more shrinks. Drivers abort a submission after two seconds or more.
const TIMES: [Duration; 2] = [Duration::from_millis(50), Duration::from_millis(400)];
/// The time that a changed size should take, in seconds.
const AIM: f64 = 0.1;
/// The largest factor between two sizes.
const FACTOR: f64 = 256.0;

/// The number of ray steps of one submission. It decides where submissions end, and nothing else.
#[derive(Debug)]
pub(super) struct SubmissionSize {
    steps: AtomicU64,
    is_known: AtomicBool,
}

impl Default for SubmissionSize {
    fn default() -> Self {
        Self { steps: AtomicU64::new(FIRST), is_known: AtomicBool::new(false) }
    }
}

impl SubmissionSize {
    pub(super) fn get(&self) -> u64 {
        self.steps.load(Relaxed)
    }

    /// Returns `true` if a submission of this tile has been timed.
    pub(super) fn is_known(&self) -> bool {
        self.is_known.load(Relaxed)
    }

    /// Forgets the times of another tile.
    pub(super) fn begin_tile(&self) {
        self.is_known.store(false, Relaxed);
        self.steps.store(self.get().min(FIRST_OF_TILE), Relaxed);
    }

    /// Takes into account that a submission of at most `work` ray steps took this time.
    pub(super) fn learn(&self, work: u64, took: Duration) {
        self.is_known.store(true, Relaxed);
        let size = self.get() as f64;
        let aimed = work as f64 * AIM / took.as_secs_f64().max(1e-6);
        let next = match took {
            // A short submission does not show that a long one is as fast, because most of its time may be overhead.
            _ if took < TIMES[0] => aimed.clamp(size, FACTOR * size),
            _ if took > TIMES[1] => aimed.clamp(size / FACTOR, size),
            _ => size,
        };
        self.steps.store((next as u64).clamp(LIMITS[0], LIMITS[1]), Relaxed);
    }
}

/// Returns the completed fraction of a sample, for `ended` of `all` units of weight and submissions of at most `each`.
///
/// The number of rays that remain active is unknown beforehand, so each doubling of the steps is assumed to have an equal cost. If no ray
/// ends early, the second half still takes as long as the first; if all rays do, the rest takes no time. Neither case misleads by more than
/// a small factor, unlike an estimate by equal steps.
pub(super) fn part(ended: u64, all: u64, each: u64) -> f64 {
    let [ended, all] = [ended.min(all), all].map(|weight| (weight as f64 / each.max(1) as f64).ln_1p());
    if all > 0.0 { ended / all } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_settle_where_submissions_take_tenths_of_a_second() {
        for steps_a_second in [1e6, 1e8, 1e12] {
            let size = SubmissionSize::default();
            let took = |work: u64| Duration::from_secs_f64(work as f64 / steps_a_second);
            for _ in 0..50 {
                size.learn(size.get(), took(size.get()));
            }
            let settled = size.get();
            let is_limit = LIMITS.contains(&settled);
            assert!(is_limit || (TIMES[0]..=TIMES[1]).contains(&took(settled)), "{steps_a_second}: {settled}");
            // A small submission does not show that a large one is short.
            size.learn(1, Duration::ZERO);
            assert_eq!(size.get(), settled);
        }
    }

    #[test]
    #[allow(clippy::float_cmp)] // ends of a sample are exact
    fn parts_of_a_sample_grow_to_the_whole() {
        for all in [1, 5, 1000] {
            let parts: Vec<f64> = (0..=all).map(|ended| part(ended, all, 1)).collect();
            assert!(parts.windows(2).all(|pair| pair[0] < pair[1]), "{parts:?}");
            assert_eq!([parts[0], parts[all as usize]], [0.0, 1.0]);
        }
        // The weight of one step may exceed the limit of a submission on a large tile.
        assert_eq!([part(7, 7, 0), part(0, 0, 1)], [1.0, 1.0]);
        assert!(part(1, 1023, 1) > 0.09, "the first of many may take as long as many that follow");
    }
}
