//! The same work cut into passes in different ways.

use super::paper::{GEODESIC, How, scene};
use super::{Bench, Cell, Report, Table, Times};
use crate::output::plot::{Chart, Series};
use crate::program::{Choice, Masks, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Accelerate, Scene};

/// K of the fused schedule; the last is all of a path's segments.
const SEGMENTS: [u32; 5] = [1, 4, 16, 64, 1024];

/// The 2004 paper's case by every schedule and K, without masks and with them: those of 2004 under `paper`, else the list of active rays.
pub fn schedules(bench: &Bench) -> Result<Report, RenderError> {
    let mut scene = scene(bench.size, GEODESIC, 10, 30, How::Plain)?;
    // Lists, of which segments meet what they are near.
    scene.rays.accelerate = Accelerate::Auto;
    let others = [Schedule::Paper, Schedule::Segment, Schedule::Whole].map(|schedule| (schedule, 1));
    let fused = SEGMENTS.map(|segments| (Schedule::Fused, segments));
    let header = ["schedule", "K", "no masks (s)", "masks (s)", "spread (no masks)", "spread (masks)", "gain"];
    let mut table = Table::new("schedules", "300 Euler steps in 30 segments over 10 spheres, Schwarzschild", &header);
    let mut curve = Vec::new();
    for (schedule, segments) in others.into_iter().chain(fused) {
        let [plain, masked] = by_masks(bench, &scene, schedule, segments)?;
        let k =
            if schedule == Schedule::Fused { Cell::from(segments.min(scene.rays.max_segments)) } else { Cell::None };
        if schedule == Schedule::Fused {
            curve.push((f64::from(segments.min(scene.rays.max_segments)), plain.median, masked.median));
        }
        table.rows.push(vec![
            schedule.name().into(),
            k,
            plain.median.into(),
            masked.median.into(),
            plain.spread.into(),
            masked.spread.into(),
            (plain.median / masked.median).into(),
        ]);
    }
    let series = |name: &str, pick: fn(&(f64, f64, f64)) -> f64| Series {
        name: name.to_owned(),
        points: curve.iter().map(|point| [point.0, pick(point)]).collect(),
    };
    let chart = Chart {
        title: "Segments of one fused pass".to_owned(),
        x_label: "K".to_owned(),
        y_label: "seconds on the device".to_owned(),
        log_x: true,
        log_y: true,
        series: vec![series("every pixel", |p| p.1), series("active rays", |p| p.2)],
    };
    let [width, height] = bench.size;
    Ok(Report {
        name: "schedules",
        title: "Schedules".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels. The same stages in different passes; every picture is the same, bit for bit. With masks \
             ended rays are skipped: where they lie in `paper`, by a dense list of the active rays in the others."
        )],
        tables: vec![table],
        plots: vec![("fused", chart)],
    })
}

/// Without masks and with them, by turns.
fn by_masks(bench: &Bench, scene: &Scene, schedule: Schedule, segments: u32) -> Result<[Times; 2], RenderError> {
    let renderer = |masks: Masks| {
        let choice = Choice { schedule, masks, ..Choice::default() };
        Renderer::new(bench.gpu, scene, RenderSettings { choice, segments, ..RenderSettings::default() })
    };
    let (mut plain, mut masked) = (renderer(Masks::Off)?, renderer(schedule.masks())?);
    let mut plain = || Ok(plain.picture()?.totals.advance());
    let mut masked = || Ok(masked.picture()?.totals.advance());
    Times::by_turns(bench.repeats, [&mut plain, &mut masked])
}
