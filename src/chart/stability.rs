//! The outcomes of rays in situations where methods fail.
//!
//! *Theory.* An error of which the user is warned does no harm. Each ray is therefore followed by the method with its default setting and
//! with two finer settings, which is possible without a reference solution; then the outcomes are compared with the reference. A ray is
//! *right*; *flagged*, because it ended early (exhausted, stalled, not finite), because it accepted and counted steps over its tolerance,
//! or because the settings disagree; *unresolved*, if 64 bits cannot determine its end; or *silent*, which means wrong without a warning.
//!
//! *Practice.* Starting values are first rounded to 32 bits, because their rounding is not the method's error.

use crate::gpu::Gpu;
use crate::measure::{Candidate, ReferenceSolution, all_methods};
use crate::program::Mode;
use crate::render::{RenderError, RenderSettings, Starts, Status, Traced, Tracer};
use crate::scene::{Control, Scene};

/// The error up to which directions (radians), speeds (relative) and positions (relative to the bounding radius) are right.
const RIGHT: f64 = 1e-3;
/// The largest difference between agreeing settings, relative to `RIGHT`: halving the steps of a method of order 1 reveals half of its
/// error, and the rest is margin.
const AGREES: f64 = 0.25;
const TOLERANCE: f64 = 1e-13;
/// The largest number of segments of a path.
const SEGMENTS: u32 = 40_000;

/// The outcomes of a situation's rays with one method.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Outcome {
    /// The situation.
    pub place: String,
    /// The method.
    pub method: &'static str,
    /// The number of rays with correct ends.
    pub right: usize,
    /// The number of rays that ended early: exhausted, stalled or not finite.
    pub given_up: usize,
    /// The number of rays with accepted and counted steps over the tolerance, as by the rule of W04.
    pub over: usize,
    /// The number of rays whose ends differ between settings.
    pub disagreeing: usize,
    /// The number of rays whose true end is unknown.
    pub unresolved: usize,
    /// The number of rays that are wrong without a warning.
    pub silent: usize,
    /// The τ up to which all rays of a flow were right; `None` for other laws.
    pub diverged: Option<f64>,
}

/// Returns the settings to compare: the default one, and two finer ones. If the cap limits steps, a smaller tolerance alone has no
/// effect, so that the cap is also reduced.
#[must_use]
pub fn default_settings(candidate: &Candidate) -> [Control; 3] {
    let control = candidate.controls[0];
    [0, 1, 2].map(|fine| (control.kind.usual)(&control, fine))
}

/// A situation in which methods fail: a scene, and rays in it.
#[derive(Debug)]
pub struct StabilityCase<'a> {
    gpu: &'a Gpu,
    name: String,
    scene: Scene,
    rays: Vec<[f64; 6]>,
    truth: ReferenceSolution,
}

impl<'a> StabilityCase<'a> {
    /// Computes the reference solutions of the rays.
    ///
    /// # Errors
    ///
    /// Returns an error if no device supports 64 bits, or the device fails.
    pub fn new(gpu: &'a Gpu, name: &str, scene: &Scene, rays: &[[f64; 6]]) -> Result<Self, RenderError> {
        let mut scene = scene.clone();
        scene.rays.max_segments = SEGMENTS;
        let rays: Vec<_> = rays.iter().map(|ray| ray.map(|v| f64::from(v as f32))).collect();
        let truth = ReferenceSolution::new(gpu, &scene, TOLERANCE, Starts::Given(&rays))?;
        Ok(Self { gpu, name: name.to_owned(), scene, rays, truth })
    }

    /// Returns the outcomes of the rays with every method that the law allows, or with the given ones.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or cannot run a program.
    pub fn outcomes(&self, only: Option<&[&str]>) -> Result<Vec<Outcome>, RenderError> {
        let methods = all_methods(&self.scene);
        let wanted = methods.iter().filter(|method| only.is_none_or(|only| only.contains(&method.name)));
        wanted.map(|candidate| self.outcome(candidate, default_settings(candidate))).collect()
    }

