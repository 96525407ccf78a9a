//! `method = "auto"`: the cheapest method that is right, found on a few thousand rays before the picture starts.
//!
//! *Theory.* What a method errs by is measured. What it costs is counted, not timed ([`cost`](super::cost)): the evaluations of the
//! law's derivative that its steps take, with what a step costs besides. A busy machine comes to the same choice as an idle one.
//!
//! *Practice.* A search among methods compiles a program for each, and one in 64 bits for the truth: seconds on a CPU. Most pictures
//! take less. [`Preparation`] therefore compiles the picture's own program by the method that is the cheapest for most laws, and finds
//! a setting that is right on the picture's own rays; only a picture that takes long is worth comparing methods.

use std::fmt;

use super::ends::{Settled, compared_layers};
use super::refined::{Found, Trying};
use super::trials::{LOST, MARGIN, TOO_MANY, Trial, Trials, segments};
use super::{fast_methods, usual_method};
use crate::gpu::{Gpu, GpuError};
use crate::model::control::embedded;
use crate::model::method::TOLERANT;
use crate::program::Layer;
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Method, Precision, Scene};

/// A picture is worth a search if it costs more than this: half a minute or more on two CPU cores, where a search takes three seconds.
const WORTH_A_SEARCH: f64 = 4e10;

/// The stage that is reported meanwhile.
pub(super) const SEARCH: &str = "searching for a method";
/// What the true ends of the rays take, in methods that are tried.
const TRUTH: f64 = 2.0;

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
    /// The rays that it was tried on.
    pub rays: Settled,
    /// Was it compared with other methods? If not, because the picture takes less time than that would.
    pub compared: bool,
    /// What the picture has to keep to run what is compiled already.
    pub layers: Vec<Layer>,
}

impl Calibration {
    /// Was what was asked for reached?
    #[must_use]
    pub fn reached(&self) -> bool {
        self.chosen.error <= self.accuracy && !self.rays.is_lacking()
    }

    /// What users should know before they trust the picture: that nothing reaches what they ask for, and what would.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let best = self.chosen.error;
        if self.reached() || !best.is_finite() {
            return None;
        }
        let asked = self.accuracy;
        let Settled { all, unsettled, .. } = self.rays;
        if self.rays.is_lacking() {
            let name = self.chosen.method.kind.name;
            return Some(format!(
                "{unsettled} of the {all} rays tried end elsewhere when {name} takes finer steps; 95 of 100 others are within \
                 {best:.1e} rad"
            ));
        }
        let more = match self.in_double {
            Some(trial) if trial.error <= asked => "; --precision f64 does".to_owned(),
            Some(trial) => format!("; --precision f64 comes to {:.1e}", trial.error),
            None if !self.compared => "; other methods and --precision f64 were not tried".to_owned(),
            None => String::new(),
        };
        let subject = if self.compared {
            "no method brings".to_owned()
        } else {
            format!("{} does not bring", self.chosen.method.kind.name)
        };
        Some(format!("{subject} 99 of 100 rays within {asked:.1e} rad; the best comes to {best:.1e}{more}"))
    }

    /// The scene with the method that was chosen.
    #[must_use]
    pub fn applied(&self, scene: &Scene) -> Scene {
        let mut scene = scene.followed_by(self.chosen.method, self.chosen.control, self.closed_forms);
        scene.rays.max_segments = self.max_segments;
        scene.rays.precision = self.precision;
        scene
    }
}

/// Methods are tried with closed forms in their place; where there are none, the name says as much.
fn closed_forms(scene: &Scene, method: Method) -> bool {
    scene.has_closed_forms() || method.kind.closed_forms
}

/// The rest of a search for the method of a picture: what it needs is compiled.
pub struct Preparation<'a, 's> {
    gpu: &'a Gpu,
    scene: &'s Scene,
    settings: &'s RenderSettings,
    accuracy: f64,
    trying: Option<Trying<'a>>,
}

impl<'a, 's> Preparation<'a, 's> {
    /// Compiles the program of a picture of `scene` by its usual method; none where the scene names one.
    pub fn new(gpu: &'a Gpu, scene: &'s Scene, settings: &'s RenderSettings) -> Result<Option<Self>, RenderError> {
        let Some(accuracy) = scene.accuracy() else { return Ok(None) };
        let wants_double = scene.rays.auto.is_some_and(|auto| auto.precision);
        let candidate = usual_method(scene).filter(|_| !wants_double);
        let trying = candidate
            .map(|candidate| Trying::new(gpu, scene, settings, candidate, (accuracy, segments(scene))))
            .transpose()?
            .flatten();
        Ok(Some(Self { gpu, scene, settings, accuracy, trying }))
    }

