//! The sweep of every method of a scene's law over its settings, which measures cost and error.
//!
//! *Practice.* Errors come from a few hundred rays with a precise reference solution. Times are medians of repeats of the image's advance
//! passes, at a size of at least the required number of rays. Each method's program is compiled once, because only numbers change.

use super::timed::timed;
use super::transfer::{TransferPoint, transfer_points};
use crate::gpu::Gpu;
use crate::measure::{
    Candidate, ErrorStats, Judged, ReferenceSolution, all_methods, drift, evaluations, method_words, scattered,
};
use crate::model::control::Control;
use crate::program::{ProgramOptions, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer, Starts, Traced, Tracer};
use crate::scene::Scene;

/// The settings of a sweep.
#[derive(Debug, Clone, Copy)]
pub struct Sweep<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// The minimum number of timed rays.
    pub rays: u32,
    /// The number of rays whose error is measured.
    pub compared: usize,
    /// The number of repeats, whose median is each time.
    pub repeats: usize,
    /// The schedule to time.
    pub schedule: Schedule,
    /// The multiple of the fastest method's time at which a method's curve ends.
    pub slowest: f64,
}

/// A method at a setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// A description of the method and setting in terms of the scene format.
    pub words: String,
    /// The number of the setting: η, degrees or tolerance.
    pub setting: f64,
    /// The errors.
    pub found: ErrorStats,
    /// The median time of the advance and intersection passes per ray, in seconds. Scattering is included unless it is a separate pass.
    pub time: f64,
    /// The ratio of the longest repeat to the shortest.
    pub spread: f64,
    /// The number of derivative evaluations per ray.
    pub evaluations: f64,
    /// The number of accepted steps per ray.
    pub steps: f64,
    /// The number of rejected steps per ray.
    pub rejected: f64,
    /// The bound of the drift of each constant of motion for 95 of 100 rays.
    pub drifts: Vec<(&'static str, f64)>,
    /// The root mean square difference of the image's colors, each clipped to [0, 1], from the reference image.
    pub image: f64,
}

/// A method with its settings, from coarse to fine.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodCurve {
    /// The method.
    pub name: &'static str,
    /// The settings.
    pub points: Vec<Point>,
}

/// All methods of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneChart {
    /// The name of the scene.
    pub scene: String,
    /// The number of timed rays.
    pub rays: u64,
    /// The number of rays whose error was measured, and the number without a reference solution.
    pub compared: [usize; 2],
    /// The measure of the errors.
    pub judged: Judged,
    /// The methods.
    pub curves: Vec<MethodCurve>,
    /// The tolerances of `[radiation]`; empty without it.
    pub transfer: Vec<TransferPoint>,
}

/// The tolerance of the reference solution.
const TOLERANCE: f64 = 1e-12;
/// The largest number of segments of a path; settings that need more are too slow.
const SEGMENTS: u32 = 20_000;

/// A setting that was measured: its error and time, the method and the setting.
type Tried = (f64, f64, Candidate, Control);

