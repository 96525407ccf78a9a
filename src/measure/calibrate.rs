//! The search of `method = "auto"` for the cheapest accurate method, on a few thousand rays before the render starts.
//!
//! *Theory.* The error of a method is measured. Its cost is counted instead of timed ([`cost`](super::cost)): the derivative evaluations of
//! its steps, and the overhead of each step. A busy machine therefore makes the same choice as an idle one.
//!
//! *Practice.* A search among methods compiles a program for each, and one in 64 bits for the reference solution, which takes seconds on a
//! CPU. Most images take less. [`Preparation`] therefore compiles the image's program with the method that is the cheapest for most laws,
//! and finds an accurate setting on the image's rays. If no setting is accurate, it tries the method for a tolerance. It compares all methods
//! only for expensive images.

use std::fmt;

use super::ends::{Settled, compared_layers};
use super::methods::next_method;
use super::refined::{Refinement, Trying};
use super::trials::{LOST, MARGIN, TOO_MANY, Trial, Trials, segments};
use super::{Judged, fast_methods, usual_method};
use crate::gpu::{Gpu, GpuError};
use crate::model::control::embedded;
use crate::model::method::TOLERANT;
use crate::program::Layer;
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Method, Precision, Scene};

/// The cost above which a search is worthwhile: half a minute or more on two CPU cores, where a search takes three seconds.
const WORTH_A_SEARCH: f64 = 4e10;

/// The name of the stage in progress reports.
pub(super) const SEARCH: &str = "searching for a method";
/// The cost of the reference solution, in units of one tried method.
const TRUTH: f64 = 2.0;

/// The result of a calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// The required error.
    pub accuracy: f64,
    /// The cheapest accurate trial or, if none is accurate, the most accurate one.
    pub chosen: Trial,
    /// The largest number of segments of a path; more than in the scene, whose value suits any method.
    pub max_segments: u32,
    /// Is `true` if closed forms replace the method where they exist; the method's default if there are none.
    pub closed_forms: bool,
    /// The precision.
    pub precision: Precision,
    /// The trial in 64 bits, if the best method misses the required error in 32 and the device supports 64.
    pub in_double: Option<Trial>,
    /// The states of the rays on which methods were tried.
    pub rays: Settled,
    /// Is `true` if other methods were compared; otherwise the image takes less time than a comparison.
    pub compared: bool,
    /// The layers that the image must store so that the compiled program can be used.
    pub layers: Vec<Layer>,
}

impl Calibration {
    /// Returns `true` if the required error was reached.
    #[must_use]
    pub fn reached(&self) -> bool {
        self.chosen.error <= self.accuracy && !self.rays.is_lacking()
    }

    /// Returns a warning if no setting reaches the required error, with a remedy.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let best = self.chosen.error;
        if self.reached() || !best.is_finite() {
            return None;
        }
        let (asked, unit) = (self.accuracy, self.chosen.judged.unit());
        let Settled { all, unsettled, .. } = self.rays;
        if self.rays.is_lacking() {
            let name = self.chosen.method.kind.name;
            return Some(format!(
                "{unsettled} of {all} test rays end elsewhere when {name} takes finer steps; 95 % of the others are \
                 within {best:.1e} {unit}"
            ));
        }
        let more = match self.in_double {
            Some(trial) if trial.error <= asked => "; --precision f64 is accurate enough".to_owned(),
            Some(trial) => format!("; --precision f64 reaches {:.1e} {unit}", trial.error),
            None if !self.compared => "; not all methods were tried, nor --precision f64".to_owned(),
            None => String::new(),
        };
        let subject = if self.compared {
            "no method keeps".to_owned()
        } else {
            format!("{} does not keep", self.chosen.method.kind.name)
        };
        Some(format!("{subject} 99 % of the rays within {asked:.1e} {unit}; the best error is {best:.1e} {unit}{more}"))
    }

    /// Returns the scene with the chosen method.
    #[must_use]
    pub fn applied(&self, scene: &Scene) -> Scene {
        let mut scene = scene.followed_by(self.chosen.method, self.chosen.control, self.closed_forms);
        scene.rays.max_segments = self.max_segments;
        scene.rays.precision = self.precision;
        scene
    }
}

/// Returns `true` if the trials used closed forms; without closed forms, the method's default.
fn closed_forms(scene: &Scene, method: Method) -> bool {
    scene.has_closed_forms() || method.kind.closed_forms
}

/// The remaining work of a search for an image's method, with its compiled program.
pub struct Preparation<'a, 's> {
    gpu: &'a Gpu,
    scene: &'s Scene,
    settings: &'s RenderSettings,
    accuracy: f64,
    trying: Option<Trying<'a>>,
}

impl<'a, 's> Preparation<'a, 's> {
    /// Compiles the program of an image of `scene` with its usual method; returns `None` if the scene specifies a method.
    ///
    /// # Errors
    ///
    /// Returns an error if the program cannot be compiled, or the device fails.
    pub fn new(gpu: &'a Gpu, scene: &'s Scene, settings: &'s RenderSettings) -> Result<Option<Self>, RenderError> {
        let Some(accuracy) = Judged::of_image(scene).accuracy(scene) else { return Ok(None) };
        let wants_double = scene.rays.auto.is_some_and(|auto| auto.precision);
        let candidate = usual_method(scene).filter(|_| !wants_double);
        let trying = candidate
            .map(|candidate| Trying::new(gpu, scene, settings, candidate, (accuracy, segments(scene))))
            .transpose()?
            .flatten();
        Ok(Some(Self { gpu, scene, settings, accuracy, trying }))
    }