    /// Finds the method for a picture with so many rays: a setting of the one that is compiled or, where the picture is worth it or
    /// nothing is, the best of all. What comes back besides is a renderer of the same program, for a scene with this method.
    pub fn choose(self, rays: u64) -> Result<(Option<Calibration>, Option<Renderer<'a>>), RenderError> {
        let Self { gpu, scene, settings, accuracy, trying } = self;
        let stage = gpu.progress.stage(SEARCH);
        let mut own = None;
        if let Some(mut trying) = trying
            && let Some(found) = trying.search(MARGIN * accuracy, rays)?
        {
            let calibration = trusted(scene, settings, accuracy, &trying, found);
            if found.cost * rays as f64 <= WORTH_A_SEARCH {
                return Ok((Some(calibration), Some(trying.renderer)));
            }
            own = Some((calibration, trying.renderer));
        }
        drop(stage);
        let compared = calibrate(gpu, scene, settings, None)?;
        match own {
            Some((calibration, renderer)) if compared.as_ref().is_none_or(|best| !best.compared) => {
                Ok((Some(calibration), Some(renderer)))
            }
            _ => Ok((compared, None)),
        }
    }
}

/// What was found by comparing a method with itself.
fn trusted(scene: &Scene, settings: &RenderSettings, accuracy: f64, trying: &Trying, found: Found) -> Calibration {
    let Found { control, error, cost, rays } = found;
    let method = trying.method();
    let chosen = Trial { method, control, error, cost };
    Calibration {
        rays,
        layers: compared_layers(&settings.choice.layers),
        ..chosen_for(scene, settings, accuracy, chosen)
    }
}

/// Finds the method for a picture of `scene` with so many rays, as [`Preparation`] does.
pub fn calibrate_for(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    rays: u64,
) -> Result<Option<Calibration>, RenderError> {
    match Preparation::new(gpu, scene, settings)? {
        Some(prepared) => Ok(prepared.choose(rays)?.0),
        None => Ok(None),
    }
}

/// Finds the method for `scene` among all, for the camera's rays or for `given` ones.
pub fn calibrate(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    given: Option<&[[f64; 6]]>,
) -> Result<Option<Calibration>, RenderError> {
    let Some(accuracy) = scene.accuracy() else { return Ok(None) };
    let methods = fast_methods(scene);
    let stage = gpu.progress.measured(SEARCH, TRUTH + methods.len() as f64);
    let rays = match Trials::new(gpu, scene, settings, given, accuracy) {
        // Without 64 bits there is no truth to try methods on.
        Err(RenderError::Gpu(GpuError::NoDouble { .. })) => {
            return Ok(Some(chosen_for(scene, settings, accuracy, unjudged())));
        }
        rays => rays?,
    };
    stage.advance(TRUTH);
    let right = |trial: &&Trial| trial.error <= MARGIN * accuracy;
    let mut trials: Vec<Trial> = Vec::new();
    // Where no end is known there is nothing to try methods on.
    let candidates = if rays.truth.is_known() { methods } else { Vec::new() };
    for candidate in candidates {
        let most = trials.iter().filter(right).map(|trial| LOST * trial.cost).fold(TOO_MANY, f64::min);
        trials.push(rays.first_right(&candidate, scene.rays.precision, most)?);
        stage.advance(1.0);
    }
    let cheapest = trials.iter().filter(right).min_by(|a, b| a.cost.total_cmp(&b.cost));
    let best = || trials.iter().min_by(|a, b| a.error.total_cmp(&b.error));
    let chosen = cheapest.or_else(best).filter(|trial| trial.error.is_finite()).copied().unwrap_or_else(unjudged);
    let mut found = Calibration {
        rays: Settled { all: rays.truth.len(), unsettled: 0, endless: rays.truth.unresolved() },
        compared: true,
        ..chosen_for(scene, settings, accuracy, chosen)
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

/// A method that was chosen, compared with no other.
pub(super) fn chosen_for(scene: &Scene, settings: &RenderSettings, accuracy: f64, chosen: Trial) -> Calibration {
    Calibration {
        accuracy,
        chosen,
        max_segments: segments(scene),
        closed_forms: closed_forms(scene, chosen.method),
        precision: scene.rays.precision,
        in_double: None,
        rays: Settled::default(),
        compared: false,
        layers: settings.choice.layers.clone(),
    }
}

/// What is taken where no method can be judged.
pub(super) fn unjudged() -> Trial {
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
        if !self.compared && self.chosen.error.is_finite() {
            write!(f, "; other methods were not tried")?;
        }
        if !self.reached() && self.chosen.error.is_finite() {
            let subject = if self.compared { "no method reaches" } else { "it does not reach" };
            write!(f, "; {subject} the accuracy asked for, {:.1e} rad: this is the best", self.accuracy)?;
        }
        if let Some(trial) = &self.in_double {
            write!(f, "; in 64 bits, by --precision auto, {trial}")?;
        }
        let Settled { all, unsettled, endless } = self.rays;
        if self.rays.is_lacking() {
            write!(f, "; {unsettled} of the {all} rays tried end elsewhere with finer steps")?;
        }
        if endless > 0 {
            write!(f, "; {endless} of the {all} rays tried have no end that could be known in full")?;
        }
        Ok(())
    }
}
