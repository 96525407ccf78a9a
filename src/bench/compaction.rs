//! What compaction is worth, a dense list of the active rays: where few go on, scattered over the picture, and where all do.

use super::{Bench, Cell, Report, Table, Times};
use crate::program::{Choice, Masks, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::Scene;

/// The schedules that are compared, with K where it counts.
const SCHEDULES: [(Schedule, u32); 4] =
    [(Schedule::Segment, 1), (Schedule::Fused, 4), (Schedule::Fused, 16), (Schedule::Fused, 1024)];

/// Each of the scenes, by name, without masks, with masks, and with masks and the list.
pub fn compaction(bench: &Bench, scenes: &[(String, Scene)]) -> Result<Report, RenderError> {
    let header = [
        "scene",
        "schedule",
        "K",
        "no masks (s)",
        "masks (s)",
        "list (s)",
        "spread (masks)",
        "spread (list)",
        "list over masks",
    ];
    let caption = "Ended rays run along, skipped where they lie, and left out of a list of the active ones";
    let mut table = Table::new("compaction", caption, &header);
    for (name, scene) in scenes {
        let mut scene = scene.clone();
        scene.image.size = bench.size;
        for (schedule, segments) in SCHEDULES {
            let [off, grid, list] = times(bench, &scene, schedule, segments)?;
            let k = segments.min(scene.rays.max_segments);
            table.rows.push(vec![
                name.as_str().into(),
                schedule.name().into(),
                if schedule == Schedule::Fused { Cell::from(k) } else { Cell::None },
                off.median.into(),
                grid.median.into(),
                list.median.into(),
                grid.spread.into(),
                list.spread.into(),
                (grid.median / list.median).into(),
            ]);
        }
    }
    let [width, height] = bench.size;
    Ok(Report {
        name: "compaction",
        title: "Compaction".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels; seconds of the advance passes, those without masks from a single run. The last column says how many times faster the list is than masks \
             without it."
        )],
        tables: vec![table],
        plots: Vec::new(),
    })
}

/// Without masks, once, for that takes many times as long; with masks alone and with the list, by turns.
fn times(bench: &Bench, scene: &Scene, schedule: Schedule, segments: u32) -> Result<[Times; 3], RenderError> {
    let renderer = |masks: Masks| {
        let choice = Choice { schedule, masks, ..Choice::default() };
        Renderer::new(bench.gpu, scene, RenderSettings { choice, segments, ..RenderSettings::default() })
    };
    let (mut off, mut grid, mut list) = (renderer(Masks::Off)?, renderer(Masks::Grid)?, renderer(Masks::List)?);
    let run = |renderer: &mut Renderer| Ok(renderer.picture()?.totals.advance());
    let [off] = Times::by_turns(1, [&mut || run(&mut off)])?;
    let [grid, list] = Times::by_turns(bench.repeats, [&mut || run(&mut grid), &mut || run(&mut list)])?;
    Ok([off, grid, list])
}
