//! What becomes of rays where methods fail.
//!
//! *Theory.* A method that errs is no harm where its user is told. So each ray is followed as the method does it by default, and
//! by the same method at two finer settings, which is all that can be done without the truth; then the truth is looked at. A
//! ray is *right*; or *flagged*, because it was given up (exhausted, stalled, not finite) because it kept steps over its tolerance and
//! counted them, or because the settings disagree; or *unresolved*, if 64 bits cannot know its end; or else it is *silent*: wrong, and nobody would know.
//!
//! *Practice.* Starts are rounded to 32 bits before anything follows them, for what a ray is, is not the method's fault.

use crate::gpu::Gpu;
use crate::measure::{Candidate, Truth, all_methods};
use crate::program::Purpose;
use crate::render::{RenderError, RenderSettings, Starts, Status, Traced, Tracer};
use crate::scene::{Control, Scene};

/// Directions (radians), speeds (relative) and places (in parts of the bound's radius) are right within this.
const RIGHT: f64 = 1e-3;
/// Settings agree if they differ by no more than this part of what is right: halving the steps of a method of order 1 shows
/// half of its error, and the rest is margin.
const AGREES: f64 = 0.25;
const TOLERANCE: f64 = 1e-13;
/// Segments of a path, at most.
const SEGMENTS: u32 = 40_000;

/// What became of a place's rays under one method.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Outcome {
    /// The place.
    pub place: String,
    /// The method.
    pub method: &'static str,
    /// Rays that end where they should.
    pub right: usize,
    /// Rays that were given up: exhausted, stalled or not finite.
    pub given_up: usize,
    /// Rays that kept steps over the tolerance, as the 2004 rule does, and counted them.
    pub over: usize,
    /// Rays whose ends at two settings differ.
    pub disagreeing: usize,
    /// Rays whose true end is not known.
    pub unresolved: usize,
    /// Rays that are wrong without a sign of it.
    pub silent: usize,
    /// Until which τ all rays of a flow were right; none for other laws.
    pub diverged: Option<f64>,
}

/// The settings that are compared: the default one, and two finer ones. A smaller tolerance alone would change nothing where
/// the cap rules, so that the cap falls with it.
#[must_use]
pub fn default_settings(candidate: &Candidate) -> [Control; 3] {
    let control = candidate.controls[0];
    [0, 1, 2].map(|fine| (control.kind.usual)(&control, fine))
}

/// A place where methods fail: a scene, and rays in it.
#[derive(Debug)]
pub struct Place<'a> {
    gpu: &'a Gpu,
    name: String,
    scene: Scene,
    rays: Vec<[f64; 6]>,
    truth: Truth,
}

impl<'a> Place<'a> {
    /// Finds the true ends of the rays.
    pub fn new(gpu: &'a Gpu, name: &str, scene: &Scene, rays: &[[f64; 6]]) -> Result<Self, RenderError> {
        let mut scene = scene.clone();
        scene.rays.max_segments = SEGMENTS;
        let rays: Vec<_> = rays.iter().map(|ray| ray.map(|v| f64::from(v as f32))).collect();
        let truth = Truth::new(gpu, &scene, TOLERANCE, Starts::Given(&rays))?;
        Ok(Self { gpu, name: name.to_owned(), scene, rays, truth })
    }

    /// What becomes of the rays under every method that the law allows, or under those named.
    pub fn outcomes(&self, only: Option<&[&str]>) -> Result<Vec<Outcome>, RenderError> {
        let methods = all_methods(&self.scene);
        let wanted = methods.iter().filter(|method| only.is_none_or(|only| only.contains(&method.name)));
        wanted.map(|candidate| self.outcome(candidate, default_settings(candidate))).collect()
    }

    /// What becomes of them under one method at three settings.
    pub fn outcome(&self, candidate: &Candidate, settings: [Control; 3]) -> Result<Outcome, RenderError> {
        let scene = candidate.applied(&self.scene, settings[0]);
        let few = RenderSettings { segments: 256, ..RenderSettings::default() };
        let mut tracer = Tracer::new(self.gpu, &scene, few, Purpose::Trace)?;
        let mut follow = |control| -> Result<Vec<Traced>, RenderError> {
            tracer.retune(control, SEGMENTS)?;
            Ok(tracer.follow(Starts::Given(&self.rays))?.0)
        };
        let runs = [follow(settings[0])?, follow(settings[1])?, follow(settings[2])?];
        let mut found = Outcome { place: self.name.clone(), method: candidate.name, ..Outcome::default() };
        for (i, truth) in self.truth.0.iter().enumerate() {
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

    /// By how much two ends differ: in direction, in speed, and in place as a part of the scene's size.
    fn differ(&self, a: &Traced, b: &Traced) -> f64 {
        if (a.status, a.object) != (b.status, b.object) {
            return f64::INFINITY;
        }
        if a.status == Status::Captured {
            return 0.0;
        }
        let place = a.distance_to(b) / self.scene.rays.bound.radius;
        let speed = (a.speed() - b.speed()).abs() / b.speed();
        a.angle_to(b).max(place).max(speed)
    }

    /// Until which τ every ray is right, tried at tenths of `rays.max_parameter`; none without a length.
    pub fn divergence(&self, candidate: &Candidate) -> Result<Option<f64>, RenderError> {
        let Some(length) = self.scene.rays.length else { return Ok(None) };
        let mut right = 0.0;
        for tenth in 1..=10 {
            let mut scene = self.scene.clone();
            scene.rays.length = Some(length * f64::from(tenth) / 10.0);
            let place = Self::new(self.gpu, &self.name, &scene, &self.rays)?;
            let outcome = place.outcome(candidate, default_settings(candidate))?;
            if outcome.right < self.rays.len() {
                break;
            }
            right = scene.rays.length.unwrap_or(0.0);
        }
        Ok(Some(right))
    }
}

impl Outcome {
    /// As cells of a table.
    #[must_use]
    pub fn cells(&self) -> Vec<String> {
        let counts = [self.right, self.given_up, self.over, self.disagreeing, self.unresolved, self.silent];
        let names = [self.place.clone(), self.method.to_owned()];
        let diverged = self.diverged.map(|tau| format!("{tau}")).unwrap_or_default();
        names.into_iter().chain(counts.map(|n| n.to_string())).chain([diverged]).collect()
    }

    /// The names of the cells.
    #[must_use]
    pub fn header() -> Vec<String> {
        let names = "place | method | right | given up | over tolerance | settings differ | unresolved | silent | right until τ";
        names.split(" | ").map(str::to_owned).collect()
    }
}
