//! How far from the device's limit a render is: its steps by themselves, and the device's own ceilings.

use super::ceiling::ceilings;
use super::{Bench, Cell, Report, Table, Times};
use crate::measure::{calibrate, evaluations, every_pixel, method_words};
use crate::model::method::CLOSED_FORMS;
use crate::program::{Choice, Purpose, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer, Starts};
use crate::scene::Scene;

/// Iterations that a bare loop has room for: lavapipe's limit over the loops of one step.
const MOST_STEPS: u32 = 20_000;

/// The device's ceilings, and for each of the scenes, by name, what share of its advance passes its bare steps are.
pub fn limit(bench: &Bench, scenes: &[(String, Scene)]) -> Result<Report, RenderError> {
    let header = [
        "scene",
        "method",
        "K",
        "rays",
        "steps a ray",
        "evaluations a ray",
        "bare (ns a step)",
        "fused (ns a step)",
        "whole (ns a step)",
        "faster over bare",
        "spread (bare)",
        "spread (fused)",
        "spread (whole)",
    ];
    let caption = "Steps in a bare loop of registers, as many for every ray as its path takes, and two schedules";
    let mut table = Table::new("scenes", caption, &header);
    for (name, scene) in scenes {
        table.rows.push(row(bench, name, scene)?);
    }
    Ok(Report {
        name: "limit",
        title: "The device's limit".to_owned(),
        intro: vec![
            "The bare loop moves the same rays by as many of the same method's steps and does nothing else: no segments, no \
             tests for their end, no objects. `fused` is its passes that advance; `whole` is everything from the camera to the \
             colour. Rays in straight space or in media with closed forms take no such steps."
                .to_owned(),
        ],
        tables: vec![ceilings(bench)?, table],
        plots: Vec::new(),
    })
}

fn row(bench: &Bench, name: &str, scene: &Scene) -> Result<Vec<Cell>, RenderError> {
    let mut scene = scene.clone();
    scene.image.size = bench.size;
    scene.image.samples = 1;
    scene.image.adaptive = None;
    if let Some(found) = calibrate(bench.gpu, &scene, &RenderSettings::default(), None)? {
        scene = found.applied(&scene);
    }
    let words = method_words(scene.rays.method, scene.rays.control);
    let Some(steps) = steps(bench, &scene)? else {
        return Ok([name.into(), words.into()].into_iter().chain(vec![Cell::None; 11]).collect());
    };
    let renderer = |purpose, schedule| {
        let choice = Choice { schedule, purpose, ..Choice::default() };
        Renderer::new(bench.gpu, &scene, RenderSettings { choice, ..RenderSettings::default() })
    };
    let bare = renderer(Purpose::Bare, Schedule::Fused)?;
    let mut fused = renderer(Purpose::Picture, Schedule::Fused)?;
    let whole = renderer(Purpose::Picture, Schedule::Whole)?;
    let segments = fused.choose_segments()?;
    let mut run_bare = || bare.bare(&steps);
    let mut run_fused = || Ok(fused.picture()?.totals.advance());
    let mut run_whole = || Ok(whole.picture()?.totals.advance());
    let [a, b, c] = Times::by_turns(bench.repeats, [&mut run_bare, &mut run_fused, &mut run_whole])?;
    let all: f64 = steps.iter().map(|n| f64::from(*n)).sum();
    let mean = all / steps.len() as f64;
    Ok(vec![
        name.into(),
        words.into(),
        segments.into(),
        (steps.len() as f64).into(),
        mean.into(),
        evaluations(scene.rays.method, scene.rays.control, mean, 0.0).into(),
        (1e9 * a.median / all).into(),
        (1e9 * b.median / all).into(),
        (1e9 * c.median / all).into(),
        (b.median.min(c.median) / a.median).into(),
        a.spread.into(),
        b.spread.into(),
        c.spread.into(),
    ])
}

/// How many steps the ray of each pixel takes, if it takes any and no surface bends it.
fn steps(bench: &Bench, scene: &Scene) -> Result<Option<Vec<u32>>, RenderError> {
    if scene.rays.method == CLOSED_FORMS || scene.scatters() {
        return Ok(None);
    }
    let choice = Choice { purpose: Purpose::Pixels, ..Choice::default() };
    let renderer = Renderer::new(bench.gpu, scene, RenderSettings { choice, ..RenderSettings::default() })?;
    let (rays, _) = renderer.follow(Starts::Pixels(&every_pixel(scene.image.size), scene.image.size[0]))?;
    Ok(Some(rays.iter().map(|ray| ray.steps.min(MOST_STEPS)).collect()))
}
