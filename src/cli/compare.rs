//! `bentray compare`: charts speed against accuracy.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::options::{SceneOptions, program_options, schedules};
use super::paths;
use super::screen;
use crate::chart::{Outcome, SceneChart, StabilityCase, Sweep, default_settings, fastest_table, write_chart};
use crate::document::values::suggest;
use crate::error::Error;
use crate::gpu::Gpu;
use crate::measure::{Candidate, all_methods};
use crate::output::csv::read_rays;
use crate::output::report::{ReportTable, Section, text_table, write_report};
use crate::output::{AtomicFile, OutputError};
use crate::program::Schedule;
use crate::scene::Scene;

/// Chart speed against accuracy for every method that the scene's law supports, over its settings
///
/// On a CPU, this takes minutes per scene; --methods, --rays and --slowest reduce the time.
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or `all` for every scene in a directory
    #[arg(required_unless_present = "stability", value_parser = paths::file())]
    scene: Option<PathBuf>,
    /// Instead, trace the rays of every case where methods fail, with every method, and print their termination status
    #[arg(long, conflicts_with = "scene")]
    stability: bool,
    /// Use only these methods, by their names in the chart
    #[arg(long, value_name = "METHOD", value_delimiter = ',')]
    methods: Option<Vec<String>>,
    /// Directory for tables (CSV), plots (SVG and PNG) and a page (index.html); created if missing
    #[arg(short, long, value_name = "DIR", value_parser = paths::file())]
    output: PathBuf,
    /// Directory of the scenes for `all`, or of the cases for --stability (scenes, each with its rays in a .csv next to it)
    /// [default: scenes, or scenes/stability]
    #[arg(long, value_name = "DIR", value_parser = paths::file())]
    scenes: Option<PathBuf>,
    /// Minimum number of rays that are timed
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = clap::value_parser!(u32).range(64..=100_000_000))]
    rays: u32,
    /// Number of rays whose error is measured
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    compared: u32,
    /// Number of repetitions; each time is their median
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    /// Schedule that is timed. In paper and segment, scattering at surfaces has its own pass and is not timed; whole is timed from the
    /// camera to the color
    #[arg(long, value_parser = schedules(), default_value = Schedule::Fused.name())]
    schedule: Schedule,
    /// End the curve of a method at the setting that takes FACTOR times as long as the fastest method
    #[arg(long, value_name = "FACTOR", default_value_t = 300.0)]
    slowest: f64,
    #[command(flatten)]
    changes: SceneOptions,
    /// Use the device whose name contains NAME
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let paths = scenes(arguments)?;
    if arguments.stability {
        return stability(arguments, &paths);
    }
    // All scenes are read before the first is measured.
    let load = |path: &PathBuf| Ok((name(path), Scene::load(path, &arguments.changes.overrides()?)?));
    let scenes = paths.iter().map(load).collect::<Result<Vec<_>, Error>>()?;
    are_methods(arguments, scenes.iter().map(|(_, scene)| scene))?;
    make_folder(arguments)?;
    let (gpu, device) = open(arguments)?;
    let sweep = Sweep {
        gpu: &gpu,
        rays: arguments.rays,
        compared: arguments.compared as usize,
        repeats: arguments.repeats as usize,
        schedule: program_options(arguments.schedule).schedule,
        slowest: arguments.slowest,
    };
    let mut sections = vec![opening(&device, &sweep)];
    for (name, scene) in &scenes {
        if scene.camera.is_none() {
            return Err(super::of_scene(name.as_ref(), crate::render::RenderError::NoCamera));
        }
        let chart = sweep.scene(name, scene, &|method| wanted(arguments, method), &|what| tell!("{name}: {what}"))?;
        print(&chart)?;
        sections.push(write_chart(&arguments.output, &chart)?);
    }
    write_report(&arguments.output.join("index.html"), "bentray: speed against accuracy", &sections)?;
    Ok(ExitCode::SUCCESS)
}

fn make_folder(arguments: &Arguments) -> Result<(), OutputError> {
    let path = arguments.output.clone();
    std::fs::create_dir_all(&path).map_err(|cause| OutputError::Write { path, cause })
}

fn open(arguments: &Arguments) -> Result<(Gpu, String), Error> {
    let gpu = Gpu::open(arguments.device.as_deref())?.reporting(screen::progress());
    let device = format!("{} ({:?}, {})", gpu.info.name, gpu.info.device_type, gpu.info.driver_info);
    tell!("device: {device}");
    Ok((gpu, device))
}

