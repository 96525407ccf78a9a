//! Trials of methods on a few thousand rays with known ends.

use std::cmp::Ordering;
use std::fmt;

use super::{Candidate, ErrorStats, Judged, ReferenceSolution, cost, fast_methods, method_words, scattered};
use crate::gpu::Gpu;
use crate::model::method::TOLERANT;
use crate::render::{RenderError, RenderSettings, Starts, Traced, Tracer};
use crate::scene::{Control, Method, Precision, Scene};

/// The number of rays whose error is measured.
const RAYS: usize = 4000;
const REFINEMENTS: usize = 2;
/// The fraction of the required error that trials must meet, because the image has other rays.
pub(super) const MARGIN: f64 = 0.9;
/// The largest number of segments of a path, as a multiple of the scene's, for every method.
const MORE_SEGMENTS: u32 = 4;
/// The multiple of the cheapest accurate cost, in total or per ray, above which a setting is dropped.
pub(super) const LOST: f64 = 4.0;
pub(super) const TOO_MANY: f64 = 4e5;

/// A method at a setting, with its error and cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// The method.
    pub method: Method,
    /// The setting.
    pub control: Control,
    /// The measure of the error.
    pub judged: Judged,
    /// The error bound of 99 of 100 rays; infinite if unknown.
    pub error: f64,
    /// The cost of a ray, in evaluations of a simple derivative (see [`cost`]); not finite if unknown.
    pub cost: f64,
}

/// Returns the segment limit of a scene with `method = "auto"`, which suits any method.
pub(super) fn segments(scene: &Scene) -> u32 {
    scene.rays.max_segments.saturating_mul(MORE_SEGMENTS)
}

/// The rays on which methods are tried.
pub(super) struct Trials<'a> {
    gpu: &'a Gpu,
    scene: &'a Scene,
    settings: RenderSettings,
    given: Option<Vec<[f64; 6]>>,
    pixels: Vec<[u32; 2]>,
    pub truth: ReferenceSolution,
    judged: Judged,
    accuracy: f64,
}

impl<'a> Trials<'a> {
    pub fn new(
        gpu: &'a Gpu,
        scene: &'a Scene,
        settings: &RenderSettings,
        given: Option<&[[f64; 6]]>,
        (judged, accuracy): (Judged, f64),
    ) -> Result<Self, RenderError> {
        let tolerance = (1e-3 * accuracy).min(1e-10);
        let pixels = scattered(scene.image.size, RAYS, 1);
        let given =
            given.map(|rays| rays.iter().step_by(rays.len().div_ceil(RAYS).max(1)).copied().collect::<Vec<_>>());
        let starts = given.as_deref().map_or(Starts::Pixels(&pixels, 1024), Starts::Given);
        let truth = ReferenceSolution::new(gpu, scene, tolerance, starts)?;
        Ok(Self { gpu, scene, settings: settings.clone(), given, pixels, truth, judged, accuracy })
    }

    fn starts(&self) -> Starts<'_> {
        self.given.as_deref().map_or(Starts::Pixels(&self.pixels, 1024), Starts::Given)
    }

    /// Returns `true` if 64 bits may reach an error that 32 do not; not if more ends are unknown than may be wrong.
    pub fn more_bits_help(&self) -> bool {
        let known = self.truth.len() - self.truth.unresolved();
        self.gpu.f64 && self.scene.rays.precision == Precision::Single && 100 * known >= 99 * self.truth.len()
    }

    /// Returns the cheaper of the best and the usual method, in 64 bits, or `None` if neither is better than `best`.
    pub fn in_double(&self, best: &Trial) -> Result<Option<Trial>, RenderError> {
        let mut all = fast_methods(self.scene);
        all.retain(|candidate| [best.method, TOLERANT].contains(&candidate.method));
        let tried = all.iter().map(|candidate| self.first_right(candidate, Precision::Double, TOO_MANY));
        let mut better = tried.collect::<Result<Vec<_>, _>>()?;
        better.retain(|trial| trial.error < best.error);
        let rank = |trial: &Trial| (trial.error > self.accuracy, trial.cost);
        Ok(better.into_iter().min_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(Ordering::Equal)))
    }

    /// Returns the coarsest accurate setting, or the most accurate of those that cost at most `most` evaluations per ray.
    pub fn first_right(&self, candidate: &Candidate, precision: Precision, most: f64) -> Result<Trial, RenderError> {
        let (method, control) = (candidate.method, candidate.controls[0]);
        let mut scene = candidate.applied(self.scene, control);
        scene.rays.precision = precision;
        scene.rays.max_segments = segments(self.scene);
        // For few rays, the number of passes matters more than the number of running rays.
        let settings = RenderSettings { segments: 256, ..self.settings.clone() };
        let mut tracer = Tracer::new(self.gpu, &scene, settings, self.starts().mode())?;
        let mut tried = |control| -> Result<Trial, RenderError> {
            tracer.retune(control, scene.rays.max_segments)?;
            let (rays, _) = tracer.follow(self.starts())?;
            let found = ErrorStats::new(&rays, tracer.spectra(), &self.truth);
            let mut error = found.judged(self.judged).sure99;
            // The ends of given rays are results too, not only their light.
            if let (Some(_), Some(accuracy)) = (&self.given, Judged::Ends.accuracy(self.scene)) {
                error = error.max(found.seen.sure99 * self.accuracy / accuracy);
            }
            let mean = |count: fn(&Traced) -> u32| {
                rays.iter().map(|ray| f64::from(count(ray))).sum::<f64>() / rays.len().max(1) as f64
            };
            let cost = cost(self.scene, method, control, mean(|ray| ray.steps), mean(|ray| ray.rejected));
            Ok(Trial { method, control, judged: self.judged, error, cost })
        };
        let is_right = |trial: &Trial| trial.error <= MARGIN * self.accuracy;
        let mut best = Trial { method, control, judged: self.judged, error: f64::INFINITY, cost: f64::INFINITY };
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
        // The longest accurate step is between the last inaccurate setting and the first accurate one.
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
        let mut words = method_words(self.method, self.control);
        if let Some((name, settings)) = words.split_once(", ") {
            words = format!("{name} ({settings})");
        }
        if !self.error.is_finite() {
            return write!(f, "{words}, the default because no method can be measured");
        }
        let within = if self.error == 0.0 {
            "equal to the reference solution".to_owned()
        } else {
            format!("within {:.1e} {}", self.error, self.judged.unit())
        };
        write!(f, "{words}, 99 % of the rays {within}")?;
        if self.cost.is_finite() { write!(f, ", about {:.0} evaluations per ray", self.cost) } else { Ok(()) }
    }
}