    /// Finds the method for an image with this number of rays: a setting of the compiled method or, if the image is expensive or no setting
    /// is accurate, the best of all. Also returns a renderer of the compiled program for a scene with this method.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or cannot run a program.
    pub fn choose(self, rays: u64) -> Result<(Option<Calibration>, Option<Renderer<'a>>), RenderError> {
        let Self { gpu, scene, settings, accuracy, trying } = self;
        let stage = gpu.progress.stage(SEARCH);
        let mut own = None;
        if let Some(mut trying) = trying
            && let Some(mut found) = trying.search(MARGIN * accuracy, rays)?
        {
            if !found.suffices(accuracy)
                && let Some(next) = next_method(scene, trying.method())
                && let Some(mut next) = Trying::new(gpu, scene, settings, next, (accuracy, segments(scene)))?
                && let Some(better) = next.search(MARGIN * accuracy, rays)?.filter(|next| next.is_better(&found))
            {
                (trying, found) = (next, better);
            }
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

/// Returns the calibration of a method that was compared only with finer settings.
fn trusted(scene: &Scene, settings: &RenderSettings, accuracy: f64, trying: &Trying, found: Refinement) -> Calibration {
    let Refinement { control, error, cost, rays } = found;
    let method = trying.method();
    let chosen = Trial { method, control, judged: Judged::of_image(scene), error, cost };
    Calibration {
        rays,
        layers: compared_layers(scene, &settings.options.layers),
        ..chosen_for(scene, settings, accuracy, chosen)
    }
}

/// Finds the method for an image of `scene` with this number of rays, as [`Preparation`] does.
///
/// # Errors
///
/// Returns an error if the scene has no camera, a program cannot be compiled, or the device fails.
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

/// Finds the method for `scene` among all methods, for the camera's rays or for `given` ones; returns `None` if the scene specifies a
/// method.
///
/// [`Calibration::applied`] returns the scene with the method that was found. Without 64 bits on any device, it is the default method.
///
/// # Errors
///
/// Returns [`RenderError::NoCamera`] if neither the scene nor `given` defines rays, and another error if a program cannot be compiled or
/// the device fails.
///
/// # Examples
///
/// ```no_run
/// use bentray::{gpu::Gpu, measure::calibrate, render::RenderSettings, scene::Scene};
///
/// let (gpu, settings) = (Gpu::open(None)?, RenderSettings::default());
/// let mut scene = Scene::load("scenes/black_hole.toml".as_ref(), &["rays.method=auto".parse()?])?;
/// if let Some(found) = calibrate(&gpu, &scene, &settings, None)? {
///     println!("{found}");
///     scene = found.applied(&scene);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn calibrate(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    given: Option<&[[f64; 6]]>,
) -> Result<Option<Calibration>, RenderError> {
    let judged = Judged::of_image(scene);
    let Some(accuracy) = judged.accuracy(scene) else { return Ok(None) };
    let methods = fast_methods(scene);
    let stage = gpu.progress.measured(SEARCH, TRUTH + methods.len() as f64);
    let rays = match Trials::new(gpu, scene, settings, given, (judged, accuracy)) {
        // Without 64 bits there is no reference solution.
        Err(RenderError::Gpu(GpuError::NoDouble { .. })) => {
            return Ok(Some(chosen_for(scene, settings, accuracy, unjudged())));
        }
        rays => rays?,
    };
    stage.advance(TRUTH);
    let right = |trial: &&Trial| trial.error <= MARGIN * accuracy;
    let mut trials: Vec<Trial> = Vec::new();
    // Without known ends there is nothing to compare methods with.
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

/// Returns the calibration of a method that was not compared with others.
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
        layers: settings.options.layers.clone(),
    }
}

/// Returns the default if no method can be judged.
pub(super) fn unjudged() -> Trial {
    Trial {
        method: TOLERANT,
        control: embedded::with(1e-5, 0.3),
        judged: Judged::Ends,
        error: f64::INFINITY,
        cost: f64::INFINITY,
    }
}

impl fmt::Display for Calibration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "method auto: {}, max_segments {}", self.chosen, self.max_segments)?;
        if self.closed_forms != self.chosen.method.kind.closed_forms {
            write!(f, ", closed_forms {}", self.closed_forms)?;
        }
        if self.precision == Precision::Double {
            write!(f, ", precision {}", self.precision.name())?;
        }
        if !self.compared && self.chosen.error.is_finite() {
            write!(f, "; not all methods were tried")?;
        }
        if !self.reached() && self.chosen.error.is_finite() {
            let subject = if self.compared { "no method reaches" } else { "it does not reach" };
            write!(f, "; {subject} the requested accuracy of {:.1e} {}", self.accuracy, self.chosen.judged.unit())?;
        }
        if let Some(trial) = &self.in_double {
            write!(f, "; --precision auto would use 64 bits and {trial}")?;
        }
        let Settled { all, unsettled, endless } = self.rays;
        if self.rays.is_lacking() {
            write!(f, "; {unsettled} of {all} test rays end elsewhere with finer steps")?;
        }
        if endless > 0 {
            write!(f, "; {endless} of {all} test rays have an unresolved end")?;
        }
        Ok(())
    }
}
