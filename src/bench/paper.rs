//! The measurements of Weiskopf et al. (2004), W04 §6: the four laws of Table 1, the growing number of spheres of Figure 5, and the shadow
//! edge of a black hole by their steps.
//!
//! W04 specifies the viewport (800×600) and the number of spheres, segments and steps, but not the scene, the camera or the step size,
//! which are chosen here. "No acceleration" processes every pixel in every pass with a fixed step; "2004" uses early termination and step
//! doubling by the rule of W04; "here" is the method that `auto` selects for each law, with arcs and masks, and its error next to its time.

use std::fmt::Write as _;
use std::time::Duration;

use super::times::slope;
use super::{Bench, CRITICAL, Cell, Report, Table, Times, own_scene, shadow_edge};
use crate::measure::{calibrate, method_words};
use crate::output::plot::{Chart, Series};
use crate::program::{ProgramOptions, RaySkipping, Schedule};
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::Scene;

/// A law of Table 1: its name there, its keys, the keys that leave the choice of its form open, and the times in seconds that W04 reports
/// without and with acceleration.
struct Law {
    name: &'static str,
    keys: &'static str,
    own: &'static str,
    published: [f64; 2],
}

const LAWS: [Law; 4] = [
    Law { name: "Lorenz system", keys: LORENZ, own: LORENZ, published: [3.87, 3.13] },
    Law { name: "Potential field", keys: POTENTIAL, own: POTENTIAL, published: [4.22, 1.16] },
    Law { name: "Varying index", keys: INDEX, own: INDEX, published: [3.35, 2.42] },
    Law { name: "Schwarzschild", keys: GEODESIC, own: SCHWARZSCHILD, published: [4.91, 3.79] },
];

const LORENZ: &str = "kind = \"lorenz\"\norder = 2\nsigma = 0.1\nrho = 0.28\nbeta = 0.027";
const POTENTIAL: &str =
    "kind = \"sources\"\nsources = [{ position = [0, 0, 0], strength = 0.02, falloff = { cubic = 12 } }]";
const INDEX: &str =
    "kind = \"medium\"\nindex = { kind = \"explosion\", radius = 12, amplitude = 0.1, frequency = 0.4 }";
/// The geodesic equation that W04 integrates.
pub(super) const GEODESIC: &str = "kind = \"schwarzschild\"\nform = \"geodesic\"";
/// The same spacetime with any equation.
pub(super) const SCHWARZSCHILD: &str = "kind = \"schwarzschild\"";

/// The fixed Euler step of the benchmark's scene, which 300 steps cross from the camera.
const STEP: f64 = 0.15;
/// The largest error of 95 of 100 rays by the method of `auto`, in radians.
const ACCURACY: &str = "1e-2";
/// The numbers of spheres in Figure 5.
const SPHERES: [u32; 6] = [1, 10, 20, 30, 40, 50];

/// The integration of the benchmark's rays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum How {
    /// Fixed Euler steps.
    Plain,
    /// Euler steps with step doubling by the rule of W04.
    Published,
    /// Arcs with the method of `auto`.
    Ours,
}

/// Measures Table 1, Figure 5 and the shadow.
///
/// # Errors
///
/// Returns an error if the device fails or cannot run a program of this measurement.
pub fn paper(bench: &Bench) -> Result<Report, RenderError> {
    let figure = figure(bench)?;
    let spheres = |row: usize| figure.rows.iter().map(move |cells| [number(&cells[0]), number(&cells[row])]).collect();
    let series = [("no acceleration", 1), ("2004", 2), ("here", 3)];
    let series = series.map(|(name, row)| Series::new(name, spheres(row))).to_vec();
    let title = "500 steps in 50 segments, Schwarzschild (Weiskopf et al. 2004, Figure 5)";
    let chart = Chart::linear(title, ["spheres", "seconds on the device"], series);
    let [width, height] = bench.size;
    Ok(Report {
        name: "paper",
        title: "Measurements of Weiskopf et al. (2004)".to_owned(),
        intro: vec![format!(
            "{width}×{height} pixels. None: no acceleration, with fixed Euler steps and every pixel in every pass. \
             2004: early termination and step doubling by the rule of Weiskopf et al. (2004). Here: an accuracy of \
             {ACCURACY} rad for 99 % of the rays, arcs, and early termination."
        )],
        tables: vec![table(bench)?, slopes(&figure), figure, shadow(bench)?],
        plots: vec![("figure", chart)],
    })
}

