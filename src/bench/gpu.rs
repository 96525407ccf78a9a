//! The waiting times of a user on this device: images of many kinds and sizes, and a film, with the device's part of each.
//!
//! *Practice.* Each image is rendered into memory several times by a compiled program. The rest of its time is spent by the host, the driver
//! and the bus. A separate process renders the film to files, as a user would.

use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use serde_json::Value;

use super::ceiling::WarmUp;
use super::times::device_time;
use super::{Bench, Report, Table, Times};
use crate::measure::method_words;
use crate::output::save;
use crate::program::Schedule;
use crate::render::{RenderError, RenderSettings, Renderer, StartUp};
use crate::scene::{Precision, Scene};

/// The scenes, below `scenes/`, with their samples per pixel.
const IMAGES: [(&str, u32); 21] = [
    ("black_hole", 1),
    ("black_hole", 16),
    ("black_hole", 64),
    ("schwarzschild_sky", 1),
    ("fig4b_lorenz", 1),
    ("fig4d_index", 1),
    ("fig4e_schwarzschild", 1),
    ("groller/towers", 1),
    ("laws/vortex", 1),
    ("spacetimes/accretion", 1),
    ("spacetimes/disc", 1),
    ("spacetimes/kerr", 1),
    ("spacetimes/two_holes", 1),
    ("spacetimes/wormhole", 1),
    ("volumes/analytic", 1),
    ("volumes/torus", 1),
    ("thesis/glass_blocks", 4),
    ("thesis/luneburg", 4),
    ("thesis/noise", 4),
    ("paths/box", 16),
    ("paths/hole", 16),
];
/// The scene of the film.
const FILM: &str = "spacetimes/flyby";

/// Measures the images and the film; `program` is this program, and `folder` contains the scenes.
///
/// # Errors
///
/// Returns [`RenderError::Output`] if a scene is invalid, if a file cannot be written, or if `program` cannot be run, and another error if
/// the device fails.
pub fn gpu(bench: &Bench, program: &Path, folder: &Path) -> Result<Report, RenderError> {
    let header = "scene | samples | schedule | precision | method | rays | steps per ray | program (s) | device (ms) | \
                  wall (ms) | outside the device (ms) | spread | PNG (ms) | submissions | waits";
    let mut images = Table::new("images", "Images in memory, and the time to write one as a PNG", header);
    let warm_up = WarmUp::new(bench)?;
    let mut add = |name, scene, schedule| add(bench, &warm_up, (name, scene), schedule, &mut images);
    for (name, samples) in IMAGES {
        add(name, loaded(folder, name, samples)?, Schedule::Whole)?;
    }
    let scene = loaded(folder, IMAGES[0].0, 1)?;
    for schedule in [Schedule::Fused, Schedule::Segment] {
        add(IMAGES[0].0, scene.clone(), schedule)?;
    }
    if bench.gpu.f64 {
        let mut scene = scene;
        scene.rays.precision = Precision::Double;
        add(IMAGES[0].0, scene, Schedule::Whole)?;
    }
    let header = "scene | frames | first frame (s) | frames per second | device (ms per frame)";
    let mut film = Table::new("film", "Frames of a film, written as PNGs", header);
    film.row(&[FILM], median_film(bench, program, &folder.join(FILM).with_extension("toml"))?);
    let intro = "The first render of each scene compiles its program, which `program` times, with the driver's cache \
                 as it is. `outside the device` is the wall-clock time without the passes: recording, submissions, \
                 waiting, and reading back. The counts are of one image.";
    Ok(Report {
        name: "gpu",
        title: "Images and films on this device".to_owned(),
        intro: vec![intro.to_owned()],
        tables: vec![images, film],
        plots: Vec::new(),
    })
}

fn loaded(folder: &Path, name: &str, samples: u32) -> Result<Scene, RenderError> {
    let path = folder.join(name).with_extension("toml");
    let mut scene = Scene::load(&path, &[]).map_err(|error| RenderError::Output(Box::new(error)))?;
    scene.image.samples = samples;
    scene.image.adaptive = None;
    Ok(scene)
}

