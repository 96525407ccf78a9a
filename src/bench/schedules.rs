//! The time of equal work divided into passes in different ways.

use super::paper::{GEODESIC, How, by, fused_segments, run, scene};
use super::{Bench, Report, Table, Times};
use crate::output::plot::{Chart, Series};
use crate::program::{RaySkipping, Schedule};
use crate::render::RenderError;
use crate::scene::{Accelerate, Scene};

/// The values of K for the fused schedule; the last is all of a path's segments.
const SEGMENTS: [u32; 5] = [1, 4, 16, 64, 1024];

/// Measures the case of W04 with every schedule and K, without masks and with them: those of W04 for `paper`, otherwise compaction.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn schedules(bench: &Bench) -> Result<Report, RenderError> {
    let mut scene = scene(bench.size, GEODESIC, 10, 30, How::Plain)?;
    // Uses lists of objects, of which segments test only the near ones.
    scene.rays.acceleration = Accelerate::Auto;
    let others = [Schedule::Paper, Schedule::Segment, Schedule::Whole].map(|schedule| (schedule, 1));
    let fused = SEGMENTS.map(|segments| (Schedule::Fused, segments));
    let header = "schedule | K | all rays (s) | early termination (s) | spread (all rays) | spread (early \
                  termination) | speedup";
    let mut table = Table::new("schedules", "300 Euler steps in 30 segments over 10 spheres, Schwarzschild", header);
    let mut series = Vec::new();
    for (schedule, segments) in others.into_iter().chain(fused) {
        let [plain, masked] = by_masks(bench, &scene, schedule, segments)?;
        let numbers = [plain.median, masked.median, plain.spread, masked.spread, plain.median / masked.median];
        let k = fused_segments(&scene, schedule, segments);
        table.row(&[schedule.name()], [k].into_iter().chain(numbers.map(Some)));
        if let Some(k) = k {
            Series::extend(&mut series, "every pixel", [k, plain.median]);
            Series::extend(&mut series, "active rays", [k, masked.median]);
        }
    }
    let chart = Chart::logarithmic("Segments per fused pass", ["K", "seconds on the device"], series);
    let [width, height] = bench.size;
    Ok(Report {
        name: "schedules",
        title: "Schedules".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels. The same stages in different passes; all images are bit-identical. With early \
             termination, terminated rays are skipped: in place in `paper`, by active-ray compaction in the others."
        )],
        tables: vec![table],
        plots: vec![("fused", chart)],
    })
}

/// Measures without masks and with them, by turns.
fn by_masks(bench: &Bench, scene: &Scene, schedule: Schedule, segments: u32) -> Result<[Times; 2], RenderError> {
    let run = |masks| run(bench, scene, by(schedule, masks, segments));
    let (mut plain, mut masked) = (run(RaySkipping::Off)?, run(schedule.masks())?);
    Times::by_turns(bench.repeats, [&mut plain, &mut masked])
}
