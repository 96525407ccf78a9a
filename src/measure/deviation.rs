//! Differences of a run from the reference solution.

use std::fmt;

use super::judged::{least_light, light_error};
use super::reference::intensities;
use super::{Judged, Known, ReferenceSolution};
use crate::model::volume::MOST_FREQUENCIES;
use crate::render::{Status, Traced, Transferred};

/// Quantiles of errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantiles {
    /// The bound for half of the rays.
    pub median: f64,
    /// The bound for 95 of 100 rays.
    pub p95: f64,
    /// The bound for 99 of 100 rays.
    pub p99: f64,
    /// The bound for 99 of 100 of all rays, of which these are a random sample: two standard deviations above the 99th percentile in the
    /// count of the sample, because errors have long tails.
    pub sure99: f64,
    /// The maximum.
    pub max: f64,
}

impl fmt::Display for Quantiles {
    /// Writes median, 99th percentile and maximum in columns, or that there are no values.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.max.is_nan() {
            return write!(f, "{:>12}{:>12}{:>12}", "none", "none", "none");
        }
        write!(f, "{:>12.2e}{:>12.2e}{:>12.2e}", self.median, self.p99, self.max)
    }
}

impl Quantiles {
    /// Computes the quantiles of values in any order; NaN if there are none.
    #[must_use]
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        // The least value that this fraction of the rays does not exceed.
        let at = |q: f64| {
            let rank = (q * values.len() as f64).ceil() as usize;
            values.get(rank.max(1) - 1).copied().unwrap_or(f64::NAN)
        };
        let spread = (0.99 * 0.01 / values.len().max(1) as f64).sqrt();
        let sure99 = at((0.99 + 2.0 * spread).min(1.0));
        Self { median: at(0.5), p95: at(0.95), p99: at(0.99), sure99, max: at(1.0) }
    }
}

/// The errors of a run, over the rays with a known reference solution.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorStats {
    /// The number of rays compared, whose correct termination is certain.
    pub rays: usize,
    /// The number of rays whose end is not fully known.
    pub unresolved: usize,
    /// The number of rays with a different termination status or object.
    pub wrong: usize,
    /// The number of these rays that reported a failure: exhausted, stalled or failed.
    pub flagged: usize,
    /// The errors of the final direction, in radians.
    pub angle: Quantiles,
    /// The errors of the final position, in scene units.
    pub position: Quantiles,
    /// The errors of the final τ.
    pub tau: Quantiles,
    /// The errors of the visible result: the direction to the sky, or a surface position divided by the distance to it; infinite for a
    /// wrong end.
    pub seen: Quantiles,
    /// The errors of the intensities, relative to them; `None` without `[radiation]`.
    pub light: Option<Quantiles>,
}

impl ErrorStats {
    /// Compares `rays`, and their light if there is `[radiation]`, with the reference solution. For captured rays only the status is
    /// compared, because they are black wherever they cross the horizon. Pixels without rays are ignored.
    #[must_use]
    pub fn new(rays: &[Traced], spectra: &[Vec<Transferred>], truth: &ReferenceSolution) -> Self {
        let there = |(_, truth): &(&Traced, &Traced)| truth.status != Status::Outside;
        let of = |known: fn(&Known) -> Option<&Traced>| -> Vec<(&Traced, &Traced)> {
            rays.iter().zip(&truth.ends).filter_map(|(ray, truth)| Some((ray, known(truth)?))).filter(there).collect()
        };
        // A wrong end counts if the correct one is certain; errors of direction and position only if these are also known.
        let (known, whole) = (of(Known::end), of(Known::whole));
        let right = |(ray, truth): &(&Traced, &Traced)| (ray.status, ray.object) == (truth.status, truth.object);
        let lost =
            |ray: &Traced| matches!(ray.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed);
        let seen_ends: Vec<_> =
            whole.iter().copied().filter(right).filter(|(_, truth)| truth.status != Status::Captured).collect();
        let over = |error: &dyn Fn(&Traced, &Traced) -> f64| {
            Quantiles::of(seen_ends.iter().map(|(ray, truth)| error(ray, truth)).collect())
        };
        let wrong = known.iter().filter(|pair| !right(pair));
        Self {
            rays: known.len(),
            unresolved: truth.unresolved(),
            wrong: wrong.clone().count(),
            flagged: wrong.clone().filter(|(ray, _)| lost(ray)).count(),
            angle: over(&Traced::angle_to),
            position: over(&Traced::distance_to),
            tau: over(&|ray, truth| (ray.tau - truth.tau).abs()),
            seen: Quantiles::of(
                whole
                    .iter()
                    .filter(|pair| right(pair))
                    .map(|(ray, truth)| seen(ray, truth))
                    .chain(wrong.map(|_| f64::INFINITY))
                    .collect(),
            ),
            light: (!truth.light.is_empty()).then(|| light_errors(spectra, truth)),
        }
    }

    /// Returns the errors of a measure.
    #[must_use]
    pub fn judged(&self, judged: Judged) -> &Quantiles {
        match (judged, &self.light) {
            (Judged::Light, Some(light)) => light,
            _ => &self.seen,
        }
    }
}

