//! Every method of a scene's law over its range of settings: what it costs, and how far it is from the truth.
//!
//! *Practice.* Errors come from a few hundred rays, whose truth is known to many digits; times from the advance passes of the
//! picture itself, at a size of at least as many rays as asked for, as medians of repeats. A method's program is compiled once,
//! for only numbers change.

use crate::gpu::Gpu;
use crate::measure::{Candidate, Deviations, Truth, all_methods, drift, evaluations, method_words, scattered};
use crate::program::{Choice, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer, Starts, Traced, Tracer};
use crate::scene::Scene;

/// How to measure.
#[derive(Debug, Clone, Copy)]
pub struct Sweep<'a> {
    /// Where.
    pub gpu: &'a Gpu,
    /// Rays that are timed, at least.
    pub rays: u32,
    /// Rays whose error is measured.
    pub compared: usize,
    /// Each time is the median of so many.
    pub repeats: usize,
    /// The schedule that is timed.
    pub schedule: Schedule,
    /// A method's curve ends at the setting that takes so many times the fastest method's time.
    pub slowest: f64,
}

/// A method at a setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The method and setting in words of the scene format.
    pub words: String,
    /// The setting's number: η, degrees or tolerance.
    pub setting: f64,
    /// Errors.
    pub found: Deviations,
    /// Time of the advance and intersection passes over one ray, seconds: the median. Scattering counts where it is no pass of its
    /// own.
    pub time: f64,
    /// The longest of the repeats over the shortest.
    pub spread: f64,
    /// Evaluations of the law's rate, a ray.
    pub evaluations: f64,
    /// Accepted steps, a ray.
    pub steps: f64,
    /// Rejected steps, a ray.
    pub rejected: f64,
    /// The drift of each quantity that the law keeps: 95 of 100 rays drift by no more.
    pub drifts: Vec<(&'static str, f64)>,
    /// Root of the mean square difference of the picture's colors, each cut to [0, 1], from the reference picture's.
    pub image: f64,
}

/// A method over its settings, from coarse to fine.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodCurve {
    /// The method.
    pub name: &'static str,
    /// Its settings.
    pub points: Vec<Point>,
}

/// All methods of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneChart {
    /// The scene's name.
    pub scene: String,
    /// Rays that were timed.
    pub rays: u64,
    /// Rays whose error was measured, and those whose truth is not known.
    pub compared: [usize; 2],
    /// The methods.
    pub curves: Vec<MethodCurve>,
}

/// The truth's tolerance.
const TOLERANCE: f64 = 1e-12;
/// Segments of a path, at most: what needs more has lost the race.
const SEGMENTS: u32 = 20_000;

struct Measured {
    seconds: f64,
    spread: f64,
    colors: Vec<f32>,
}

