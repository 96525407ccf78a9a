//! `method = "auto"`: the fastest method that is right, found on a few hundred rays before the picture starts.
//!
//! *Practice.* A search among methods compiles a program for each, and one in 64 bits for the truth: seconds on a CPU. A picture that
//! takes less is not worth it: [`calibrate_for`] then stays with the method that is the fastest for most laws, at a setting that is
//! right on the picture's own rays, and says so.

use std::fmt;
use std::time::{Duration, Instant};

use super::refined::{self, Found};
use super::{Candidate, Deviations, Truth, fast_methods, groups, method_words, scattered};
use crate::gpu::Gpu;
use crate::program::{Choice, Layer, Purpose, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer, Starts};
use crate::scene::{Control, Method, Scene};

/// Rays whose error is measured.
const RAYS: usize = 4000;
/// Workgroups whose time is.
const GROUPS: usize = 128;
const REPEATS: usize = 5;
/// What takes so many times the best one's time, in each of two runs, is not run again.
const HOPELESS: f64 = 1.3;
const REFINEMENTS: usize = 2;
/// What is asked for is met with so much to spare, because the picture has other rays than those that were tried.
const MARGIN: f64 = 0.9;
/// So many times the scene's own segments may a path have, whatever the method.
const MORE_SEGMENTS: u32 = 4;
/// Programs that a search compiles besides one for each method: the truth's, and that of the other schedule.
const OTHER_PROGRAMS: usize = 2;
/// What takes longer than this has lost.
const BUDGET: Duration = Duration::from_secs(20);

/// A method at a setting, with its error and time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// The method.
    pub method: Method,
    /// The setting.
    pub control: Control,
    /// 99 of 100 rays err by no more, in radians.
    pub error: f64,
    /// Time of a ray on the device, in seconds.
    pub time: f64,
}

/// What a calibration found.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// The error asked for, in radians.
    pub accuracy: f64,
    /// The fastest that is right; or, if none is, the most accurate.
    pub chosen: Trial,
    /// Its schedule.
    pub schedule: Schedule,
    /// The first setting of each method that was right.
    pub tried: Vec<Trial>,
    /// Rays whose truth no method can know.
    pub unresolved: usize,
    /// Was it compared with other methods? If not, because the picture takes less time than that.
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
        scene.rays.max_segments = segments(&scene);
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
        if let Some(Found { control, error, time, build }) = found {
            let search = build.as_secs_f64() * (methods.len() + OTHER_PROGRAMS) as f64;
            if time * rays as f64 <= search {
                let chosen = Trial { method: method.method, control, error, time };
                let (schedule, tried) = (settings.choice.schedule, vec![chosen]);
                return Ok(Some(Calibration {
                    accuracy,
                    chosen,
                    schedule,
                    tried,
                    unresolved: 0,
                    compared: false,
                    layers,
                }));
            }
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
    let candidates: Vec<_> = fast_methods(scene).into_iter().map(|candidate| rays.prepared(candidate)).collect();
    let mut trials = Vec::new();
    for (candidate, scene) in &candidates {
        trials.push(rays.first_right(candidate, scene)?);
    }
    let renderers: Vec<_> = trials.iter().map(|(_, renderer)| renderer).collect();
    let times = rays.times(&renderers)?;
    for ((trial, _), time) in trials.iter_mut().zip(times) {
        trial.time = time;
    }
    let right = |trial: &Trial| trial.error <= MARGIN * accuracy;
    let fastest = trials.iter().filter(|(trial, _)| right(trial)).min_by(|a, b| a.0.time.total_cmp(&b.0.time));
    let best = || trials.iter().min_by(|a, b| a.0.error.total_cmp(&b.0.error));
    let Some((chosen, renderer)) = fastest.or_else(best) else { return Ok(None) };
    let (chosen, schedule) = (*chosen, rays.schedule(chosen, renderer)?);
    let tried = trials.into_iter().map(|(trial, _)| trial).filter(right).collect();
    let (unresolved, layers) = (rays.truth.unresolved(), settings.choice.layers.clone());
    Ok(Some(Calibration { accuracy, chosen, schedule, tried, unresolved, compared: true, layers }))
}

