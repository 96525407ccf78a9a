//! `bentray chart`: speed against accuracy.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::options::SceneOptions;
use crate::chart::{SceneChart, Sweep, fastest_table, write_chart};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::OutputError;
use crate::output::report::{Section, text_table, write_report};
use crate::scene::Scene;

/// Chart speed against accuracy: every method that a scene's law allows, over its settings
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or `all` for every scene of a folder
    scene: PathBuf,
    /// The folder to write tables (CSV), plots (SVG and PNG) and a page (index.html) into; it is made if it is not there
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// With `all`: the folder of the scenes
    #[arg(long, value_name = "DIR", default_value = "scenes")]
    scenes: PathBuf,
    /// Rays that are timed, at least
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = clap::value_parser!(u32).range(64..=100_000_000))]
    rays: u32,
    /// Rays whose error is measured
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    compared: u32,
    /// Each time is the median of so many
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    #[command(flatten)]
    changes: SceneOptions,
    /// The device whose name contains this
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let paths = scenes(arguments)?;
    // All scenes are read before the first is measured.
    let load = |path: &PathBuf| Ok((name(path), Scene::load(path, &arguments.changes.overrides())?));
    let scenes = paths.iter().map(load).collect::<Result<Vec<_>, Error>>()?;
    let unwritable = |cause| OutputError::Write { path: arguments.output.clone(), cause };
    std::fs::create_dir_all(&arguments.output).map_err(unwritable)?;
    let gpu = Gpu::open(arguments.device.as_deref())?;
    let device = format!("{} ({:?}, {})", gpu.info.name, gpu.info.device_type, gpu.info.driver_info);
    eprintln!("device: {device}");
    let sweep = Sweep {
        gpu: &gpu,
        rays: arguments.rays,
        compared: arguments.compared as usize,
        repeats: arguments.repeats as usize,
    };
    let mut sections = vec![opening(&device, &sweep)];
    for (name, scene) in &scenes {
        if scene.camera.is_none() {
            return Err(crate::render::RenderError::NoCamera.into());
        }
        let chart = sweep.scene(name, scene, &|what| eprintln!("{name}: {what}"))?;
        print(&chart)?;
        sections.push(write_chart(&arguments.output, &chart)?);
    }
    write_report(&arguments.output.join("index.html"), "Bentray: speed against accuracy", &sections)?;
    Ok(ExitCode::SUCCESS)
}

fn scenes(arguments: &Arguments) -> Result<Vec<PathBuf>, Error> {
    if arguments.scene != Path::new("all") {
        return Ok(vec![arguments.scene.clone()]);
    }
    let folder = &arguments.scenes;
    let missing =
        |error| Error::Usage(format!("{} holds no scenes: {error}; name the folder with --scenes", folder.display()));
    let entries = std::fs::read_dir(folder).map_err(missing)?;
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    if paths.is_empty() {
        return Err(Error::Usage(format!("{} holds no scenes; name the folder with --scenes", folder.display())));
    }
    Ok(paths)
}

fn name(path: &Path) -> String {
    path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
}

fn print(chart: &SceneChart) -> Result<(), Error> {
    let [compared, unresolved] = chart.compared;
    say!("\n{}: {} rays timed, {compared} compared, {unresolved} unresolved", chart.scene, chart.rays);
    let (header, rows) = fastest_table(chart);
    say!("{}f32 floor (95 %): {:.1e} rad", text_table(&header, &rows), chart.floor());
    Ok(())
}

fn opening(device: &str, sweep: &Sweep) -> Section {
    let intro = vec![
        format!("Measured on {device}; each time is the median of {}.", sweep.repeats),
        "A curve is a method over its settings. Ringed points are on the front: nothing is both faster and more accurate. \
         The error of a ray is the angle by which what it sees is off; a ray that ends on another object, or otherwise \
         than the true one, is off by more than any bound."
            .to_owned(),
    ];
    Section { title: "How this was measured".to_owned(), intro, images: Vec::new(), tables: Vec::new() }
}
