//! `method = "auto"` for shooting: a setting is right if finer ones find the same paths from lights to places.
//!
//! *Theory.* Where a ray aimed at a place ends tells little of the paths that lead there: Newton's method divides by how a bundle
//! spreads. What is compared is therefore what is asked for, the directions of a path at both of its ends. Steps are refined until the
//! distances between runs, and how fast they shrink, tell that the last one is right; what the search itself misses a place by is part
//! of them.
//!
//! *Practice.* The program that is compiled is the one that goes on to find all paths. Shooting's own method about a single center
//! takes the same steps at every setting, and tells what they are off by.

use std::cmp::Reverse;
use std::iter::successors;

use glam::DVec3;

use super::Quantiles;
use super::calibrate::{Calibration, SEARCH, chosen_for, unjudged};
use super::ends::{Settled, angle};
use super::methods::{Candidate, fast_methods};
use super::refined::remaining;
use super::trials::{MARGIN, Trial, segments};
use super::truth::FINEST;
use crate::gpu::Gpu;
use crate::model::control::{embedded, four_digits};
use crate::model::method::TOLERANT;
use crate::render::{LightPath, LightTracer, RenderError, RenderSettings};
use crate::scene::{Control, Precision, Scene};

/// Pairs of a light and a place that settings are tried on, at most.
const PAIRS: usize = 200;
/// The first tolerance that is tried, in parts of the accuracy asked for: smooth paths err by far less.
const LOOSE: f64 = 100.0;
/// The largest tolerance that is tried.
const COARSEST: f64 = 1e-3;
/// The least tolerance that 32 bits are sure to keep; of 64 bits it is [`FINEST`].
const FINEST_SINGLE: f64 = 1e-7;
/// The next tolerance, in parts of the one before.
const FINER: f64 = 0.1;
/// Of the law's length, a step at most.
const CAP: f64 = 0.3;
/// Directions at the light, in radians, that belong to one path at both settings.
const ONE_PATH: f64 = 1e-2;

/// Finds the setting for the paths between `pairs` of a place and a light, and the light tracer that finds them by it; none where the scene
/// names a method.
pub fn calibrate_paths<'a>(
    gpu: &'a Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    pairs: &[[DVec3; 2]],
) -> Result<Option<(Calibration, LightTracer<'a>)>, RenderError> {
    let Some(accuracy) = scene.accuracy() else { return Ok(None) };
    let _stage = gpu.progress.stage(SEARCH);
    let tried: Vec<_> = pairs.iter().step_by(pairs.len().div_ceil(PAIRS).max(1)).copied().collect();
    let mut candidates = fast_methods(scene);
    let at = candidates.iter().position(|candidate| candidate.method == TOLERANT).unwrap_or(0);
    let trying = Trying { gpu, scene, settings, accuracy, pairs: &tried, candidate: candidates.swap_remove(at) };
    let (mut found, tracer) = trying.search(scene.rays.precision)?;
    let is_settled = found.reached() || found.rays.all == 0;
    if is_settled || scene.rays.precision == Precision::Double || !gpu.f64 {
        return Ok(Some((found, tracer)));
    }
    let (double, double_tracer) = trying.search(Precision::Double)?;
    if scene.rays.auto.is_some_and(|auto| auto.precision) && double.chosen.error < found.chosen.error {
        return Ok(Some((double, double_tracer)));
    }
    found.in_double = Some(double.chosen).filter(|trial| trial.error < found.chosen.error);
    Ok(Some((found, tracer)))
}

/// A search among the settings of one method.
struct Trying<'a, 's> {
    gpu: &'a Gpu,
    scene: &'s Scene,
    settings: &'s RenderSettings,
    accuracy: f64,
    pairs: &'s [[DVec3; 2]],
    candidate: Candidate,
}

/// The paths of each pair.
type Paths = Vec<Vec<LightPath>>;

fn count(paths: &Paths) -> usize {
    paths.iter().map(Vec::len).sum()
}

