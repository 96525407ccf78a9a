//! `method = "auto"`: the cheapest method that is right, found on a few thousand rays before the picture starts.
//!
//! *Theory.* What a method errs by is measured. What it costs is counted, not timed ([`cost`]): the evaluations of the law's
//! derivative that its steps take, with what a step costs besides. A busy machine comes to the same choice as an idle one.
//!
//! *Practice.* A search among methods compiles a program for each, and one in 64 bits for the truth: seconds on a CPU. A picture that
//! takes less is not worth it: [`calibrate_for`] then stays with the method that is the cheapest for most laws, at a setting that is
//! right on the picture's own rays, and says so.

use std::fmt;

use super::fast_methods;
use super::refined::{self, Found};
use super::trials::{LOST, MARGIN, TOO_MANY, Trial, Trials, segments};
use crate::gpu::Gpu;
use crate::model::control::embedded;
use crate::model::method::TOLERANT;
use crate::program::{Choice, Layer};
use crate::render::{RenderError, RenderSettings};
use crate::scene::{Method, Precision, Scene};

/// A picture is worth a search if it costs more than this: half a minute or more on two CPU cores, where a search takes about three
/// seconds.
const WORTH_A_SEARCH: f64 = 6e10;

/// What a calibration found.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// The error asked for, in radians.
    pub accuracy: f64,
    /// The cheapest that is right; or, if none is, the most accurate.
    pub chosen: Trial,
    /// Segments that a path may have, more than the scene says: that is meant for any method.
    pub max_segments: u32,
    /// Do closed forms stand for the method where there are some? As its name alone has it, where there are none.
    pub closed_forms: bool,
    /// Bits of the numbers.
    pub precision: Precision,
    /// What 64 bits would reach, where the best method does not reach what is asked for in 32 and the device has them.
    pub in_double: Option<Trial>,
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

    /// What users should know before they trust the picture: that nothing reaches what they ask for, and what would.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        if self.reached() || !self.chosen.error.is_finite() {
            return None;
        }
        let more = match self.in_double {
            Some(trial) if trial.error <= self.accuracy => "; --precision f64 does".to_owned(),
            Some(trial) => format!("; --precision f64 comes to {:.1e}", trial.error),
            None => String::new(),
        };
        let [asked, best] = [self.accuracy, self.chosen.error];
        Some(format!("no method brings 99 of 100 rays within {asked:.1e} rad; the best comes to {best:.1e}{more}"))
    }

    /// The scene with the method that was chosen.
    #[must_use]
    pub fn applied(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.rays.auto = None;
        scene.rays.method = self.chosen.method;
        scene.rays.control = self.chosen.control;
        scene.rays.max_segments = self.max_segments;
        scene.rays.precision = self.precision;
        scene.rays.closed_forms = self.closed_forms;
        scene
    }
}

/// Methods are tried with closed forms in their place; where there are none, the name says as much.
fn closed_forms(scene: &Scene, method: Method) -> bool {
    scene.has_closed_forms() || method.kind.closed_forms
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
        let layers = refined::compared_layers(&settings.choice.layers);
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
                closed_forms: closed_forms(scene, method.method),
                precision: scene.rays.precision,
                in_double: None,
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
        trials.push(rays.first_right(&candidate, scene.rays.precision, most)?);
    }
    let cheapest = trials.iter().filter(right).min_by(|a, b| a.cost.total_cmp(&b.cost));
    let best = || trials.iter().min_by(|a, b| a.error.total_cmp(&b.error));
    let chosen = cheapest.or_else(best).filter(|trial| trial.error.is_finite()).copied().unwrap_or_else(unjudged);
    let mut found = Calibration {
        accuracy,
        chosen,
        max_segments: segments(scene),
        closed_forms: closed_forms(scene, chosen.method),
        precision: scene.rays.precision,
        in_double: None,
        unresolved: rays.truth.unresolved(),
        compared: true,
        layers: settings.choice.layers.clone(),
    };
    if !found.reached() && rays.more_bits_help() {
        found.in_double = rays.in_double(&found.chosen)?;
    }
    if let (Some(trial), true) = (found.in_double, scene.rays.auto.is_some_and(|auto| auto.precision)) {
        (found.chosen, found.precision, found.in_double) = (trial, Precision::Double, None);
        found.closed_forms = closed_forms(scene, trial.method);
    }
    Ok(Some(found))
}

/// What is taken where no method can be judged.
fn unjudged() -> Trial {
    Trial { method: TOLERANT, control: embedded::with(1e-5, 0.3), error: f64::INFINITY, cost: f64::INFINITY }
}

impl fmt::Display for Calibration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "auto: {}, max_segments {}", self.chosen, self.max_segments)?;
        if self.closed_forms != self.chosen.method.kind.closed_forms {
            write!(f, ", closed_forms {}", self.closed_forms)?;
        }
        if self.precision == Precision::Double {
            write!(f, ", precision {}", self.precision.name())?;
        }
        if !self.compared {
            write!(f, "; not compared with other methods, which takes longer than the picture")?;
        }
        if !self.reached() && self.chosen.error.is_finite() {
            write!(f, "; no method reaches the accuracy asked for, {:.1e} rad: this is the best", self.accuracy)?;
        }
        if let Some(trial) = &self.in_double {
            write!(f, "; in 64 bits, by --precision auto, {trial}")?;
        }
        if self.unresolved > 0 {
            write!(f, "; {} of the rays tried have no end that could be known", self.unresolved)?;
        }
        Ok(())
    }
}
