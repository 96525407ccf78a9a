//! Estimates the remaining time of work from the time that it has taken.
//!
//! *Theory.* The rate is measured over about the latest half of the elapsed time, from the end of one unit to the end of another. A slow
//! start, such as a compilation, and units that were done before drop out in time, and one slow unit has no more influence than its length.
//! Between the ends of units the remaining time counts down; if a unit takes longer than the units before, it grows.

use std::collections::VecDeque;
use std::time::Duration;

/// The fraction of the elapsed time within which ends of units are merged, so that few are stored.
const CLOSE: f64 = 1.0 / 256.0;

/// The smallest fraction that counts as a unit; smaller ones may be rounding errors.
const LEAST: f64 = 1e-6;

/// Estimates the remaining time of work from its progress. Times count from the work's start.
#[derive(Debug, Clone)]
pub struct Estimate {
    /// The time in seconds and the fraction done, for each stored unit; the first entry is the latest one in the first half of the time.
    seen: VecDeque<(f64, f64)>,
}

impl Default for Estimate {
    fn default() -> Self {
        Self { seen: [(0.0, 0.0)].into() }
    }
}

impl Estimate {
    /// Records the fraction `done` at a time.
    pub fn see(&mut self, at: Duration, done: f64) {
        let at = at.as_secs_f64();
        // Work that must be repeated is not done.
        self.seen.retain(|(_, before)| *before <= done);
        if self.seen.back().is_some_and(|(_, last)| done - last < LEAST) {
            return;
        }
        while self.seen.get(1).is_some_and(|(next, _)| *next <= at / 2.0) {
            self.seen.pop_front();
        }
        let near = |i: usize| self.seen.len().checked_sub(i).and_then(|i| self.seen.get(i)).map_or(0.0, |(at, _)| *at);
        if self.seen.len() > 2 && near(1) - near(2) < CLOSE * at {
            self.seen.pop_back();
        }
        self.seen.push_back((at, done));
    }

    /// Returns the time left at a time; `None` before the first unit is done.
    #[must_use]
    pub fn left(&self, now: Duration) -> Option<Duration> {
        let now = now.as_secs_f64();
        let (last, before) = (self.seen.back()?, self.seen.get(self.seen.len().checked_sub(2)?)?);
        // The rate is taken over at least one unit.
        let starts = self.seen.iter().take(self.seen.len() - 1);
        let start = starts.take_while(|(at, _)| *at <= now / 2.0).last().unwrap_or(&self.seen[0]);
        let (time, work) = (last.0 - start.0, last.1 - start.1);
        let unit = (last.1 - before.1).min(1.0 - last.1);
        let since = now - last.0;
        // The next unit is expected to take as long as the ones before. If it is late, the rate is as if it ended now, and the unit is
        // expected to be as late again.
        let late = since - unit * time / work;
        let left = if late <= 0.0 {
            (1.0 - last.1) * time / work - since
        } else {
            (1.0 - last.1 - unit) * (now - start.0) / (work + unit) + late
        };
        Duration::try_from_secs_f64(left.max(0.0)).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(seconds: f64) -> Duration {
        Duration::from_secs_f64(seconds)
    }

    /// Returns the estimates at the end of each unit, with the true remaining time.
    fn estimates(units: &[f64]) -> Vec<[f64; 2]> {
        let all: f64 = units.iter().sum();
        let (mut estimate, mut at) = (Estimate::default(), 0.0);
        let mut found = Vec::new();
        for (i, unit) in units.iter().enumerate() {
            at += unit;
            estimate.see(seconds(at), (i + 1) as f64 / units.len() as f64);
            found.push([estimate.left(seconds(at)).unwrap().as_secs_f64(), all - at]);
        }
        found
    }

    #[test]
    fn equal_units_are_foretold_from_the_first() {
        assert_eq!(Estimate::default().left(seconds(5.0)), None);
        for count in [2, 10, 3000] {
            for [estimate, truth] in estimates(&vec![0.7; count]) {
                assert!((estimate - truth).abs() < 1e-6 * (truth + 1.0), "{estimate} for {truth}");
            }
        }
    }

    #[test]
    fn a_slow_start_is_forgotten() {
        // The first unit takes 20 units of time; after another 20 it is no longer in the latest half.
        let units: Vec<f64> = std::iter::once(20.0).chain(std::iter::repeat_n(1.0, 200)).collect();
        for [estimate, truth] in &estimates(&units)[20..] {
            assert!((estimate - truth).abs() < 1e-6 * (truth + 1.0), "{estimate} for {truth}");
        }
    }

    #[test]
    fn units_that_were_done_already_promise_nothing() {
        let units: Vec<f64> = std::iter::repeat_n(1e-3, 50).chain(std::iter::repeat_n(10.0, 50)).collect();
        for [estimate, truth] in &estimates(&units)[50..] {
            assert!((estimate - truth).abs() < 1e-3 * truth + 0.1, "{estimate} for {truth}");
        }
    }

    #[test]
    fn a_change_of_speed_is_followed() {
        let units: Vec<f64> = std::iter::repeat_n(1.0, 100).chain(std::iter::repeat_n(3.0, 100)).collect();
        let found = estimates(&units);
        // The 100 s at the old rate leave the latest half after 200 s, that is, after 34 units at the new rate.
        for [estimate, truth] in &found[134..] {
            assert!((estimate - truth).abs() < 0.05 * truth + 4.0, "{estimate} for {truth}");
        }
    }

    #[test]
    fn time_is_counted_down_between_units_and_grows_when_one_is_late() {
        let mut estimate = Estimate::default();
        estimate.see(seconds(10.0), 0.1);
        estimate.see(seconds(20.0), 0.2);
        let left = |now| estimate.left(seconds(now)).unwrap().as_secs_f64();
        assert!((left(20.0) - 80.0).abs() < 1e-9);
        assert!((left(26.0) - 74.0).abs() < 1e-9);
        // The unit was due at 30 s.
        assert!((left(30.0) - 70.0).abs() < 1e-9);
        assert!((30..200).all(|now| left(f64::from(now + 1)) >= left(f64::from(now))));
        assert!(left(40.0) > 80.0, "{}", left(40.0));
    }

    #[test]
    fn work_that_is_done_again_leaves_an_estimate() {
        let mut estimate = Estimate::default();
        for (at, done) in [(1.0, 0.2), (2.0, 0.4), (3.0, 0.1), (4.0, 0.2), (5.0, 0.3), (6.0, 0.4)] {
            estimate.see(seconds(at), done);
        }
        let left = estimate.left(seconds(6.0)).unwrap().as_secs_f64();
        assert!((5.0..12.0).contains(&left), "{left}");
    }

    #[test]
    fn rounding_is_no_progress() {
        let mut estimate = Estimate::default();
        for (at, done) in [(0.0, 0.05), (0.2, 0.05 + 1e-15), (1.0, 0.06)] {
            estimate.see(seconds(at), done);
            let left = estimate.left(seconds(at)).unwrap().as_secs_f64();
            assert!(left < 100.0, "{left} at {at}");
        }
    }

    #[test]
    fn few_ends_are_kept_of_many() {
        let mut estimate = Estimate::default();
        for i in 1..=1_000_000 {
            estimate.see(seconds(f64::from(i) * 0.1), f64::from(i) / 2e6);
        }
        assert!(estimate.seen.len() < 400, "{}", estimate.seen.len());
        let left = estimate.left(seconds(1e5)).unwrap().as_secs_f64();
        assert!((left - 1e5).abs() < 1e3, "{left}");
    }
}