fn number(cell: &Cell) -> f64 {
    if let Cell::Number(number) = cell { *number } else { f64::NAN }
}

/// Measures Table 1: four laws, 300 steps in 30 segments over 10 spheres, with the fused schedule.
fn table(bench: &Bench) -> Result<Table, RenderError> {
    let header = "law | 2004: none (s) | none (s) | spread | 2004: accelerated (s) | accelerated as in 2004 (s) | spread | \
                  gain in 2004 | gain | here (s) | spread | method | error (rad, 99 %) | gain here";
    let mut table = Table::new("table1", "Table 1: 300 steps in 30 segments over 10 spheres", header);
    for Law { name, keys, own: own_keys, published } in LAWS {
        let scene = |how| scene(bench.size, keys, 10, 30, how);
        let (plain, accelerated) = (scene(How::Plain)?, scene(How::Published)?);
        let (ours, settings, words, error) = own(bench, own_keys, 10)?;
        let (mut a, mut b) =
            (run(bench, &plain, by_fused(RaySkipping::Off))?, run(bench, &accelerated, by_fused(RaySkipping::List))?);
        let mut c = run(bench, &ours, settings)?;
        let [a, b, c] = Times::by_turns(bench.repeats, [&mut a, &mut b, &mut c])?;
        let [none, fast] = published;
        let gains = [none / fast, a.median / b.median];
        let times = [none, a.median, a.spread, fast, b.median, b.spread, gains[0], gains[1], c.median, c.spread];
        table
            .row(&[name], times.map(Cell::from).into_iter().chain([words.into(), error, (a.median / c.median).into()]));
    }
    Ok(table)
}

/// Measures Figure 5: 500 steps in 50 segments over a growing number of spheres.
fn figure(bench: &Bench) -> Result<Table, RenderError> {
    let header = "spheres | none (s) | accelerated as in 2004 (s) | here (s) | spread (none) | spread (here)";
    let mut table = Table::new("figure5", "Figure 5: 500 steps in 50 segments, Schwarzschild", header);
    let mut scenes = Vec::new();
    for spheres in SPHERES {
        scenes.push((scene(bench.size, GEODESIC, spheres, 50, How::Plain)?, by_fused(RaySkipping::Off)));
        scenes.push((scene(bench.size, GEODESIC, spheres, 50, How::Published)?, by_fused(RaySkipping::List)));
        let (ours, settings, ..) = own(bench, SCHWARZSCHILD, spheres)?;
        scenes.push((ours, settings));
    }
    let mut runs = Vec::new();
    for (scene, settings) in &scenes {
        runs.push(run(bench, scene, settings.clone())?);
    }
    let times = Times::all_by_turns(bench.repeats, &mut runs)?;
    for (spheres, times) in SPHERES.iter().zip(times.chunks_exact(3)) {
        let medians = times.iter().map(|times| times.median);
        table.row(&[], [f64::from(*spheres)].into_iter().chain(medians).chain([times[0].spread, times[2].spread]));
    }
    Ok(table)
}

/// Returns the cost of one more sphere, from the linear fit to the figure's times.
fn slopes(figure: &Table) -> Table {
    let mut table =
        Table::new("slopes", "Figure 5: cost of one more sphere", "acceleration | ms per sphere | relative to none");
    let each = |column: usize| slope(figure.rows.iter().map(|cells| [number(&cells[0]), number(&cells[column])]));
    for (how, column) in [("none", 1), ("accelerated as in 2004", 2), ("here", 3)] {
        table.row(&[how], [1e3 * each(column), each(column) / each(1)]);
    }
    table
}

/// Measures the edge of the shadow.
fn shadow(bench: &Bench) -> Result<Table, RenderError> {
    let methods = [
        ("Euler, h = 0.15", "method = \"euler\"\nstep = 0.15"),
        ("Euler, 300 steps through the scene", "method = \"euler\"\nstep = 0.3333333333"),
        (
            "Euler doubling (Weiskopf et al. 2004), 1e-3",
            "method = \"euler-doubling\"\ndoubling = \"paper\"\ntolerance = 1e-3",
        ),
        ("RK4, h = 0.1 r", "method = \"rk4\"\nscaled_step = 0.1"),
    ];
    let caption = format!("Edge of the shadow from r = 50 M, whose impact parameter is {CRITICAL:.3} M");
    let mut table = Table::new("shadow", caption, "method | edge (M) | error (%)");
    for (name, keys) in methods {
        let edge = shadow_edge(bench.gpu, keys)?;
        let off = edge.map(|b| 100.0 * (b / CRITICAL - 1.0));
        table.row(&[name], [edge, off]);
    }
    Ok(table)
}