/// Writes the table of how all rays ended; the command fails if an error went unreported.
fn stability(arguments: &Arguments, paths: &[PathBuf]) -> Result<ExitCode, Error> {
    let load = |path: &PathBuf| {
        let scene = Scene::load(path, &arguments.changes.overrides()?)?;
        let aimed = scene.law.facts().ignores_direction.is_none();
        Ok((name(path), scene, read_rays(&path.with_extension("csv"), aimed)?))
    };
    let places = paths.iter().map(load).collect::<Result<Vec<_>, Error>>()?;
    are_methods(arguments, places.iter().map(|(_, scene, _)| scene))?;
    make_folder(arguments)?;
    let (gpu, device) = open(arguments)?;
    let mut rows = Vec::new();
    let mut silent = 0;
    for (name, scene, rays) in &places {
        tell!("{name}");
        let place = StabilityCase::new(&gpu, name, scene, rays)?;
        for candidate in all_methods(scene).iter().filter(|candidate| wanted(arguments, candidate)) {
            let mut outcome = place.outcome(candidate, default_settings(candidate))?;
            outcome.diverged = place.divergence(candidate)?;
            silent += outcome.silent;
            rows.push(outcome.cells());
        }
    }
    let header = Outcome::header();
    say!("{}", text_table(&header, &rows).trim_end());
    let csv: String = [&header].into_iter().chain(&rows).map(|row| row.join(",") + "\n").collect();
    AtomicFile::write_whole(&arguments.output.join("stability.csv"), csv.as_bytes())?;
    let intro = vec![
        format!("Measured on {device}, with each method at its default setting and at two finer settings."),
        "Right: the end agrees with the reference solution within 1e-3. Given up: the ray reports that it did not \
         reach an end. Over tolerance: steps beyond the tolerance were accepted, as by the rule of Weiskopf et al. \
         (2004), and counted. Settings differ: a finer setting ends elsewhere, so the coarser setting is unreliable. \
         Unresolved: two runs in 64 bits disagree. Silent: wrong, without any indication. Right until τ: the \
         parameter up to which all rays of a flow are right."
            .to_owned(),
    ];
    let table = ReportTable { caption: "Rays by outcome".to_owned(), header, rows };
    let section = Section { title: "Where methods fail".to_owned(), intro, images: Vec::new(), tables: vec![table] };
    write_report(&arguments.output.join("stability.html"), "bentray: stability", &[section])?;
    if silent > 0 {
        tell!("{silent} rays end wrongly without any indication");
        return Ok(ExitCode::FAILURE);
    }
    Ok(ExitCode::SUCCESS)
}

/// Checks that each requested method is available for one of the scenes.
fn are_methods<'a>(arguments: &Arguments, scenes: impl Iterator<Item = &'a Scene>) -> Result<(), Error> {
    let mut known: Vec<&str> = Vec::new();
    for candidate in scenes.flat_map(all_methods) {
        if !known.contains(&candidate.name) {
            known.push(candidate.name);
        }
    }
    let unknown = arguments.methods.iter().flatten().find(|name| !known.contains(&name.as_str()));
    match unknown {
        Some(name) => Err(usage!("--methods: no scene supports `{name}`; {}", suggest(name, &known, "methods"))),
        None => Ok(()),
    }
}

fn wanted(arguments: &Arguments, candidate: &Candidate) -> bool {
    arguments.methods.as_ref().is_none_or(|methods| methods.iter().any(|method| method == candidate.name))
}

fn scenes(arguments: &Arguments) -> Result<Vec<PathBuf>, Error> {
    let default = match &arguments.scene {
        Some(scene) if scene != Path::new("all") => return Ok(vec![scene.clone()]),
        Some(_) => "scenes",
        None => "scenes/stability",
    };
    scenes_in(arguments.scenes.as_deref().unwrap_or(Path::new(default)))
}

/// Returns the scenes of a directory, ordered by name.
pub(super) fn scenes_in(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let missing = |error| usage!("no scenes in {}: {error}; give their folder with --scenes", folder.display());
    let entries = std::fs::read_dir(folder).map_err(missing)?;
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    if paths.is_empty() {
        return Err(usage!("no scenes in {}; give their folder with --scenes", folder.display()));
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
    say!("{}smallest error (95 %): {:.1e} {}", text_table(&header, &rows), chart.floor(), chart.judged.unit());
    Ok(())
}

fn opening(device: &str, sweep: &Sweep) -> Section {
    let intro = vec![
        format!(
            "Measured on {device}. Each time is the median of {} runs of the passes that advance and intersect, with \
             schedule `{}`.",
            sweep.repeats,
            sweep.schedule.name()
        ),
        "Each curve shows one method at several settings. Ringed points are on the Pareto front: no other point is \
         both faster and more accurate. The error of a ray is the angle between its direction and that of the \
         reference solution; a ray that ends on another object, or with another status, exceeds every bound. In a scene \
         with [radiation], it is the error of the ray's light, relative to it."
            .to_owned(),
    ];
    Section { title: "Measurement conditions".to_owned(), intro, images: Vec::new(), tables: Vec::new() }
}
