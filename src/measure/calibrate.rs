//! `method = "auto"`: the cheapest method that is right, found on a few thousand rays before the picture starts.
//!
//! *Theory.* What a method errs by is measured. What it costs is counted, not timed ([`cost`]): the evaluations of the law's
//! derivative that its steps take, with what a step costs besides. A busy machine comes to the same choice as an idle one.
//!
//! *Practice.* A search among methods compiles a program for each, and one in 64 bits for the truth: seconds on a CPU. A picture that
//! takes less is not worth it: [`calibrate_for`] then stays with the method that is the cheapest for most laws, at a setting that is
//! right on the picture's own rays, and says so.

use std::fmt;

use super::refined::{self, Found};
use super::{Candidate, Deviations, Truth, cost, fast_methods, method_words, scattered};
use crate::gpu::Gpu;
use crate::model::control::embedded;
use crate::model::method::TOLERANT;
use crate::program::{Choice, Layer, Purpose};
use crate::render::{RenderError, RenderSettings, Renderer, Starts, Traced};
use crate::scene::{Control, Method, Scene};

/// Rays whose error is measured.
const RAYS: usize = 4000;
const REFINEMENTS: usize = 2;
/// What is asked for is met with so much to spare, because the picture has other rays than those that were tried.
const MARGIN: f64 = 0.9;
/// So many times the scene's own segments may a path have, whatever the method.
const MORE_SEGMENTS: u32 = 4;
/// A picture is worth a search if it costs more than this: half a minute or more on two CPU cores, where a search takes about three
/// seconds.
const WORTH_A_SEARCH: f64 = 6e10;
/// What costs so many times the cheapest that is right has lost, as has what costs so much a ray.
const LOST: f64 = 4.0;
const TOO_MANY: f64 = 4e5;

/// A method at a setting, with its error and cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// The method.
    pub method: Method,
    /// The setting.
    pub control: Control,
    /// 99 of 100 rays err by no more, in radians; infinite where that is not known.
    pub error: f64,
    /// What a ray costs, in evaluations of a simple derivative: see [`cost`].
    pub cost: f64,
}

/// What a calibration found.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// The error asked for, in radians.
    pub accuracy: f64,
    /// The cheapest that is right; or, if none is, the most accurate.
    pub chosen: Trial,
    /// Segments that a path may have, more than the scene says: that is meant for any method.
    pub max_segments: u32,
    /// Rays whose truth no method can know.
    pub unresolved: usize,
    /// Was it compared with other methods? If not, because the picture takes less time than that would.
    pub compared: bool,
    /// What the picture has to keep to run what is compiled already.
    pub layers: Vec<Layer>,
}

impl Calibration {
    /// Was what was asked for reached?
    #[must_use]
    pub fn reached(&self) -> bool {
        self.chosen.error <= self.accuracy
    }

    /// The scene with the method that was chosen.
    #[must_use]
    pub fn applied(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.rays.auto = None;
        scene.rays.method = self.chosen.method;
        scene.rays.control = self.chosen.control;
        scene.rays.max_segments = self.max_segments;
        scene
    }
}

/// An auto scene's budget of segments is meant for any method.
fn segments(scene: &Scene) -> u32 {
    scene.rays.max_segments.saturating_mul(MORE_SEGMENTS)
}

/// Finds the method for a picture of `scene` with so many rays: among all if that is worth its time, else the first that is right.
pub fn calibrate_for(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: u64,
) -> Result<Option<Calibration>, RenderError> {
    let Some(accuracy) = scene.accuracy() else { return Ok(None) };
    let methods = fast_methods(scene);
    if let Some(method) = methods.first() {
        let mut layers = settings.choice.layers.clone();
        layers.extend(refined::LAYERS.into_iter().filter(|layer| !settings.choice.layers.contains(layer)));
        let choice = Choice { layers: layers.clone(), ..settings.choice.clone() };
        let keeping = RenderSettings { choice, ..settings.clone() };
        let found = refined::first_right(gpu, scene, &keeping, method, segments(scene), MARGIN * accuracy)?;
        if let Some(Found { control, error, cost }) = found
            && cost * rays as f64 <= WORTH_A_SEARCH
        {
            let chosen = Trial { method: method.method, control, error, cost };
            return Ok(Some(Calibration {
                accuracy,
                chosen,
                max_segments: segments(scene),
                unresolved: 0,
                compared: false,
                layers,
            }));
        }
    }
    calibrate(gpu, scene, settings, None)
}

/// Finds the method for `scene` among all, for the camera's rays or for `given` ones.
pub fn calibrate(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    given: Option<&[[f64; 6]]>,
) -> Result<Option<Calibration>, RenderError> {
    let Some(accuracy) = scene.accuracy() else { return Ok(None) };
    let rays = Trials::new(gpu, scene, settings, given, accuracy)?;
    let right = |trial: &&Trial| trial.error <= MARGIN * accuracy;
    let mut trials: Vec<Trial> = Vec::new();
    // Where no end is known there is nothing to try methods on.
    let candidates = if rays.truth.is_known() { fast_methods(scene) } else { Vec::new() };
    for candidate in candidates {
        let most = trials.iter().filter(right).map(|trial| LOST * trial.cost).fold(TOO_MANY, f64::min);
        trials.push(rays.first_right(&candidate, most)?);
    }
    let cheapest = trials.iter().filter(right).min_by(|a, b| a.cost.total_cmp(&b.cost));
    let best = || trials.iter().min_by(|a, b| a.error.total_cmp(&b.error));
    let chosen = cheapest.or_else(best).filter(|trial| trial.error.is_finite()).copied().unwrap_or_else(unjudged);
    let (unresolved, layers) = (rays.truth.unresolved(), settings.choice.layers.clone());
    Ok(Some(Calibration { accuracy, chosen, max_segments: segments(scene), unresolved, compared: true, layers }))
}

