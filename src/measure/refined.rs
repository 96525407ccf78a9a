//! A method against itself with finer steps: what it errs by, found with the picture's own program.
//!
//! *Theory.* A run with much finer steps stands for the truth. Steps are refined until two runs agree much better than is asked for.
//! From how fast the distances between such runs shrink follows what the last one is still off by, and that is part of every error
//! measured against it. Rounding does not shrink: where it keeps two runs apart, the pair that agrees best is taken, and the errors
//! are as large as that makes them.
//!
//! *Practice.* Nothing is compiled that the picture does not run anyway, and compiling is most of what trying a method costs. The
//! search ends before a run that would make it cost more than a tenth of the picture.

use super::ends::{End, Finest, Settled, compared_layers, ends};
use super::{Candidate, cost};
use crate::gpu::Gpu;
use crate::program::Choice;
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Control, LightGrid, Method, Scene};

/// Rays that are compared, about.
const RAYS: f64 = 4096.0;
/// The finest accuracy, in radians, that can be told from the digits that a picture's layers have.
const FINEST: f64 = 3e-6;
/// Two runs that agree this much better than asked for are near enough to the truth.
const AGREES: f64 = 0.25;
/// The first setting that is tried for a truth, and how many settings finer the next one is.
const FIRST_TRUTH: usize = 3;
const STRIDE: usize = 3;
/// By what factor the error of the next finer setting is smaller, about.
const FINER: f64 = 3.16;
/// How much more a run costs with steps so much finer, about.
const DEARER: f64 = 2.4;
/// What the runs of a search may cost whatever the picture takes, in evaluations: about a tenth of a second on two CPU cores.
const FREE: f64 = 1e8;
/// The part of the picture's own cost that they may take otherwise.
const SHARE: f64 = 0.1;
/// The first setting that is tried against the truth.
const FIRST: usize = 2;
/// Of settings whose errors differ by less than this factor the coarsest is taken, where none is right.
const NO_BETTER: f64 = 1.5;

/// A method at a setting, with what a search found of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub control: Control,
    /// 99 of 100 rays err by no more, in radians; of those that are settled, where too many are not.
    pub error: f64,
    /// What a ray costs, in evaluations of a simple derivative.
    pub cost: f64,
    /// What became of the rays that were compared.
    pub rays: Settled,
}

/// The ends of a run's rays, and what one of them costs.
struct Run {
    ends: Vec<End>,
    cost: f64,
}

/// A picture's program, compiled, and a first run by the method that is tried.
pub(super) struct Trying<'a> {
    pub renderer: Renderer<'a>,
    scene: Scene,
    candidate: Candidate,
    max_segments: u32,
    /// By the first setting that may stand for the truth; none where a path is too long for the pass that follows all of it.
    first: Option<Run>,
}