/// The rays that methods are tried on.
struct Trials<'a> {
    gpu: &'a Gpu,
    scene: &'a Scene,
    settings: RenderSettings,
    given: Option<Vec<[f64; 6]>>,
    pixels: Vec<[u32; 2]>,
    timed: Vec<[u32; 2]>,
    truth: Truth,
    accuracy: f64,
    started: Instant,
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
        let size = scene.image.size;
        let (pixels, timed) = (scattered(size, RAYS, 1), groups(size, gpu.group, GROUPS));
        let given =
            given.map(|rays| rays.iter().step_by(rays.len().div_ceil(RAYS).max(1)).copied().collect::<Vec<_>>());
        let starts = given.as_deref().map_or(Starts::Pixels(&pixels, 1024), Starts::Given);
        let truth = Truth::new(gpu, scene, tolerance, starts)?;
        Ok(Self { gpu, scene, settings, given, pixels, timed, truth, accuracy, started: Instant::now() })
    }

    fn starts(&self) -> Starts<'_> {
        self.given.as_deref().map_or(Starts::Pixels(&self.pixels, 1024), Starts::Given)
    }

    /// A candidate with its scene.
    fn prepared(&self, candidate: Candidate) -> (Candidate, Scene) {
        let mut scene = candidate.applied(self.scene, candidate.controls[0]);
        scene.rays.max_segments = segments(self.scene);
        (candidate, scene)
    }

    /// The coarsest setting that is right, or the most accurate of all, not timed yet; and what renders it.
    fn first_right<'s>(&self, candidate: &Candidate, scene: &'s Scene) -> Result<(Trial, Renderer<'s>), RenderError>
    where
        'a: 's,
    {
        // Few rays: what counts is not how many run but how many passes are recorded.
        let settings = RenderSettings { segments: 256, ..self.settings.clone() };
        let mut renderer = Renderer::new(self.gpu, scene, settings)?;
        let mut error_at = |control| -> Result<f64, RenderError> {
            renderer.retune(control, scene.rays.max_segments)?;
            let (rays, _) = renderer.follow(self.starts())?;
            Ok(Deviations::new(&rays, &self.truth).seen.sure99)
        };
        let (method, control) = (candidate.method, candidate.controls[0]);
        let mut best = Trial { method, control, error: f64::INFINITY, time: f64::INFINITY };
        let mut wrong = None;
        for &control in &candidate.controls {
            let error = error_at(control)?;
            if error < best.error {
                best = Trial { control, error, ..best };
            }
            if error <= MARGIN * self.accuracy || self.started.elapsed() > BUDGET {
                break;
            }
            wrong = Some(control);
        }
        // Steps as long as they may be lie between the last that was wrong and the first that was right.
        for _ in 0..REFINEMENTS {
            let (Some(coarse), true) = (wrong, best.error <= MARGIN * self.accuracy) else { break };
            let control = coarse.between(best.control);
            let error = error_at(control)?;
            if error <= MARGIN * self.accuracy {
                best = Trial { control, error, ..best };
            } else {
                wrong = Some(control);
            }
        }
        renderer.retune(best.control, scene.rays.max_segments)?;
        Ok((best, renderer))
    }

    /// Seconds of a ray by each, the least of a few runs, which take turns: a slow moment is nobody's own.
    fn times(&self, renderers: &[&Renderer]) -> Result<Vec<f64>, RenderError> {
        let starts = if self.given.is_some() { self.starts() } else { Starts::Pixels(&self.timed, self.gpu.group[0]) };
        let mut times = vec![f64::INFINITY; renderers.len()];
        for repeat in 0..REPEATS {
            let best = times.iter().copied().fold(f64::INFINITY, f64::min);
            let promising = |time: f64| repeat < 2 || time <= HOPELESS * best;
            for (renderer, least) in renderers.iter().zip(&mut times).filter(|(_, least)| promising(**least)) {
                let (rays, totals) = renderer.follow(starts)?;
                let device = totals.device.map_or(totals.wall, |stages| stages.iter().sum::<Duration>());
                *least = least.min(device.as_secs_f64() / rays.len() as f64);
            }
        }
        Ok(times)
    }

    /// Fused, unless a segment a pass is faster.
    fn schedule(&self, chosen: &Trial, fused: &Renderer) -> Result<Schedule, RenderError> {
        let mut scene = self.scene.clone();
        scene.rays.auto = None;
        scene.rays.method = chosen.method;
        scene.rays.control = chosen.control;
        scene.rays.max_segments = segments(self.scene);
        let choice = Choice { schedule: Schedule::Segment, ..self.settings.choice.clone() };
        let settings = RenderSettings { choice, ..self.settings.clone() };
        let times = self.times(&[fused, &Renderer::new(self.gpu, &scene, settings)?])?;
        Ok(if times[1] < times[0] { Schedule::Segment } else { Schedule::Fused })
    }
}

impl fmt::Display for Trial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = method_words(self.method, self.control);
        write!(f, "{words}: 99 % within {:.1e} rad, {:.0} ns a ray", self.error, 1e9 * self.time)
    }
}

impl fmt::Display for Calibration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let schedule = self.schedule.name();
        write!(f, "auto: {}, {schedule}", self.chosen)?;
        if !self.compared {
            write!(f, "; not compared with other methods, which takes longer than the picture")?;
        }
        if !self.reached() {
            write!(f, "; no method reaches the accuracy asked for, {:.1e} rad: this is the best", self.accuracy)?;
        }
        if self.unresolved > 0 {
            write!(f, "; {} of the rays tried have no end that could be known", self.unresolved)?;
        }
        Ok(())
    }
}