    /// Returns the outcome of one method at three settings.
    ///
    /// # Errors
    ///
    /// Returns an error if the device fails or cannot run the program.
    pub fn outcome(&self, candidate: &Candidate, settings: [Control; 3]) -> Result<Outcome, RenderError> {
        let scene = candidate.applied(&self.scene, settings[0]);
        let few = RenderSettings { segments: 256, ..RenderSettings::default() };
        let mut tracer = Tracer::new(self.gpu, &scene, few, Mode::Trace)?;
        let mut follow = |control| -> Result<Vec<Traced>, RenderError> {
            tracer.retune(control, SEGMENTS)?;
            Ok(tracer.follow(Starts::Given(&self.rays))?.0)
        };
        let runs = [follow(settings[0])?, follow(settings[1])?, follow(settings[2])?];
        let mut found = Outcome { place: self.name.clone(), method: candidate.name, ..Outcome::default() };
        for (i, truth) in self.truth.ends.iter().enumerate() {
            let keeps = settings[0].kind.keeps_errors;
            let ends = [&runs[0][i], &runs[1][i], &runs[2][i]];
            *self.verdict(&mut found, ends, truth.whole(), keeps) += 1;
        }
        Ok(found)
    }

    fn verdict<'o>(
        &self,
        found: &'o mut Outcome,
        [coarse, fine, finer]: [&Traced; 3],
        truth: Option<&Traced>,
        keeps: bool,
    ) -> &'o mut usize {
        if matches!(coarse.status, Status::Alive | Status::Exhausted | Status::Stalled | Status::Failed) {
            return &mut found.given_up;
        }
        let Some(truth) = truth else { return &mut found.unresolved };
        if self.differ(coarse, truth) <= RIGHT {
            &mut found.right
        } else if self.differ(coarse, fine).max(self.differ(coarse, finer)) > AGREES * RIGHT {
            &mut found.disagreeing
        } else if keeps && coarse.rejected > 0 {
            &mut found.over
        } else {
            &mut found.silent
        }
    }

    /// Returns the difference of two ends in direction, speed, and position relative to the scene's size.
    fn differ(&self, a: &Traced, b: &Traced) -> f64 {
        if (a.status, a.object) != (b.status, b.object) {
            return f64::INFINITY;
        }
        if a.status == Status::Captured {
            return 0.0;
        }
        let place = a.distance_to(b) / self.scene.rays.bounding_sphere.radius;
        let speed = (a.speed() - b.speed()).abs() / b.speed();
        a.angle_to(b).max(place).max(speed)
    }

    /// Returns the τ up to which every ray is right, in tenths of `rays.max_parameter`, or `None` without this key.
    ///
    /// # Errors
    ///
    /// Returns an error if no device supports 64 bits, or the device fails.
    pub fn divergence(&self, candidate: &Candidate) -> Result<Option<f64>, RenderError> {
        let Some(length) = self.scene.rays.max_parameter else { return Ok(None) };
        let mut right = 0.0;
        for tenth in 1..=10 {
            let mut scene = self.scene.clone();
            scene.rays.max_parameter = Some(length * f64::from(tenth) / 10.0);
            let place = Self::new(self.gpu, &self.name, &scene, &self.rays)?;
            let outcome = place.outcome(candidate, default_settings(candidate))?;
            if outcome.right < self.rays.len() {
                break;
            }
            right = scene.rays.max_parameter.unwrap_or(0.0);
        }
        Ok(Some(right))
    }
}

impl Outcome {
    /// Returns the cells of a table.
    #[must_use]
    pub fn cells(&self) -> Vec<String> {
        let counts = [self.right, self.given_up, self.over, self.disagreeing, self.unresolved, self.silent];
        let names = [self.place.clone(), self.method.to_owned()];
        let diverged = self.diverged.map(|tau| format!("{tau}")).unwrap_or_default();
        names.into_iter().chain(counts.map(|n| n.to_string())).chain([diverged]).collect()
    }

    /// Returns the names of the cells.
    #[must_use]
    pub fn header() -> Vec<String> {
        let names = "case | method | right | given up | over tolerance | settings differ | unresolved | silent | \
                     right until τ";
        names.split(" | ").map(str::to_owned).collect()
    }
}