impl Sweep<'_> {
    /// Measures every method of `scene` that is wanted.
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
        progress("truth");
        let truth = Truth::new(self.gpu, &scene, TOLERANCE, starts)?;
        let reference = self.reference_picture(&scene)?;
        let mut curves = Vec::new();
        let mut fastest = f64::INFINITY;
        let candidates: Vec<Candidate> = all_methods(&scene).into_iter().filter(wanted).collect();
        let stage = self.gpu.progress.counted("method", candidates.len());
        for (i, candidate) in candidates.into_iter().enumerate() {
            progress(candidate.name);
            stage.reach(i as f64);
            // A method is no known number of renders.
            let _renders = self.gpu.progress.stage(candidate.name);
            let points = self.method(&scene, &candidate, starts, &truth, &reference, &mut fastest)?;
            curves.push(MethodCurve { name: candidate.name, points });
        }
        let rays = u64::from(scene.image.size[0]) * u64::from(scene.image.size[1]);
        let compared = [pixels.len() - truth.unresolved(), truth.unresolved()];
        Ok(SceneChart { scene: name.to_owned(), rays, compared, curves })
    }

    /// One sample a pixel, and as many pixels as rays are wanted, in the picture's own proportions.
    fn sized(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        let [width, height] = scene.image.size.map(f64::from);
        let factor = (f64::from(self.rays) / (width * height)).sqrt();
        scene.image.size = [width, height].map(|side| ((side * factor / 8.0).ceil() * 8.0) as u32);
        scene.image.samples = 1;
        scene.image.adaptive = None;
        scene
    }

    /// The picture by the most accurate method in 32 bits that needs no trust in the others.
    fn reference_picture(&self, scene: &Scene) -> Result<Vec<f32>, RenderError> {
        let scene = crate::measure::reference(scene, 1e-9);
        let other = crate::measure::double_device(self.gpu)?;
        let settings = RenderSettings { segments: 256, ..RenderSettings::default() };
        let picture = Renderer::new(other.as_ref().unwrap_or(self.gpu), &scene, settings)?.picture()?;
        Ok(picture.band.color.concat())
    }

    fn method(
        &self,
        scene: &Scene,
        candidate: &Candidate,
        starts: Starts,
        truth: &Truth,
        reference: &[f32],
        fastest: &mut f64,
    ) -> Result<Vec<Point>, RenderError> {
        let mut scene = candidate.applied(scene, candidate.controls[0]);
        scene.rays.max_segments = SEGMENTS;
        let settings = RenderSettings { segments: 256, ..RenderSettings::default() };
        let mut few = Tracer::new(self.gpu, &scene, settings, starts.purpose())?;
        let choice = Choice { schedule: self.schedule, ..Choice::default() };
        let mut all =
            Renderer::new(self.gpu, &scene, RenderSettings { choice, apart: true, ..RenderSettings::default() })?;
        // The first run compiles.
        all.picture()?;
        let mut points: Vec<Point> = Vec::new();
        for &control in &candidate.controls {
            few.retune(control, SEGMENTS)?;
            let (rays, _) = few.follow(starts)?;
            let steps = mean(&rays, |ray| ray.steps);
            let rejected = mean(&rays, |ray| ray.rejected);
            let longest = rays.iter().map(|ray| ray.depth).fold(0.0, f64::max);
            // As many passes as the paths need, for empty ones take time too.
            all.retune(control, SEGMENTS.min(2 * longest as u32 + 8))?;
            let expected =
                points.last().map_or(0.0, |last| last.time * (steps + rejected) / (last.steps + last.rejected));
            let measured = timed(&mut all, if expected > self.slowest * *fastest { 1 } else { self.repeats })?;
            let time = measured.seconds / (f64::from(scene.image.size[0]) * f64::from(scene.image.size[1]));
            *fastest = fastest.min(time);
            points.push(Point {
                words: method_words(candidate.method, control),
                setting: (control.kind.setting)(&control),
                found: Deviations::new(&rays, truth),
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

/// Renders the picture a few times: seconds of the advance passes.
fn timed(renderer: &mut Renderer, repeats: usize) -> Result<Measured, RenderError> {
    let mut seconds = Vec::new();
    let mut colors = Vec::new();
    for _ in 0..repeats {
        let picture = renderer.picture()?;
        seconds.push(picture.totals.advance().as_secs_f64());
        colors = picture.band.color.concat();
    }
    seconds.sort_by(f64::total_cmp);
    let spread = seconds[repeats - 1] / seconds[0];
    Ok(Measured { seconds: seconds[repeats / 2], spread, colors })
}

/// From what the true end keeps, which is what the start did.
fn drifts(scene: &Scene, rays: &[Traced], truth: &Truth) -> Vec<(&'static str, f64)> {
    let pairs = rays.iter().zip(&truth.0).filter_map(|(ray, truth)| {
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
    /// The least error that any method reached (95 of 100 rays): what rounding leaves.
    #[must_use]
    pub fn floor(&self) -> f64 {
        let errors = self.curves.iter().flat_map(|curve| &curve.points).map(|point| point.found.seen.p95);
        errors.filter(|error| *error > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// The fastest method and setting by which 95 of 100 rays err by at most `error`.
    #[must_use]
    pub fn fastest(&self, error: f64) -> Option<(&MethodCurve, &Point)> {
        let all = self.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, point)));
        all.filter(|(_, point)| point.found.seen.p95 <= error).min_by(|a, b| a.1.time.total_cmp(&b.1.time))
    }
}
