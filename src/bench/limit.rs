//! The distance of a render from the device's limit: its bare steps, and the device's ceilings.

use std::time::Duration;

use super::ceiling::{WarmUp, ceilings};
use super::{Bench, Report, Table, Times};
use crate::measure::{evaluations, every_pixel, method_words};
use crate::model::method::CLOSED_FORMS;
use crate::program::{Mode, ProgramOptions, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer, Starts, Tracer};
use crate::scene::Scene;

/// The number of iterations that a bare loop supports on any device.
const MOST_STEPS: u32 = 20_000;

/// Measures the device's ceilings, and for each scene, by name, the share of bare steps in its advance passes.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn limit(bench: &Bench, scenes: &[(String, Scene)]) -> Result<Report, RenderError> {
    let header = "scene | method | K | rays | steps per ray | evaluations per ray | bare (ns per step) | fused (ns \
                  per step) | whole (ns per step) | faster relative to bare | spread (bare) | spread (fused) | \
                  spread (whole)";
    let caption = "Steps in a bare loop, with the number of steps of each ray's path, and with two schedules";
    let mut table = Table::new("scenes", caption, header);
    let header = "scene | whole (ns per ray) | fused (ns per ray) | setup | bare steps | segments | shading";
    let caption = "Fractions of the time of a ray, with the schedule of several passes";
    let mut shares = Table::new("shares", caption, header);
    for (name, scene) in scenes {
        add(bench, name, scene, [&mut table, &mut shares])?;
    }
    Ok(Report {
        name: "limit",
        title: "The limit of the device".to_owned(),
        intro: vec![
            "The bare loop advances the same rays by the same number of steps of the same method, and does nothing \
             else: no segments, no termination tests, no objects. `fused` is the advance passes of that schedule; \
             `whole` is everything from the camera to the color. Straight rays and media with closed forms need no \
             such steps."
                .to_owned(),
            "The fractions are those of passes. `setup` creates and stores the camera rays. `segments` is the time \
             of the advance passes without the bare steps: termination, objects, loading and storing of the state, \
             counting, and compaction. `shading` is surfaces, lights, sky and image."
                .to_owned(),
        ],
        tables: vec![ceilings(bench)?, table, shares],
        plots: Vec::new(),
    })
}

/// Adds the scene's rows to both tables.
fn add(bench: &Bench, name: &str, scene: &Scene, [table, shares]: [&mut Table; 2]) -> Result<(), RenderError> {
    let mut scene = scene.clone();
    scene.image.samples = 1;
    scene.image.adaptive = None;
    let scene = bench.prepared(scene)?;
    let words = method_words(scene.rays.method, scene.rays.control);
    let steps = steps(bench, &scene)?;
    let by = |schedule| {
        let options = ProgramOptions { schedule, ..ProgramOptions::default() };
        RenderSettings { options, ..RenderSettings::default() }
    };
    let mut fused = Renderer::new(bench.gpu, &scene, by(Schedule::Fused))?;
    let mut whole = Renderer::new(bench.gpu, &scene, by(Schedule::Whole))?;
    let segments = fused.choose_segments()?;
    let (rays, warm_up) = (bench.pixels(), WarmUp::new(bench)?);
    let mut stages: Vec<[Duration; 5]> = Vec::new();
    let mut run_fused = || {
        warm_up.run()?;
        let totals = fused.render()?.totals;
        stages.extend(totals.device);
        Ok(totals.advance())
    };
    let mut run_whole = || {
        warm_up.run()?;
        Ok(whole.render()?.totals.advance())
    };
    let Some(steps) = steps else {
        let [_, c] = Times::by_turns(bench.repeats, [&mut run_fused, &mut run_whole])?;
        table.row(&[name, &words], [None::<f64>; 11]);
        shares.row(&[name], times_and_shares(&stages, 0.0, c.median, rays));
        return Ok(());
    };
    let bare = Tracer::new(bench.gpu, &scene, by(Schedule::Fused), Mode::Bare)?;
    let mut run_bare = || {
        warm_up.run()?;
        bare.bare(&steps)
    };
    let [a, b, c] = Times::by_turns(bench.repeats, [&mut run_bare, &mut run_fused, &mut run_whole])?;
    let all: f64 = steps.iter().map(|n| f64::from(*n)).sum();
    let mean = all / rays;
    let counts = [segments.into(), rays, mean, evaluations(scene.rays.method, scene.rays.control, mean, 0.0)];
    let times = [a, b, c].map(|times| 1e9 * times.median / all);
    let faster = b.median.min(c.median) / a.median;
    let spreads = [a, b, c].map(|times| times.spread);
    table.row(&[name, &words], counts.into_iter().chain(times).chain([faster]).chain(spreads));
    shares.row(&[name], times_and_shares(&stages, a.median, c.median, rays));
    Ok(())
}

/// Returns the time per ray of both schedules in nanoseconds, and the fraction of each stage, from the medians of each; without timestamps
/// they are not finite.
fn times_and_shares(stages: &[[Duration; 5]], bare: f64, whole: f64, rays: f64) -> [f64; 6] {
    let stage =
        |k: usize| Times::from(stages.iter().skip(1).map(|stages| stages[k].as_secs_f64()).collect::<Vec<_>>()).median;
    let [setup, advance, shade] = [stage(0), stage(1) + stage(2) + stage(3), stage(4)];
    let all = setup + advance + shade;
    let [setup, bare, segments, shade] = [setup, bare, advance - bare, shade].map(|part| part / all);
    let [whole, all] = [whole, all].map(|time| 1e9 * time / rays);
    [whole, all, setup, bare, segments, shade]
}

/// Returns the number of steps of each pixel's ray, if it takes steps and no surface deflects it.
fn steps(bench: &Bench, scene: &Scene) -> Result<Option<Vec<u32>>, RenderError> {
    if scene.rays.method == CLOSED_FORMS || scene.scatters() {
        return Ok(None);
    }
    let mut tracer = Tracer::new(bench.gpu, scene, RenderSettings::default(), Mode::Pixels)?;
    let (rays, _) = tracer.follow(Starts::Pixels(&every_pixel(scene.image.size), scene.image.size[0]))?;
    Ok(Some(rays.iter().map(|ray| ray.steps.min(MOST_STEPS)).collect()))
}
