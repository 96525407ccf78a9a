//! The times of repeats.

use std::time::Duration;

use crate::render::{RenderError, Totals};

/// The time of repeated runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Times {
    /// The median, in seconds.
    pub median: f64,
    /// The ratio of the longest to the shortest.
    pub spread: f64,
}

impl Times {
    /// Measures `repeats` runs, after one that compiles.
    pub(crate) fn of(
        repeats: usize,
        mut run: impl FnMut() -> Result<Duration, RenderError>,
    ) -> Result<Self, RenderError> {
        let [times] = Self::by_turns(repeats, [&mut run])?;
        Ok(times)
    }

    /// Measures several runs in turns, each once in every repeat, so that disturbances affect all of them.
    pub(crate) fn by_turns<const N: usize>(
        repeats: usize,
        mut runs: [&mut dyn FnMut() -> Result<Duration, RenderError>; N],
    ) -> Result<[Self; N], RenderError> {
        let mut times = Self::all_by_turns(repeats, &mut runs)?.into_iter();
        Ok(std::array::from_fn(|_| times.next().unwrap_or(Self { median: f64::NAN, spread: f64::NAN })))
    }

    /// Measures any number of runs in turns.
    pub(crate) fn all_by_turns(
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

/// Returns the time of an image's passes on the device, or the wall-clock time if the device has no timestamps.
pub(super) fn device_time(totals: &Totals) -> Duration {
    totals.device.map_or(totals.wall, |stages| stages.iter().sum())
}

/// Returns the slope of the linear fit to the points.
pub(super) fn slope(points: impl Iterator<Item = [f64; 2]>) -> f64 {
    let points: Vec<[f64; 2]> = points.collect();
    let count = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / count);
    let sum = |a: usize, b: usize| points.iter().map(|p| (p[a] - mean[a]) * (p[b] - mean[b])).sum::<f64>();
    sum(0, 1) / sum(0, 0)
}