/// Adds the row of an image.
fn add(
    bench: &Bench,
    warm_up: &WarmUp,
    (name, scene): (&str, Scene),
    schedule: Schedule,
    images: &mut Table,
) -> Result<(), RenderError> {
    let scene = bench.prepared(scene)?;
    let mut settings = RenderSettings::default();
    settings.options.schedule = schedule;
    let begun = Instant::now();
    let mut renderer = Renderer::new(bench.gpu, &scene, settings)?;
    let program = begun.elapsed().as_secs_f64();
    let mut last = renderer.render()?;
    let (mut wall, mut device) = (Vec::new(), Vec::new());
    let mut traffic = [0; 2];
    for _ in 0..bench.repeats {
        warm_up.run()?;
        let before = bench.gpu.traffic();
        last = renderer.render()?;
        let after = bench.gpu.traffic();
        traffic = [0, 1].map(|k| traffic[k] + after[k] - before[k]);
        wall.push(last.totals.wall.as_secs_f64());
        device.push(device_time(&last.totals).as_secs_f64());
    }
    let [submissions, waits] = traffic.map(|count| count as f64 / bench.repeats as f64);
    let [wall, device] = [wall, device].map(Times::from);
    let file = tempfile::tempdir().map_err(failed)?;
    let begun = Instant::now();
    save(&file.path().join("image.png"), &scene, &last).map_err(failed)?;
    let png = begun.elapsed().as_secs_f64();
    let rays = last.totals.rays as f64;
    let words = [
        name,
        &scene.image.samples.to_string(),
        renderer.program().features.schedule.name(),
        if scene.rays.precision == Precision::Double { "f64" } else { "f32" },
        &method_words(scene.rays.method, scene.rays.control),
    ];
    let milliseconds = [device.median, wall.median, wall.median - device.median].map(|time| 1e3 * time);
    let numbers = [rays, last.totals.steps as f64 / rays, program].into_iter().chain(milliseconds);
    images.row(&words, numbers.chain([wall.spread, 1e3 * png, submissions, waits]));
    Ok(())
}

/// Renders the film several times, after one time that compiles, and returns the row with the median number of frames per second.
fn median_film(bench: &Bench, program: &Path, scene: &Path) -> Result<[f64; 4], RenderError> {
    filmed(bench, program, scene)?;
    let mut rows: Vec<_> = (0..bench.repeats).map(|_| filmed(bench, program, scene)).collect::<Result<_, _>>()?;
    rows.sort_by(|a, b| a[2].total_cmp(&b[2]));
    Ok(rows[rows.len() / 2])
}

/// Renders the film, and returns the numbers of its row.
fn filmed(bench: &Bench, program: &Path, scene: &Path) -> Result<[f64; 4], RenderError> {
    let folder = tempfile::tempdir().map_err(failed)?;
    let [width, height] = bench.size;
    let mut command = Command::new(program);
    command.arg("render").arg(scene).args(["--frames", "all", "--samples", "1", "--json", "--size"]);
    command.arg(format!("{width}x{height}")).args(["--device", &bench.gpu.info.name]);
    command.arg("-o").arg(PathBuf::from(folder.path()).join("film_{frame:4}.png"));
    let begun = Instant::now();
    let output = command.output().map_err(failed)?;
    let all = begun.elapsed().as_secs_f64();
    let lines = output.stdout.split(|byte| *byte == b'\n').filter_map(|line| serde_json::from_slice(line).ok());
    let frames: Vec<Value> = lines.filter(|frame: &Value| frame["rendered"] == true).collect();
    let sum =
        |values: &Value| -> f64 { values.as_object().into_iter().flatten().filter_map(|(_, v)| v.as_f64()).sum() };
    let Some(start) = frames.first().map(|first| &first["start_seconds"]).filter(|_| output.status.success()) else {
        return Err(failed(String::from_utf8_lossy(&output.stderr).into_owned()));
    };
    let first_image = start[StartUp::PARTS[4].replace(' ', "_")].as_f64().unwrap_or(0.0);
    let count = frames.len() as f64;
    let device = frames.iter().map(|frame| sum(&frame["device_seconds"])).sum::<f64>() / count;
    Ok([count, sum(start), count / (all - (sum(start) - first_image)), 1e3 * device])
}

fn failed(cause: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> RenderError {
    RenderError::Output(Box::new(io::Error::other(cause)))
}