impl Sweep<'_> {
    /// Measures every requested method of `scene`.
    ///
    /// # Errors
    ///
    /// Returns an error if no device supports 64 bits, or the device fails or cannot run a program.
    pub fn scene(
        &self,
        name: &str,
        scene: &Scene,
        wanted: &dyn Fn(&Candidate) -> bool,
        progress: &dyn Fn(&str),
    ) -> Result<SceneChart, RenderError> {
        let scene = self.sized(scene);
        let pixels = scattered(scene.image.size, self.compared, 1);
        let starts = Starts::Pixels(&pixels, 1024);
        progress("reference solution");
        let truth = ReferenceSolution::new(self.gpu, &scene, TOLERANCE, starts)?;
        let reference = self.reference_picture(&scene)?;
        let mut curves = Vec::new();
        let mut fastest = f64::INFINITY;
        let judged = Judged::of_image(&scene);
        let mut tried: Vec<Tried> = Vec::new();
        let candidates: Vec<Candidate> = all_methods(&scene).into_iter().filter(wanted).collect();
        let stage = self.gpu.progress.counted("method", candidates.len());
        for (i, candidate) in candidates.into_iter().enumerate() {
            progress(candidate.name);
            stage.reach(i as f64);
            // The number of renders of a method is not known in advance.
            let _renders = self.gpu.progress.stage(candidate.name);
            let points = self.method(&scene, &candidate, starts, &truth, &reference, &mut fastest)?;
            let settings = points.iter().zip(&candidate.controls);
            tried.extend(
                settings
                    .map(|(point, control)| (point.found.judged(judged).p95, point.time, candidate.clone(), *control)),
            );
            curves.push(MethodCurve { name: candidate.name, points });
        }
        let transfer = match fastest_accurate(&tried).filter(|_| scene.radiation.is_some()) {
            Some((_, _, candidate, control)) => {
                progress("tolerances of the radiation");
                transfer_points(
                    self.gpu,
                    (self.schedule, self.repeats),
                    &candidate.applied(&scene, *control),
                    starts,
                    &truth,
                )?
            }
            None => Vec::new(),
        };
        let rays = u64::from(scene.image.size[0]) * u64::from(scene.image.size[1]);
        let compared = [pixels.len() - truth.unresolved(), truth.unresolved()];
        Ok(SceneChart { scene: name.to_owned(), rays, compared, judged, curves, transfer })
    }

    /// Returns the scene with one sample per pixel and as many pixels as required rays, with the image's aspect ratio.
    fn sized(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        let [width, height] = scene.image.size.map(f64::from);
        let factor = (f64::from(self.rays) / (width * height)).sqrt();
        scene.image.size = [width, height].map(|side| ((side * factor / 8.0).ceil() * 8.0) as u32);
        scene.image.samples = 1;
        scene.image.adaptive = None;
        scene
    }

    /// Returns the image by the most accurate method in 32 bits that needs no comparison with others.
    fn reference_picture(&self, scene: &Scene) -> Result<Vec<f32>, RenderError> {
        let scene = crate::measure::reference(scene, 1e-9);
        let other = crate::measure::double_device(self.gpu)?;
        let settings = RenderSettings { segments: 256, ..RenderSettings::default() };
        let picture = Renderer::new(other.as_ref().unwrap_or(self.gpu), &scene, settings)?.render()?;
        Ok(picture.band.color.concat())
    }

    fn method(
        &self,
        scene: &Scene,
        candidate: &Candidate,
        starts: Starts,
        truth: &ReferenceSolution,
        reference: &[f32],
        fastest: &mut f64,
    ) -> Result<Vec<Point>, RenderError> {
        let mut scene = candidate.applied(scene, candidate.controls[0]);
        scene.rays.max_segments = SEGMENTS;
        let settings = RenderSettings { segments: 256, ..RenderSettings::default() };
        let mut few = Tracer::new(self.gpu, &scene, settings, starts.mode())?;
        let options = ProgramOptions { schedule: self.schedule, ..ProgramOptions::default() };
        let mut all =
            Renderer::new(self.gpu, &scene, RenderSettings { options, apart: true, ..RenderSettings::default() })?;
        // The first run compiles.
        all.render()?;
        let mut points: Vec<Point> = Vec::new();
        for &control in &candidate.controls {
            few.retune(control, SEGMENTS)?;
            let (rays, _) = few.follow(starts)?;
            let steps = mean(&rays, |ray| ray.steps);
            let rejected = mean(&rays, |ray| ray.rejected);
            let longest = rays.iter().map(|ray| ray.segments).fold(0.0, f64::max);
            // The number of passes follows the longest path, because empty passes also take time.
            all.retune(control, SEGMENTS.min(2 * longest as u32 + 8))?;
            let expected =
                points.last().map_or(0.0, |last| last.time * (steps + rejected) / (last.steps + last.rejected));
            let measured = timed(&mut all, if expected > self.slowest * *fastest { 1 } else { self.repeats })?;
            let time = measured.seconds / (f64::from(scene.image.size[0]) * f64::from(scene.image.size[1]));
            *fastest = fastest.min(time);
            points.push(Point {
                words: method_words(candidate.method, control),
                setting: (control.kind.setting)(&control),
                found: ErrorStats::new(&rays, few.spectra(), truth),
                time,
                spread: measured.spread,
                evaluations: evaluations(candidate.method, control, steps, rejected),
                steps,
                rejected,
                drifts: drifts(&scene, &rays, truth),
                image: root_mean_square(&measured.colors, reference),
            });
            if time > self.slowest * *fastest {
                break;
            }
        }
        Ok(points)
    }
}

/// Returns the fastest setting with an error of at most twice the smallest.
fn fastest_accurate(tried: &[Tried]) -> Option<&Tried> {
    let least = tried.iter().map(|setting| setting.0).fold(f64::INFINITY, f64::min);
    tried.iter().filter(|setting| setting.0 <= 2.0 * least).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Returns the drift relative to the constants at the true end, which equal those at the start.
fn drifts(scene: &Scene, rays: &[Traced], truth: &ReferenceSolution) -> Vec<(&'static str, f64)> {
    let pairs = rays.iter().zip(&truth.ends).filter_map(|(ray, truth)| {
        let truth = truth.whole().filter(|truth| truth.status == ray.status)?;
        Some(([truth.x.into(), truth.v.into()], ray))
    });
    drift(&*scene.law, pairs).into_iter().map(|(name, quantiles)| (name, quantiles.p95)).collect()
}

fn mean(rays: &[Traced], count: impl Fn(&Traced) -> u32) -> f64 {
    rays.iter().map(|ray| f64::from(count(ray))).sum::<f64>() / rays.len().max(1) as f64
}

fn root_mean_square(a: &[f32], b: &[f32]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| f64::from(a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0)).powi(2));
    (squares.sum::<f64>() / a.len().max(1) as f64).sqrt()
}

impl SceneChart {
    /// Returns the error that 95 of 100 rays have at most.
    #[must_use]
    pub fn error(&self, point: &Point) -> f64 {
        point.found.judged(self.judged).p95
    }

    /// Returns the least error that any method reached (for 95 of 100 rays), which rounding limits.
    #[must_use]
    pub fn floor(&self) -> f64 {
        let errors = self.curves.iter().flat_map(|curve| &curve.points).map(|point| self.error(point));
        errors.filter(|error| *error > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// Returns the fastest method and setting with which 95 of 100 rays have errors of at most `error`.
    #[must_use]
    pub fn fastest(&self, error: f64) -> Option<(&MethodCurve, &Point)> {
        let all = self.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, point)));
        all.filter(|(_, point)| self.error(point) <= error).min_by(|a, b| a.1.time.total_cmp(&b.1.time))
    }
}
