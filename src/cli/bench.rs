//! `bentray bench`: repeats the tables of the sources, and measures scaling, sampling, the distance of a render from the limits of the
//! device, and the start-up time.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde_json::{Value, json};

use super::format::{CommandResult, Format};
use super::options::parse_size;
use super::paths;
use super::screen;
use crate::bench::{
    Bench, Report, compaction, gpu, groller, lights, limit, paper, paths, sampling, scaling, schedules, start,
};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::report::write_report;
use crate::output::{OutputError, has_extension};
use crate::scene::{Mesh, Scene};

/// Run benchmarks: the tables of Weiskopf et al. (2004), acceleration structures, schedules, scaling, sampling, limits, start-up, and
/// images and films on a GPU
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The benchmark
    #[arg(value_enum)]
    name: Name,
    /// Scenes for `limit`, `sampling`, `compaction` and `start`, or a mesh (.obj) for `groller`; by default, scenes of the project in
    /// scenes/
    #[arg(value_name = "FILE", value_parser = paths::file())]
    files: Vec<PathBuf>,
    /// Directory for tables (CSV), plots (SVG and PNG) and a page (index.html); created if missing
    #[arg(short, long, value_name = "DIR", value_parser = paths::file())]
    output: Option<PathBuf>,
    /// Use the device whose name contains NAME
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// Number of repetitions; each time is their median
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    /// Image size instead of 800x600, for a trial run; for `sampling` instead of 200x150, for `paths` instead of 48x48, for `gpu` instead
    /// of 1920x1080
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    #[command(flatten)]
    format: Format,
}

/// The scenes of `sampling`, one of each kind.
const SAMPLED: [&str; 6] = [
    "thesis/sunset.toml",
    "thesis/ring.toml",
    "thesis/inverse_mirror.toml",
    "thesis/luneburg.toml",
    "fig4a_straight.toml",
    "black_hole.toml",
];

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
enum Name {
    /// Measurements of Weiskopf et al. (2004): Table 1, Figure 5, and the shadow as seen with Euler steps
    Paper,
    /// Object intersection with a hierarchy, a grid and a linear search, from 10 to 1,000,000 triangles
    Groller,
    /// Lights along curved rays: time against error for straight rays, photon grids and the shooting method
    Lights,
    /// Path tracing: time to equal error, by emitter size and sampling method
    Paths,
    /// Equal work, divided into passes in different ways
    Schedules,
    /// Time against the number of pixels, steps, spheres, lights and samples
    Scaling,
    /// Sampling error relative to 1024 samples per pixel: uniform, with footprints, and adaptive
    Sampling,
    /// Limits of the device, and the share of the integration steps in a render
    Limit,
    /// Speedup by active-ray compaction, with few active rays and with all of them
    Compaction,
    /// Time from launch to the first pixel, with an empty and a filled driver cache
    Start,
    /// Images and films at 1920x1080: the time on the device and outside it, submissions, waits, and frames per second
    Gpu,
    /// All benchmarks
    All,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let given = Given::read(arguments)?;
    if let Some(folder) = &arguments.output {
        let unwritable = |cause| OutputError::Write { path: folder.clone(), cause };
        std::fs::create_dir_all(folder).map_err(unwritable)?;
    }
    let gpu = Gpu::open(arguments.device.as_deref())?.reporting(screen::progress());
    let device = format!("{} ({:?}, {})", gpu.info.name, gpu.info.device_type, gpu.info.driver_info);
    let usual = |name: Name| match name {
        Name::Sampling => [200, 150],
        Name::Paths => [48, 48],
        Name::Gpu => [1920, 1080],
        _ => [800, 600],
    };
    let size = |name: Name| arguments.size.unwrap_or_else(|| usual(name));
    let mut sections = Vec::new();
    let names = wanted(arguments.name);
    let stage = screen::progress().counted("measurement", names.len());
    for (i, name) in names.into_iter().enumerate() {
        stage.reach(i as f64);
        // The number of renders of a measurement is unknown.
        let _renders = screen::progress().stage("");
        let bench = Bench { gpu: &gpu, repeats: arguments.repeats as usize, size: size(name) };
        let measured = Measured { device: &device, bench, report: measure(&bench, name, &given)? };
        arguments.format.say(&measured)?;
        if let Some(folder) = &arguments.output {
            let mut section = measured.report.write(folder)?;
            section.intro.push(measured.how());
            sections.push(section);
        }
    }
    if let Some(folder) = &arguments.output {
        write_report(&folder.join("index.html"), "bentray: measurements", &sections)?;
    }
    Ok(())
}

/// A measurement, with the device and the conditions under which it was made.
struct Measured<'a> {
    device: &'a str,
    bench: Bench<'a>,
    report: Report,
}