/// What is taken where no method can be judged.
fn unjudged() -> Trial {
    Trial { method: TOLERANT, control: embedded::with(1e-5, 0.3), error: f64::INFINITY, cost: f64::INFINITY }
}

/// The rays that methods are tried on.
struct Trials<'a> {
    gpu: &'a Gpu,
    scene: &'a Scene,
    settings: RenderSettings,
    given: Option<Vec<[f64; 6]>>,
    pixels: Vec<[u32; 2]>,
    truth: Truth,
    accuracy: f64,
}

impl<'a> Trials<'a> {
    fn new(
        gpu: &'a Gpu,
        scene: &'a Scene,
        settings: &RenderSettings,
        given: Option<&[[f64; 6]]>,
        accuracy: f64,
    ) -> Result<Self, RenderError> {
        let tolerance = (1e-3 * accuracy).min(1e-10);
        let purpose = if given.is_some() { Purpose::Trace } else { Purpose::Pixels };
        let choice = Choice { purpose, layers: Vec::new(), ..settings.choice.clone() };
        let settings = RenderSettings { choice, ..settings.clone() };
        let pixels = scattered(scene.image.size, RAYS, 1);
        let given =
            given.map(|rays| rays.iter().step_by(rays.len().div_ceil(RAYS).max(1)).copied().collect::<Vec<_>>());
        let starts = given.as_deref().map_or(Starts::Pixels(&pixels, 1024), Starts::Given);
        let truth = Truth::new(gpu, scene, tolerance, starts)?;
        Ok(Self { gpu, scene, settings, given, pixels, truth, accuracy })
    }

    fn starts(&self) -> Starts<'_> {
        self.given.as_deref().map_or(Starts::Pixels(&self.pixels, 1024), Starts::Given)
    }

    /// The coarsest setting that is right, or the most accurate of those that cost no more than `most` evaluations a ray.
    fn first_right(&self, candidate: &Candidate, most: f64) -> Result<Trial, RenderError> {
        let (method, control) = (candidate.method, candidate.controls[0]);
        let mut scene = candidate.applied(self.scene, control);
        scene.rays.max_segments = segments(self.scene);
        // Few rays: what counts is not how many run but how many passes are recorded.
        let settings = RenderSettings { segments: 256, ..self.settings.clone() };
        let mut renderer = Renderer::new(self.gpu, &scene, settings)?;
        let mut tried = |control| -> Result<Trial, RenderError> {
            renderer.retune(control, scene.rays.max_segments)?;
            let (rays, _) = renderer.follow(self.starts())?;
            let error = Deviations::new(&rays, &self.truth).seen.sure99;
            let mean = |count: fn(&Traced) -> u32| {
                rays.iter().map(|ray| f64::from(count(ray))).sum::<f64>() / rays.len().max(1) as f64
            };
            let cost = cost(self.scene, method, control, mean(|ray| ray.steps), mean(|ray| ray.rejected));
            Ok(Trial { method, control, error, cost })
        };
        let is_right = |trial: &Trial| trial.error <= MARGIN * self.accuracy;
        let mut best = Trial { method, control, error: f64::INFINITY, cost: f64::INFINITY };
        let mut wrong = None;
        for &control in &candidate.controls {
            let trial = tried(control)?;
            if trial.error < best.error || best.cost.is_infinite() {
                best = trial;
            }
            if is_right(&trial) || trial.cost > most {
                break;
            }
            wrong = Some(control);
        }
        // Steps as long as they may be lie between the last that was wrong and the first that was right.
        for _ in 0..REFINEMENTS {
            let (Some(coarse), true) = (wrong, is_right(&best)) else { break };
            let trial = tried(coarse.between(best.control))?;
            if is_right(&trial) {
                best = trial;
            } else {
                wrong = Some(trial.control);
            }
        }
        Ok(best)
    }
}

impl fmt::Display for Trial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = method_words(self.method, self.control);
        if self.error.is_infinite() {
            return write!(f, "{words}: the rule where no method can be judged");
        }
        write!(f, "{words}: 99 % within {:.1e} rad, {:.0} evaluations' cost a ray", self.error, self.cost)
    }
}

impl fmt::Display for Calibration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "auto: {}, max_segments {}", self.chosen, self.max_segments)?;
        if !self.compared {
            write!(f, "; not compared with other methods, which takes longer than the picture")?;
        }
        if !self.reached() && self.chosen.error.is_finite() {
            write!(f, "; no method reaches the accuracy asked for, {:.1e} rad: this is the best", self.accuracy)?;
        }
        if self.unresolved > 0 {
            write!(f, "; {} of the rays tried have no end that could be known", self.unresolved)?;
        }
        Ok(())
    }
}