impl<'a> Trying<'a> {
    /// Compiles the program of a picture of `scene` by a method. None where its runs cannot be compared: for a method
    /// without settings to compare, and for an accuracy beyond the digits of a picture's layers.
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
        // What light falls where does not matter, only where rays end.
        for light in &mut small.lights {
            light.grid = LightGrid::COARSEST;
        }
        let choice = Choice { layers: compared_layers(&settings.choice.layers), ..settings.choice.clone() };
        let settings = RenderSettings { choice, window: None, ..settings.clone() };
        let renderer = Renderer::keeping(gpu, small, settings)?;
        let mut trying = Self { renderer, scene: scene.clone(), candidate, max_segments, first: None };
        // Drivers compile when a program is first run.
        trying.first = trying.run(trying.candidate.refined(FIRST_TRUTH))?;
        Ok(Some(trying))
    }

    /// The method that is tried.
    pub fn method(&self) -> Method {
        self.candidate.method
    }

    /// Runs a control; none where a path is too long.
    fn run(&mut self, control: Control) -> Result<Option<Run>, RenderError> {
        self.renderer.retune(control, self.max_segments)?;
        let Some(rendering) = self.renderer.first_sample()? else { return Ok(None) };
        let totals = &rendering.totals;
        let [steps, rejected] = [totals.steps, totals.rejected].map(|count| count as f64 / totals.rays.max(1) as f64);
        let cost = cost(&self.scene, self.candidate.method, control, steps, rejected);
        Ok(Some(Run { ends: ends(&rendering), cost }))
    }

    /// The coarsest setting by which 99 of 100 rays err by no more than `accuracy`, in radians; or, where none is right, the cheapest
    /// that is hardly worse than the best. None where no two settings could be run. `rays` is how many the whole picture has.
    pub fn search(&mut self, accuracy: f64, rays: u64) -> Result<Option<Found>, RenderError> {
        let Some(first) = self.first.take() else { return Ok(None) };
        let mut budget = Budget::new(self.scene.image.size, rays, first.cost);
        let Some(truth) = self.truth(first, accuracy, &mut budget)? else { return Ok(None) };
        let last = self.candidate.controls.len() - 1;
        let mut tried: Vec<Found> = Vec::new();
        let mut k = FIRST;
        loop {
            let control = self.candidate.controls[k];
            let Some(run) = self.run(control)? else { break };
            budget.spend(run.cost);
            let error = truth.deviation(&run.ends);
            let was_right = tried.iter().any(|found| found.error <= accuracy);
            tried.push(Found { control, error, cost: run.cost, rays: truth.rays });
            let is_right = error <= accuracy;
            // So many settings further one may go, or has to.
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

    /// Tries the setting between the coarsest that is right and the next coarser one, which is not.
    fn halve(&mut self, truth: &Finest, accuracy: f64, tried: &mut Vec<Found>) -> Result<(), RenderError> {
        let right = tried.iter().filter(|found| found.error <= accuracy).min_by(|a, b| a.cost.total_cmp(&b.cost));
        let wrong = tried.iter().filter(|found| found.error > accuracy).max_by(|a, b| a.cost.total_cmp(&b.cost));
        let (Some(right), Some(wrong)) = (right, wrong) else { return Ok(()) };
        let control = wrong.control.between(right.control);
        if let Some(run) = self.run(control)? {
            tried.push(Found { control, error: truth.deviation(&run.ends), cost: run.cost, rays: truth.rays });
        }
        Ok(())
    }

    /// What stands for the truth, after the first run that may.
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

/// What a search may cost, in evaluations.
struct Budget {
    /// Rays of a run.
    rays: f64,
    left: f64,
}

impl Budget {
    /// For a picture of so many rays, by what one of them costs at first.
    fn new(size: [u32; 2], rays: u64, cost: f64) -> Self {
        let own = f64::from(reduced(size).into_iter().product::<u32>());
        Self { rays: own, left: FREE.max(SHARE * rays as f64 * cost) - own * cost }
    }

    fn spend(&mut self, cost: f64) {
        self.left -= self.rays * cost;
    }

    /// Is there enough left for a run of this cost?
    fn allows(&self, cost: f64) -> bool {
        self.rays * cost <= self.left
    }
}

/// What the finer of two runs is off by, in parts of the distance between them, where each such distance is this part of the one
/// before: the sum of all that would follow. Where distances do not shrink they are roundings, of which half is its own.
pub(super) fn remaining(ratio: f64) -> f64 {
    if ratio < 1.0 / 3.0 { ratio / (1.0 - ratio) } else { 0.5 }
}

impl Candidate {
    /// A setting with all of it finer: where a tolerance chooses the steps, their longest too, or it would hide an error of its own.
    fn refined(&self, k: usize) -> Control {
        let control = self.controls[k];
        if control.kind.has_tolerance {
            Control { cap: control.cap * 0.5_f64.powf(k as f64 / STRIDE as f64), ..control }
        } else {
            control
        }
    }
}

/// The picture's size, or a smaller one of about its shape with no more rays than are compared.
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
