//! The drift of a law's constants of motion, a test of accuracy that needs no reference solution.
//!
//! *Theory.* Force centers conserve the energy ½|v|² + V, and a single one also the angular momentum x × v. A Schwarzschild black hole
//! conserves h = |x × v| and E² = ṙ² + (1 − 2M/r) h²/r², which together are the null condition. A medium conserves |v| = n (the host can
//! compute noise only where it is 1, outside an explosion). Flows conserve nothing. The drift is the difference between the end and the
//! start of a ray, relative to the magnitude of the quantity's terms.

use glam::DVec3;

use super::Quantiles;
use crate::model::Law;
use crate::render::{Status, Traced};

/// Returns each quantity's drift over rays with an end, from `starts` (x and v) to their ends.
#[must_use]
pub fn drift<'r>(
    law: &dyn Law,
    rays: impl Iterator<Item = ([DVec3; 2], &'r Traced)>,
) -> Vec<(&'static str, Quantiles)> {
    let mut drifts: Vec<(&'static str, Vec<f64>)> = Vec::new();
    for ([x, v], end) in rays {
        if !matches!(end.status, Status::Hit | Status::Escaped | Status::Captured | Status::Ended) {
            continue;
        }
        let before = law.invariants(x, v);
        for after in law.invariants(end.x.into(), end.v.into()) {
            let Some(first) = before.iter().find(|first| first.name == after.name) else { continue };
            let drift = (after.value - first.value).abs() / after.size.max(first.size);
            match drifts.iter_mut().find(|(name, _)| *name == after.name) {
                Some((_, all)) => all.push(drift),
                None => drifts.push((after.name, vec![drift])),
            }
        }
    }
    drifts.into_iter().map(|(name, all)| (name, Quantiles::of(all))).collect()
}
