//! Times of repeats.

use std::time::Duration;

use crate::render::{RenderError, Totals};

/// What some runs of the same took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Times {
    /// The median, seconds.
    pub median: f64,
    /// The longest over the shortest.
    pub spread: f64,
}

impl Times {
    /// Of `repeats` runs, after one that compiles.
    pub fn of(repeats: usize, mut run: impl FnMut() -> Result<Duration, RenderError>) -> Result<Self, RenderError> {
        let [times] = Self::by_turns(repeats, [&mut run])?;
        Ok(times)
    }

    /// Of some things to be compared, each run once in every repeat, so that what disturbs one disturbs all.
    pub fn by_turns<const N: usize>(
        repeats: usize,
        mut runs: [&mut dyn FnMut() -> Result<Duration, RenderError>; N],
    ) -> Result<[Self; N], RenderError> {
        let mut times = Self::all_by_turns(repeats, &mut runs)?.into_iter();
        Ok(std::array::from_fn(|_| times.next().unwrap_or(Self { median: f64::NAN, spread: f64::NAN })))
    }

    /// The same of any number of things.
    pub fn all_by_turns(
        repeats: usize,
        runs: &mut [impl FnMut() -> Result<Duration, RenderError>],
    ) -> Result<Vec<Self>, RenderError> {
        let mut seconds = vec![Vec::new(); runs.len()];
        for repeat in 0..=repeats.max(1) {
            for (run, seconds) in runs.iter_mut().zip(&mut seconds) {
                let time = run()?;
                if repeat > 0 {
                    seconds.push(time.as_secs_f64());
                }
            }
        }
        Ok(seconds.into_iter().map(Self::from).collect())
    }
}

impl From<Vec<f64>> for Times {
    fn from(mut seconds: Vec<f64>) -> Self {
        seconds.sort_by(f64::total_cmp);
        let (Some(first), Some(last)) = (seconds.first(), seconds.last()) else {
            return Self { median: f64::NAN, spread: f64::NAN };
        };
        Self { median: seconds[seconds.len() / 2], spread: last / first }
    }
}

/// Returns the time of a picture's passes on the device, or the wall-clock time if the device has no timestamps.
pub(super) fn device_time(totals: &Totals) -> Duration {
    totals.device.map_or(totals.wall, |stages| stages.iter().sum())
}

/// Of the straight line nearest to the points.
pub(super) fn slope(points: impl Iterator<Item = [f64; 2]>) -> f64 {
    let points: Vec<[f64; 2]> = points.collect();
    let count = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / count);
    let sum = |a: usize, b: usize| points.iter().map(|p| (p[a] - mean[a]) * (p[b] - mean[b])).sum::<f64>();
    sum(0, 1) / sum(0, 0)
}