/// Returns the errors of the intensities of rays whose light is known.
fn light_errors(spectra: &[Vec<Transferred>], truth: &ReferenceSolution) -> Quantiles {
    let least = least_light(truth.light.iter().flatten().map(Vec::as_slice));
    let pairs = intensities(spectra).into_iter().zip(&truth.light);
    Quantiles::of(pairs.filter_map(|(light, truth)| Some(light_error(&light, truth.as_ref()?, &least))).collect())
}

/// Returns the error of the light of all rays together, relative to it: the largest of all frequencies. Rays whose light is not known do not
/// count.
#[must_use]
pub fn flux_error(spectra: &[Vec<Transferred>], truth: &ReferenceSolution) -> f64 {
    let mut sums = [[0.0; 2]; MOST_FREQUENCIES];
    for (light, truth) in intensities(spectra).iter().zip(&truth.light) {
        for ((sum, light), truth) in sums.iter_mut().zip(light).zip(truth.iter().flatten()) {
            *sum = [sum[0] + light, sum[1] + truth];
        }
    }
    let errors = sums.iter().filter(|[_, truth]| *truth > 0.0).map(|[light, truth]| (light / truth - 1.0).abs());
    errors.fold(0.0, f64::max)
}

fn seen(ray: &Traced, truth: &Traced) -> f64 {
    match truth.status {
        Status::Captured => 0.0,
        Status::Escaped => ray.angle_to(truth),
        _ => {
            let way = truth.tau * truth.speed();
            ray.angle_to(truth).max(if way > 0.0 { ray.distance_to(truth) / way } else { 0.0 })
        }
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp)] // quantiles are values of the sample
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_values_that_so_many_do_not_exceed() {
        let q = Quantiles::of((1..=200).rev().map(f64::from).collect());
        assert_eq!((q.median, q.p95, q.p99, q.max), (100.0, 190.0, 198.0, 200.0));
        assert_eq!(Quantiles::of(vec![3.0]), Quantiles { median: 3.0, p95: 3.0, p99: 3.0, sure99: 3.0, max: 3.0 });
        assert_eq!(Quantiles::of((1..=10_000).map(f64::from).collect()).sure99, 9920.0);
        assert!(Quantiles::of(Vec::new()).max.is_nan());
        assert_eq!(Quantiles::of(vec![1.0, f64::INFINITY]).max, f64::INFINITY);
    }

    fn ray(status: Status, v: [f64; 3]) -> Traced {
        Traced { status, x: [1.0, 0.0, 0.0], v, tau: 2.0, segments: 0.0, steps: 1, rejected: 0, object: None }
    }

    fn known(ends: Vec<Known>) -> ReferenceSolution {
        ReferenceSolution { ends, light: Vec::new() }
    }

    #[test]
    fn fates_are_counted_apart_from_errors() {
        let truth = known(vec![
            Known::Whole(ray(Status::Escaped, [0.0, 0.0, 1.0])),
            Known::Whole(ray(Status::Escaped, [0.0, 0.0, 1.0])),
            Known::Whole(ray(Status::Captured, [0.0, 0.0, 1.0])),
            Known::Whole(ray(Status::Escaped, [0.0, 0.0, 1.0])),
            Known::Nothing,
        ]);
        let rays = [
            ray(Status::Escaped, [1e-9, 0.0, 2.0]),
            ray(Status::Captured, [0.0, 0.0, 1.0]),
            ray(Status::Captured, [1.0, 0.0, 0.0]),
            ray(Status::Stalled, [0.0, 0.0, 1.0]),
            ray(Status::Escaped, [1.0, 0.0, 0.0]),
        ];
        let found = ErrorStats::new(&rays, &[], &truth);
        assert_eq!((found.rays, found.unresolved, found.wrong, found.flagged), (4, 1, 2, 1));
        // Half of 1e-9, as v has length 2: small angles keep their digits.
        assert!((found.angle.max - 5e-10).abs() < 1e-20, "{:e}", found.angle.max);
        assert_eq!(found.seen.max, f64::INFINITY);
    }
    /// Checks that for rays with an unknown direction only a wrong end counts.
    #[test]
    fn a_certain_end_counts() {
        let escaped = ray(Status::Escaped, [0.0, 0.0, 1.0]);
        let truth = known(vec![Known::Whole(escaped), Known::End(escaped), Known::End(escaped)]);
        let found = |last| {
            let rays = [escaped, ray(Status::Escaped, [0.3, 0.0, 1.0]), ray(last, [0.0, 0.0, 1.0])];
            ErrorStats::new(&rays, &[], &truth)
        };
        let right = found(Status::Escaped);
        assert_eq!((right.rays, right.wrong, right.unresolved, right.seen.max), (3, 0, 2, 0.0));
        let wrong = found(Status::Captured);
        assert_eq!((wrong.rays, wrong.wrong, wrong.seen.max), (3, 1, f64::INFINITY));
    }
}
