//! The search of `method = "auto"` for the shooting method: a setting is accurate if finer ones find identical paths from lights to
//! positions.
//!
//! *Theory.* The end of a ray towards a position gives little information about the paths that lead there, because the Newton iteration divides by the
//! spread of a bundle. The comparison therefore uses the required result, the directions of a path at both ends. Steps are refined until
//! the distances between runs, and their ratios, show that the last one is accurate; they include the residual of the search at the
//! position.
//!
//! *Practice.* The compiled program later finds all paths. The shooting solver for a single center takes equal steps at every setting, and
//! reports their error.

use std::cmp::Reverse;
use std::iter::successors;

use glam::DVec3;

use super::calibrate::{Calibration, SEARCH, chosen_for, unjudged};
use super::ends::{Settled, angle};
use super::methods::{Candidate, fast_methods};
use super::reference::FINEST;
use super::refined::remaining;
use super::trials::{MARGIN, Trial, segments};
use super::{Judged, Quantiles};
use crate::gpu::Gpu;
use crate::model::control::{embedded, four_digits};
use crate::model::method::TOLERANT;
use crate::render::{LightPath, LightTracer, RenderError, RenderSettings};
use crate::scene::{Control, Precision, Scene};

/// The largest number of pairs of a light and a position on which settings are tried.
const PAIRS: usize = 200;
/// The first tolerance, relative to the required accuracy: the errors of smooth paths are far smaller.
const LOOSE: f64 = 100.0;
/// The largest tolerance.
const COARSEST: f64 = 1e-3;
/// The least reliable tolerance of 32 bits; for 64 bits it is [`FINEST`].
const FINEST_SINGLE: f64 = 1e-7;
/// The ratio of consecutive tolerances.
const FINER: f64 = 0.1;
/// The longest step, relative to the law's length scale.
const CAP: f64 = 0.3;
/// The difference of directions at the light, in radians, below which two settings have found one path.
const ONE_PATH: f64 = 1e-2;

/// Finds the setting for the paths between `pairs` of a position and a light, and a light tracer with it; returns `None` if the scene
/// specifies a method.
///
/// # Errors
///
/// Returns an error if the program cannot be compiled, or the device fails.
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
    /// Finds the first accurate setting in this precision or, if there is none, the one with the most accurate paths; also returns a light
    /// tracer with it.
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
            // Finer steps may leave too few segments for a path that coarser ones find.
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
            (Trial { method, control, judged: Judged::Ends, error: best.error, cost: f64::NAN }, best.rays)
        });
        tracer.retune(chosen.control, max_segments)?;
        Ok((Calibration { precision, rays, ..chosen_for(self.scene, self.settings, self.accuracy, chosen) }, tracer))
    }

    /// Returns settings from coarse to fine, each compared with the one before. A setting without numbers is compared with itself.
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

/// The finer of two runs, with the distance of its paths from those of the coarser one.
struct Compared {
    /// The distance between both runs for 99 of 100 paths, in radians.
    distance: f64,
    /// The resulting error of the finer one.
    error: f64,
    accuracy: f64,
    rays: Settled,
    /// The number of paths with the required accuracy.
    right: usize,
}

impl Compared {
    /// Compares two runs. There are at least `most` paths, and `before` is the distance between the two runs before.
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

    /// Returns a rank; lower is better.
    fn rank(&self) -> (Reverse<usize>, usize, f64) {
        (Reverse(self.right), self.rays.unsettled, self.error)
    }
}

/// Returns the distance of a path from its counterpart of a coarser run, at both ends and in their residuals, or `None` without a
/// counterpart.
fn distance_to(path: &LightPath, coarse: &[LightPath]) -> Option<f64> {
    let apart = |a: [f64; 3], b: [f64; 3]| angle(a.into(), b.into());
    let same = coarse.iter().min_by(|a, b| apart(a.leaves, path.leaves).total_cmp(&apart(b.leaves, path.leaves)))?;
    let leaves = apart(same.leaves, path.leaves);
    (leaves < ONE_PATH).then(|| leaves.max(apart(same.arrives, path.arrives)) + same.error.max(path.error))
}