impl<'a> Trying<'a, '_> {
    /// Finds the first setting that is right in numbers of this precision or, if none is, the one with the most right paths; and returns a
    /// light tracer that uses it.
    fn search(&self, precision: Precision) -> Result<(Calibration, LightTracer<'a>), RenderError> {
        let (method, max_segments) = (self.candidate.method, segments(self.scene));
        let controls = self.controls(precision);
        let mut scene = self.candidate.applied(self.scene, controls[0]);
        (scene.rays.precision, scene.rays.max_segments) = (precision, max_segments);
        let mut tracer = LightTracer::new(self.gpu, scene, self.settings)?;
        let mut coarse = tracer.paths_between(self.pairs)?.0;
        let mut best: Option<(Compared, Control)> = None;
        let mut before = None;
        for &control in &controls[1..] {
            tracer.retune(control, max_segments)?;
            let fine = tracer.paths_between(self.pairs)?.0;
            // Finer steps may leave no room for a path that coarser ones find.
            let most = best.as_ref().map_or(0, |(best, _)| best.rays.all);
            let found = Compared::of((&coarse, &fine), most, before, MARGIN * self.accuracy);
            before = Some(found.distance);
            let is_over = found.is_right() || found.rays.all == 0;
            if best.as_ref().is_none_or(|(best, _)| found.rank() < best.rank()) {
                best = Some((found, control));
            }
            if is_over {
                break;
            }
            coarse = fine;
        }
        let (chosen, rays) = best.map_or((unjudged(), Settled::default()), |(best, control)| {
            (Trial { method, control, error: best.error, cost: f64::NAN }, best.rays)
        });
        tracer.retune(chosen.control, max_segments)?;
        Ok((Calibration { precision, rays, ..chosen_for(self.scene, self.settings, self.accuracy, chosen) }, tracer))
    }

    /// Settings from coarse to fine, each compared with the one before. One that has no numbers is compared with itself.
    fn controls(&self, precision: Precision) -> Vec<Control> {
        if self.candidate.method != TOLERANT {
            return vec![self.candidate.controls[0]; 2];
        }
        let finest = if precision == Precision::Double { FINEST } else { FINEST_SINGLE };
        let first = (LOOSE * self.accuracy).clamp(finest / FINER, COARSEST);
        let tolerances = successors(Some(first), |tolerance| Some(FINER * tolerance));
        tolerances
            .take_while(|tolerance| *tolerance > 0.5 * finest)
            .map(|tolerance| embedded::with(four_digits(tolerance), CAP))
            .collect()
    }
}

/// The finer of two runs, by how far its paths are from those of the coarser one.
struct Compared {
    /// Between both runs, of 99 of 100 paths, in radians.
    distance: f64,
    /// What the finer one is off by, accordingly.
    error: f64,
    accuracy: f64,
    rays: Settled,
    /// Paths that are as accurate as is asked for.
    right: usize,
}

impl Compared {
    /// There are `most` paths at least, and `before` is how far the two runs before were apart.
    fn of((coarse, fine): (&Paths, &Paths), most: usize, before: Option<f64>, accuracy: f64) -> Self {
        let pairs = coarse.iter().zip(fine);
        let distances: Vec<f64> =
            pairs.flat_map(|(coarse, fine)| fine.iter().filter_map(|path| distance_to(path, coarse))).collect();
        let all = most.max(count(coarse)).max(count(fine));
        let rays = Settled { all, unsettled: all.saturating_sub(distances.len()), endless: 0 };
        let Quantiles { p95, sure99, .. } = Quantiles::of(distances.clone());
        let distance = if rays.is_lacking() { p95 } else { sure99 };
        let left = remaining(before.map_or(1.0, |before| distance / before));
        let right = distances.iter().filter(|distance| left * **distance <= accuracy).count();
        let error = if distances.is_empty() { f64::INFINITY } else { left * distance };
        Self { distance, error, accuracy, rays, right }
    }

    fn is_right(&self) -> bool {
        self.error <= self.accuracy && !self.rays.is_lacking()
    }

    /// The less, the better.
    fn rank(&self) -> (Reverse<usize>, usize, f64) {
        (Reverse(self.right), self.rays.unsettled, self.error)
    }
}

/// How far a path is from the same one of a coarser run, at both ends and in what they miss the place by; none if there is none.
fn distance_to(path: &LightPath, coarse: &[LightPath]) -> Option<f64> {
    let apart = |a: [f64; 3], b: [f64; 3]| angle(a.into(), b.into());
    let same = coarse.iter().min_by(|a, b| apart(a.leaves, path.leaves).total_cmp(&apart(b.leaves, path.leaves)))?;
    let leaves = apart(same.leaves, path.leaves);
    (leaves < ONE_PATH).then(|| leaves.max(apart(same.arrives, path.arrives)) + same.error.max(path.error))
}