/// Returns the scene with the method of `auto`, its settings, its description and its error.
fn own(bench: &Bench, keys: &str, spheres: u32) -> Result<(Scene, RenderSettings, String, Cell), RenderError> {
    let scene = scene(bench.size, keys, spheres, 30, How::Ours)?;
    let settings = by_fused(RaySkipping::List);
    let Some(found) = calibrate(bench.gpu, &scene, &settings, None)? else {
        return Ok((scene, settings, "exact".to_owned(), Cell::None));
    };
    let chosen = found.chosen;
    Ok((found.applied(&scene), settings, method_words(chosen.method, chosen.control), chosen.error.into()))
}

/// Returns settings with separate advance passes; masks skip ended rays, and otherwise every pass processes every pixel.
pub(super) fn by_fused(masks: RaySkipping) -> RenderSettings {
    by(Schedule::Fused, masks, RenderSettings::default().segments)
}

/// Returns settings for a schedule; `segments` is K, which only `fused` uses.
pub(super) fn by(schedule: Schedule, masks: RaySkipping, segments: u32) -> RenderSettings {
    let options = ProgramOptions { schedule, masks, ..ProgramOptions::default() };
    RenderSettings { options, segments, ..RenderSettings::default() }
}

/// Returns K for a table: at most the scene's `max_segments`, and `None` for schedules other than `fused`.
pub(super) fn fused_segments(scene: &Scene, schedule: Schedule, segments: u32) -> Option<f64> {
    (schedule == Schedule::Fused).then(|| segments.min(scene.rays.max_segments).into())
}

/// Returns a function that renders a scene and returns the time of the passes that advance and intersect.
pub(super) fn run<'s>(
    bench: &Bench<'s>,
    scene: &'s Scene,
    settings: RenderSettings,
) -> Result<impl FnMut() -> Result<Duration, RenderError> + 's, RenderError> {
    let mut renderer = Renderer::new(bench.gpu, scene, settings)?;
    Ok(move || Ok(renderer.render()?.totals.advance()))
}

/// Returns the benchmark's scene.
pub(super) fn scene(size: [u32; 2], law: &str, spheres: u32, segments: u32, how: How) -> Result<Scene, RenderError> {
    let [width, height] = size;
    // W04 tests every segment against every object, and lists spatial partitioning as future work.
    let chords =
        format!("segment = \"chord\"\nsteps_per_segment = 10\nmax_segments = {segments}\nacceleration = \"none\"");
    let rays = match how {
        How::Plain => format!("method = \"euler\"\nstep = {STEP}\n{chords}"),
        How::Published => format!("method = \"euler-doubling\"\ndoubling = \"paper\"\ntolerance = 1e-3\n{chords}"),
        How::Ours => format!("accuracy = {ACCURACY}"),
    };
    let mut text = format!(
        "[image]\nsize = [{width}, {height}]\n[camera]\nposition = [0, 0, 20]\n\
         [law]\n{law}\n[rays]\n{rays}\nbounding_sphere = {{ radius = 25 }}\n[sky]\ncolor = [0.1, 0.1, 0.2]\n\
         [materials.red]\ndiffuse = [0.8, 0.1, 0.1]\n[[lights]]\nkind = \"point\"\nposition = [10, 10, 20]\n"
    );
    for i in 0..spheres {
        // The spheres are on a ring behind the black hole, alternately closer and farther.
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(spheres);
        let (x, y, z) = (7.0 * angle.cos(), 5.0 * angle.sin(), if i % 2 == 0 { -6.0 } else { 2.0 });
        // Writing to a String cannot fail.
        let _ = write!(
            text,
            "[[objects]]\nshape = \"sphere\"\ncenter = [{x}, {y}, {z}]\nradius = 0.9\nmaterial = \"red\"\n"
        );
    }
    own_scene(&text)
}
