//! What a law keeps along a ray: a check of accuracy that needs no truth.
//!
//! *Theory.* Force centers keep the energy ½|v|² + V, and a single one also the angular momentum x × v; a Schwarzschild hole keeps
//! h = |x × v| and E² = ṙ² + (1 − 2M/r) h²/r², which together are the null condition; a medium keeps |v| = n (noise
//! is known where it is 1, outside an explosion). Flows keep nothing. By how much the end of a ray departs from its start is the drift, relative to what the quantity is made of.

use glam::DVec3;

use super::Quantiles;
use crate::model::Law;
use crate::render::{Status, Traced};

/// Each quantity's drift over rays that were followed to an end: from `starts` (x and v) to their ends.
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
