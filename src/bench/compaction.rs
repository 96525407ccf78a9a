//! The benefit of active-ray compaction, for few active rays scattered over the image, and for all rays active.

use super::paper::{by, fused_segments, run};
use super::{Bench, Report, Table, Times};
use crate::program::{RaySkipping, Schedule};
use crate::render::RenderError;
use crate::scene::Scene;

/// The schedules to compare, with K if it matters.
const SCHEDULES: [(Schedule, u32); 4] =
    [(Schedule::Segment, 1), (Schedule::Fused, 4), (Schedule::Fused, 16), (Schedule::Fused, 1024)];

/// Measures each scene, by name, without masks, with masks, and with masks and compaction.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn compaction(bench: &Bench, scenes: &[(String, Scene)]) -> Result<Report, RenderError> {
    let header = "scene | schedule | K | all rays (s) | early termination (s) | compaction (s) | spread (early \
                  termination) | spread (compaction) | speedup by compaction";
    let caption = "Terminated rays that run on, are skipped in place, or are removed by active-ray compaction";
    let mut table = Table::new("compaction", caption, header);
    for (name, scene) in scenes {
        let mut scene = scene.clone();
        scene.image.size = bench.size;
        for (schedule, segments) in SCHEDULES {
            let [off, grid, list] = times(bench, &scene, schedule, segments)?;
            let ratio = grid.median / list.median;
            let numbers = [off.median, grid.median, list.median, grid.spread, list.spread, ratio].map(Some);
            let k = fused_segments(&scene, schedule, segments);
            table.row(&[name, schedule.name()], [k].into_iter().chain(numbers));
        }
    }
    let [width, height] = bench.size;
    Ok(Report {
        name: "compaction",
        title: "Active-ray compaction".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels. Times are seconds of the advance passes; those without early termination are \
             from a single run. The last column is the time with early termination divided by the time with \
             compaction."
        )],
        tables: vec![table],
        plots: Vec::new(),
    })
}

/// Measures without masks once, because that takes many times as long, and with masks and with compaction by turns.
fn times(bench: &Bench, scene: &Scene, schedule: Schedule, segments: u32) -> Result<[Times; 3], RenderError> {
    let run = |masks| run(bench, scene, by(schedule, masks, segments));
    let (mut off, mut grid, mut list) = (run(RaySkipping::Off)?, run(RaySkipping::Grid)?, run(RaySkipping::List)?);
    let [off] = Times::by_turns(1, [&mut off])?;
    let [grid, list] = Times::by_turns(bench.repeats, [&mut grid, &mut list])?;
    Ok([off, grid, list])
}
