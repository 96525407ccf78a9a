//! The comparison of a method with finer steps of itself, which estimates its error with the image's program.
//!
//! *Theory.* A run with much finer steps is the reference. Steps are refined until two runs agree much better than required. The error of
//! the last run follows from the ratio of the distances between such runs, and is part of every error relative to it. Rounding errors do
//! not decrease: if they keep two runs apart, the pair that agrees best is used, and the errors include the difference.
//!
//! *Practice.* Only the image's program is compiled, and compilation is most of the cost of a trial. The search ends before a run that
//! would increase its cost above a tenth of the image's.

use super::ends::{End, Finest, Settled, compared_layers, ends};
use super::{Candidate, Judged, cost};
use crate::gpu::Gpu;
use crate::program::ProgramOptions;
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Control, LightGrid, Method, Scene};

/// The approximate number of compared rays.
const RAYS: f64 = 4096.0;
/// The finest accuracy that the digits of an image's layers can resolve.
const FINEST: f64 = 3e-6;
/// The ratio of the distance between two runs to the required error below which they are an accurate reference.
const AGREES: f64 = 0.25;
/// The index of the first setting that is tried as the reference, and the number of settings between it and the next one.
const FIRST_TRUTH: usize = 3;
const STRIDE: usize = 3;
/// The approximate factor between the errors of consecutive settings.
const FINER: f64 = 3.16;
/// The approximate factor between the costs of the steps of these settings.
const DEARER: f64 = 2.4;
/// The minimum budget of a search, in evaluations: about a tenth of a second on two CPU cores.
const FREE: f64 = 1e8;
/// The fraction of the image's cost that is the budget otherwise.
const SHARE: f64 = 0.1;
/// The index of the first setting that is compared with the reference.
const FIRST: usize = 2;
/// The factor between errors below which the coarsest setting is taken if none is accurate.
const NO_BETTER: f64 = 1.5;

/// A method at a setting, with the results of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Refinement {
    pub control: Control,
    /// The error bound of 99 of 100 rays; of settled rays only, if too many are not.
    pub error: f64,
    /// The cost of a ray, in evaluations of a simple derivative.
    pub cost: f64,
    /// The states of the compared rays.
    pub rays: Settled,
}

impl Refinement {
    /// Returns `true` if the required error is reached, and nearly all rays have an end.
    pub fn suffices(&self, accuracy: f64) -> bool {
        self.error <= accuracy && !self.rays.is_lacking() && !self.loses_rays()
    }

    /// Returns `true` if the rays of this method are more often settled than those of another, or as often and more accurate.
    pub fn is_better(&self, other: &Self) -> bool {
        let rank = |found: &Self| (found.loses_rays(), found.rays.is_lacking(), found.error);
        rank(self) < rank(other)
    }

    /// Returns `true` if more than one of a thousand rays has no end.
    fn loses_rays(&self) -> bool {
        1000 * self.rays.endless > self.rays.all
    }
}

/// The ends of a run's rays, and the cost of one ray.
struct Run {
    ends: Vec<End>,
    cost: f64,
}

/// The compiled program of an image, with a first run of the method that is tried.
pub(super) struct Trying<'a> {
    pub renderer: Renderer<'a>,
    scene: Scene,
    judged: Judged,
    candidate: Candidate,
    max_segments: u32,
    /// The run of the first setting for the reference; `None` if a path is too long for the pass that follows all of it.
    first: Option<Run>,
}