impl Measured<'_> {
    fn how(&self) -> String {
        let Bench { size: [width, height], repeats, .. } = self.bench;
        format!("{}, {width}×{height}, medians of {repeats}", self.device)
    }
}

impl CommandResult for Measured<'_> {
    fn text(&self) -> String {
        format!("{}\n\n{}\n", self.how(), self.report.text())
    }

    fn json(&self) -> Value {
        let mut found = self.report.json();
        found["device"] = self.device.into();
        found["size"] = json!(self.bench.size);
        found["repeats"] = self.bench.repeats.into();
        found
    }
}

fn wanted(name: Name) -> Vec<Name> {
    use Name::{All, Compaction, Gpu, Groller, Lights, Limit, Paper, Paths, Sampling, Scaling, Schedules, Start};
    match name {
        All => vec![Paper, Groller, Lights, Paths, Schedules, Scaling, Sampling, Limit, Compaction, Start, Gpu],
        one => vec![one],
    }
}

fn measure(bench: &Bench, name: Name, given: &Given) -> Result<Report, Error> {
    let scenes = given.scenes.get(&name).map_or(&[][..], Vec::as_slice);
    Ok(match name {
        Name::Paper => paper(bench)?,
        Name::Groller => groller(bench, &given.mesh)?,
        Name::Lights => lights(bench)?,
        Name::Paths => paths(bench)?,
        Name::Schedules => schedules(bench)?,
        Name::Scaling => scaling(bench)?,
        Name::Sampling => sampling(bench, scenes)?,
        Name::Limit | Name::All => limit(bench, scenes)?,
        Name::Compaction => compaction(bench, scenes)?,
        Name::Start => start(bench, &this_program()?, &given.started)?,
        Name::Gpu => gpu(bench, &this_program()?, Path::new("scenes"))?,
    })
}

fn this_program() -> Result<PathBuf, Error> {
    std::env::current_exe().map_err(|cause| usage!("the benchmark cannot start another bentray process: {cause}"))
}

/// The inputs of the benchmarks, read before the first of them runs.
struct Given {
    scenes: BTreeMap<Name, Vec<(String, Scene)>>,
    /// The mesh that `groller` subdivides; empty if it is not needed.
    mesh: Mesh,
    /// The scenes that the started processes read.
    started: Vec<PathBuf>,
}

impl Given {
    fn read(arguments: &Arguments) -> Result<Self, Error> {
        let names = wanted(arguments.name);
        let is_mesh = |path: &PathBuf| has_extension(path, "obj");
        let (meshes, paths): (Vec<PathBuf>, Vec<PathBuf>) = arguments.files.iter().cloned().partition(is_mesh);
        let about = [Name::Limit, Name::Sampling, Name::Compaction];
        let takes_scenes = names.iter().any(|name| about.contains(name) || *name == Name::Start);
        let refused = |path: &PathBuf, problem: &str| Err(usage!("{}: {problem}", path.display()));
        match (paths.first(), meshes.as_slice()) {
            (Some(path), _) if !takes_scenes => {
                refused(path, "scene files can be given only for `limit`, `sampling`, `compaction` and `start`")
            }
            (_, [path, ..]) if !names.contains(&Name::Groller) => {
                refused(path, "a mesh can be given only for `groller`")
            }
            (_, [_, path, ..]) => refused(path, "`groller` takes one mesh"),
            _ => Ok(()),
        }?;
        let read = |name: Name| Ok((name, read_scenes(name, &paths)?));
        let scenes = names.iter().copied().filter(|name| about.contains(name)).map(read);
        let bunny = PathBuf::from("scenes/data/bunny.obj");
        Ok(Self {
            scenes: scenes.collect::<Result<_, Error>>()?,
            mesh: if names.contains(&Name::Groller) {
                Mesh::load(meshes.first().unwrap_or(&bunny))?
            } else {
                Mesh::new(Vec::new(), Vec::new())
            },
            started: if paths.is_empty() { vec![PathBuf::from("scenes/black_hole.toml")] } else { paths },
        })
    }
}

/// Reads the given scenes, or the default scenes of a benchmark.
fn read_scenes(name: Name, given: &[PathBuf]) -> Result<Vec<(String, Scene)>, Error> {
    let folder = Path::new("scenes");
    let paths = match (given, name) {
        ([], Name::Sampling) => SAMPLED.iter().map(|file| folder.join(file)).collect(),
        ([], Name::Compaction) => super::compare::scenes_in(&folder.join("bench"))?,
        ([], _) => super::compare::scenes_in(folder)?,
        (given, _) => given.to_vec(),
    };
    let stem = |path: &Path| path.file_stem().map_or_else(|| "scene".into(), |s| s.to_string_lossy().into_owned());
    paths.iter().map(|path| Ok((stem(path), Scene::load(path, &[])?))).collect()
}
