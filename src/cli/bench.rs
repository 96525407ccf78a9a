//! `bentray bench`: the sources' tables repeated, how time grows, what samples are worth, how far from the device's limit a
//! render is, and what a start takes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use serde_json::{Value, json};

use super::format::{Format, Found};
use super::options::parse_size;
use super::paths;
use super::screen;
use crate::bench::{
    Bench, Report, compaction, groller, lights, limit, paper, paths, sampling, scaling, schedules, start,
};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::report::write_report;
use crate::output::{OutputError, has_extension};
use crate::scene::{Mesh, Scene};

/// Measure: the 2004 paper's tables, structures, schedules, how time grows, what samples are worth, the device's limit, and starts
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Which measurement
    #[arg(value_enum)]
    name: Name,
    /// Scenes for `limit`, `sampling`, `compaction` and `start`, a mesh (.obj) for `groller`; without any some of the project's own,
    /// in scenes/
    #[arg(value_name = "FILE", value_parser = paths::file())]
    files: Vec<PathBuf>,
    /// Write tables (CSV), plots (SVG and PNG) and a page (index.html) into this folder; it is made if it is not there
    #[arg(short, long, value_name = "DIR", value_parser = paths::file())]
    output: Option<PathBuf>,
    /// The device whose name contains this
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// Each time is the median of so many
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    /// Another viewport than the paper's 800x600, for a trial; for `sampling` another than 200x150, for `paths` than 48x48
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    #[command(flatten)]
    format: Format,
}

/// Scenes of all kinds that `sampling` takes.
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
    /// The measurements of the 2004 paper: Table 1, Figure 5, and what its Euler steps see of a shadow
    Paper,
    /// Objects found by a hierarchy, a grid, and one after the other, from 10 to 1,000,000 triangles
    Groller,
    /// Light along bent paths: straight shadows, grids and shooting, their time against their error
    Lights,
    /// Light from surface to surface: time for the same error, by the size of a lamp and how paths find it
    Paths,
    /// The same work cut into passes in different ways
    Schedules,
    /// How time grows with pixels, steps, spheres, lights and samples
    Scaling,
    /// What samples are worth: the error against 1024 a pixel, uniform, with footprints and adaptive
    Sampling,
    /// The device's own ceilings, and how much of a render its steps alone are
    Limit,
    /// What a dense list of the active rays is worth, where few go on and where all do
    Compaction,
    /// From launch to the first pixel, with the driver's cache empty and filled
    Start,
    /// All of them
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
        _ => [800, 600],
    };
    let size = |name: Name| arguments.size.unwrap_or_else(|| usual(name));
    let mut sections = Vec::new();
    let names = wanted(arguments.name);
    let stage = screen::progress().counted("measurement", names.len());
    for (i, name) in names.into_iter().enumerate() {
        stage.reach(i as f64);
        // A measurement is no known number of renders.
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
        write_report(&folder.join("index.html"), "Bentray: measurements", &sections)?;
    }
    Ok(())
}

/// A measurement, with where and how it was made.
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

impl Found for Measured<'_> {
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
    use Name::{All, Compaction, Groller, Lights, Limit, Paper, Paths, Sampling, Scaling, Schedules, Start};
    match name {
        All => vec![Paper, Groller, Lights, Paths, Schedules, Scaling, Sampling, Limit, Compaction, Start],
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
        Name::Start => {
            let program =
                std::env::current_exe().map_err(|cause| usage!("this program cannot be started again: {cause}"))?;
            start(bench, &program, &given.started)?
        }
    })
}

/// What measurements are about, read before the first of them.
struct Given {
    scenes: BTreeMap<Name, Vec<(String, Scene)>>,
    /// What `groller` cuts up; nothing where it is not wanted.
    mesh: Mesh,
    /// Scenes that are read by the programs that are started.
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
                refused(path, "only `limit`, `sampling`, `compaction` and `start` measure given scenes")
            }
            (_, [path, ..]) if !names.contains(&Name::Groller) => refused(path, "only `groller` measures a given mesh"),
            (_, [_, path, ..]) => refused(path, "`groller` measures one mesh"),
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

/// The given scenes, or those that a measurement takes by itself.
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