impl<'a> Trying<'a> {
    /// Compiles the program of an image of `scene` with a method. Returns `None` if its runs cannot be compared: for a method without
    /// settings, and for an accuracy beyond the digits of an image's layers.
    pub fn new(
        gpu: &'a Gpu,
        scene: &Scene,
        settings: &RenderSettings,
        candidate: Candidate,
        (accuracy, max_segments): (f64, u32),
    ) -> Result<Option<Self>, RenderError> {
        let has_settings = candidate.controls.len() > FIRST_TRUTH + STRIDE;
        if accuracy < FINEST || !has_settings {
            return Ok(None);
        }
        let mut small = candidate.applied(scene, candidate.controls[FIRST_TRUTH]);
        small.image.size = reduced(scene.image.size);
        small.rays.max_segments = max_segments;
        // Only the ends of rays matter, not the light.
        for light in &mut small.lights {
            light.grid = LightGrid::COARSEST;
        }
        let options =
            ProgramOptions { layers: compared_layers(scene, &settings.options.layers), ..settings.options.clone() };
        let settings = RenderSettings { options, window: None, ..settings.clone() };
        let renderer = Renderer::keeping(gpu, small, settings)?;
        let judged = Judged::of_image(scene);
        let mut trying = Self { renderer, scene: scene.clone(), judged, candidate, max_segments, first: None };
        // Drivers compile a program when it first runs.
        trying.first = trying.run(trying.candidate.refined(FIRST_TRUTH))?;
        Ok(Some(trying))
    }

    /// Returns the method that is tried.
    pub fn method(&self) -> Method {
        self.candidate.method
    }

    /// Runs a control; returns `None` if a path is too long.
    fn run(&mut self, control: Control) -> Result<Option<Run>, RenderError> {
        self.renderer.retune(control, self.max_segments)?;
        let Some(rendering) = self.renderer.first_sample()? else { return Ok(None) };
        let totals = &rendering.totals;
        let [steps, rejected] = [totals.steps, totals.rejected].map(|count| count as f64 / totals.rays.max(1) as f64);
        let cost = cost(&self.scene, self.candidate.method, control, steps, rejected);
        Ok(Some(Run { ends: ends(&rendering, self.judged), cost }))
    }

    /// Returns the coarsest setting with which 99 of 100 rays have errors up to `accuracy`, or otherwise the cheapest that is
    /// nearly the best. Returns `None` if no two settings could run. `rays` is the number of rays of the whole image.
    pub fn search(&mut self, accuracy: f64, rays: u64) -> Result<Option<Refinement>, RenderError> {
        let Some(first) = self.first.take() else { return Ok(None) };
        let mut budget = Budget::new(self.scene.image.size, rays, first.cost);
        let Some(truth) = self.truth(first, accuracy, &mut budget)? else { return Ok(None) };
        let last = self.candidate.controls.len() - 1;
        let mut tried: Vec<Refinement> = Vec::new();
        let mut k = FIRST;
        loop {
            let control = self.candidate.controls[k];
            let Some(run) = self.run(control)? else { break };
            budget.spend(run.cost);
            let error = truth.deviation(&run.ends);
            let was_right = tried.iter().any(|found| found.error <= accuracy);
            tried.push(Refinement { control, error, cost: run.cost, rays: truth.rays });
            let is_right = error <= accuracy;
            // The number of settings further that the search may or must move.
            let further = ((accuracy / error).ln() / FINER.ln()).abs().min(last as f64) as usize;
            k = match (is_right, was_right) {
                (true, false) if further > 0 && k > 0 => k.saturating_sub(further),
                (false, false) if k < last && budget.allows(run.cost) => (k + further.clamp(1, STRIDE)).min(last),
                _ => break,
            };
        }
        self.halve(&truth, accuracy, &mut tried)?;
        let least = tried.iter().map(|found| found.error).fold(f64::INFINITY, f64::min);
        let enough = if least <= accuracy { accuracy } else { NO_BETTER * least };
        let enough = tried.into_iter().filter(|found| found.error <= enough);
        Ok(enough.min_by(|a, b| a.cost.total_cmp(&b.cost)))
    }

    /// Tries the setting between the coarsest accurate one and the next coarser one.
    fn halve(&mut self, truth: &Finest, accuracy: f64, tried: &mut Vec<Refinement>) -> Result<(), RenderError> {
        let right = tried.iter().filter(|found| found.error <= accuracy).min_by(|a, b| a.cost.total_cmp(&b.cost));
        let wrong = tried.iter().filter(|found| found.error > accuracy).max_by(|a, b| a.cost.total_cmp(&b.cost));
        let (Some(right), Some(wrong)) = (right, wrong) else { return Ok(()) };
        let control = wrong.control.between(right.control);
        if let Some(run) = self.run(control)? {
            tried.push(Refinement { control, error: truth.deviation(&run.ends), cost: run.cost, rays: truth.rays });
        }
        Ok(())
    }

    /// Returns the reference, starting from the first run that may be one.
    fn truth(&mut self, first: Run, accuracy: f64, budget: &mut Budget) -> Result<Option<Finest>, RenderError> {
        let last = self.candidate.controls.len() - 1;
        let mut best: Option<Finest> = None;
        let (mut k, mut coarse, mut before) = (FIRST_TRUTH, first, None);
        while k < last && (best.is_none() || budget.allows(DEARER * coarse.cost)) {
            k = (k + STRIDE).min(last);
            let Some(fine) = self.run(self.candidate.refined(k))? else { break };
            budget.spend(fine.cost);
            let mut found = Finest::of(&coarse.ends, &fine.ends);
            let apart = found.slack;
            found.slack *= remaining(before.map_or(1.0, |before| apart / before));
            before = Some(apart);
            let is_near = found.slack <= AGREES * accuracy && !found.rays.is_lacking();
            let rank = |truth: &Finest| (truth.rays.is_lacking(), truth.slack);
            if best.as_ref().is_none_or(|best| rank(&found) < rank(best)) {
                best = Some(found);
            }
            if is_near {
                break;
            }
            coarse = fine;
        }
        Ok(best)
    }
}

/// The budget of a search, in evaluations.
struct Budget {
    /// The number of rays of a run.
    rays: f64,
    left: f64,
}

impl Budget {
    /// Creates the budget for an image of `rays` rays with this initial cost of a ray.
    fn new(size: [u32; 2], rays: u64, cost: f64) -> Self {
        let own = f64::from(reduced(size).into_iter().product::<u32>());
        Self { rays: own, left: FREE.max(SHARE * rays as f64 * cost) - own * cost }
    }

    fn spend(&mut self, cost: f64) {
        self.left -= self.rays * cost;
    }

    /// Returns `true` if the budget allows a run of this cost.
    fn allows(&self, cost: f64) -> bool {
        self.rays * cost <= self.left
    }
}

/// Returns the error of the finer of two runs relative to the distance between them, if each distance is `ratio` times the one before: the
/// sum of all that would follow. Distances that do not decrease are rounding errors, half of which belong to the finer run.
pub(super) fn remaining(ratio: f64) -> f64 {
    if ratio < 1.0 / 3.0 { ratio / (1.0 - ratio) } else { 0.5 }
}

impl Candidate {
    /// Returns a refined setting; for a tolerance the longest step is also refined, because it would otherwise hide its error.
    fn refined(&self, k: usize) -> Control {
        let control = self.controls[k];
        if control.kind.has_tolerance {
            Control { cap: control.cap * 0.5_f64.powf(k as f64 / STRIDE as f64), ..control }
        } else {
            control
        }
    }
}

/// Returns the image's size, or a smaller one of similar shape with at most the number of compared rays.
fn reduced([width, height]: [u32; 2]) -> [u32; 2] {
    let scale = (RAYS / (f64::from(width) * f64::from(height))).sqrt().min(1.0);
    [width, height].map(|side| ((f64::from(side) * scale).round() as u32).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_pictures_are_tried_on_small_ones_of_their_shape() {
        assert_eq!(reduced([64, 64]), [64, 64]);
        assert_eq!(reduced([30, 20]), [30, 20]);
        assert_eq!(reduced([1600, 900]), [85, 48]);
        assert_eq!(reduced([6 * 10_000, 1]), [15_677, 1]);
    }
}
