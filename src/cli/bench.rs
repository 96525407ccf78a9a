//! `bentray bench`: the sources' tables repeated, how time grows, and how far from the device's limit a render is.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value, json};

use super::options::parse_size;
use crate::bench::{Bench, Report, groller, limit, paper, scaling, schedules};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::OutputError;
use crate::output::report::{Section, write_report};
use crate::scene::{Mesh, Scene};

/// Measure: the 2004 paper's tables, structures, schedules, how time grows, and the device's limit
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Which measurement
    #[arg(value_enum)]
    name: Name,
    /// Scenes for `limit`, without any those of scenes/; a mesh (.obj) for `groller`, without one the bunny of scenes/data/
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Write tables (CSV), plots (SVG and PNG) and a page (index.html) into this folder; it is made if it is not there
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Print JSON, for scripts
    #[arg(long)]
    json: bool,
    /// The device whose name contains this
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// Each time is the median of so many
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=100))]
    repeats: u32,
    /// Another viewport than the paper's, for a trial
    #[arg(long, value_name = "WxH", default_value = "800x600", value_parser = parse_size)]
    size: [u32; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Name {
    /// The measurements of the 2004 paper: Table 1, Figure 5, and what its Euler steps see of a shadow
    Paper,
    /// Objects found by a hierarchy, a grid, and one after the other, from 10 to 1,000,000 triangles
    Groller,
    /// The same work cut into passes in different ways
    Schedules,
    /// How time grows with pixels, steps, spheres, lights and samples
    Scaling,
    /// The device's own ceilings, and how much of a render its steps alone are
    Limit,
    /// All of them
    All,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let given = Given::read(arguments)?;
    if let Some(folder) = &arguments.output {
        let unwritable = |cause| OutputError::Write { path: folder.clone(), cause };
        std::fs::create_dir_all(folder).map_err(unwritable)?;
    }
    let gpu = Gpu::open(arguments.device.as_deref())?;
    let device = format!("{} ({:?}, {})", gpu.info.name, gpu.info.device_type, gpu.info.driver_info);
    let [width, height] = arguments.size;
    let how = format!("{device}, {width}×{height}, medians of {}", arguments.repeats);
    if !arguments.json {
        say!("{how}");
    }
    let bench = Bench { gpu: &gpu, repeats: arguments.repeats as usize, size: arguments.size };
    let mut sections = vec![Section { title: "Where".to_owned(), intro: vec![how], ..Section::default() }];
    let mut found = Map::new();
    for name in wanted(arguments.name) {
        let report = measure(&bench, name, &given)?;
        if arguments.json {
            found.insert(report.name.to_owned(), report.json());
        } else {
            say!("\n{}", report.text().trim_end());
        }
        if let Some(folder) = &arguments.output {
            sections.push(report.write(folder)?);
        }
    }
    if arguments.json {
        let about = json!({ "device": device, "size": arguments.size, "repeats": arguments.repeats });
        say!("{:#}", json!({ "about": about, "measured": Value::Object(found) }));
    }
    if let Some(folder) = &arguments.output {
        write_report(&folder.join("index.html"), "Bentray: measurements", &sections)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn wanted(name: Name) -> Vec<Name> {
    match name {
        Name::All => vec![Name::Paper, Name::Groller, Name::Schedules, Name::Scaling, Name::Limit],
        one => vec![one],
    }
}

fn measure(bench: &Bench, name: Name, given: &Given) -> Result<Report, Error> {
    Ok(match name {
        Name::Paper => paper(bench)?,
        Name::Groller => groller(bench, &given.mesh)?,
        Name::Schedules => schedules(bench)?,
        Name::Scaling => scaling(bench)?,
        Name::Limit | Name::All => limit(bench, &given.scenes)?,
    })
}

/// What measurements are about, read before the first of them.
struct Given {
    scenes: Vec<(String, Scene)>,
    mesh: Mesh,
}

impl Given {
    fn read(arguments: &Arguments) -> Result<Self, Error> {
        let names = wanted(arguments.name);
        let is_mesh = |path: &&PathBuf| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"));
        let (meshes, scenes): (Vec<&PathBuf>, Vec<&PathBuf>) = arguments.files.iter().partition(is_mesh);
        let refused = |path: &PathBuf, problem: &str| Err(Error::Usage(format!("{}: {problem}", path.display())));
        match (scenes.first(), meshes.as_slice()) {
            (Some(path), _) if !names.contains(&Name::Limit) => refused(path, "only `limit` measures given scenes"),
            (_, [path, ..]) if !names.contains(&Name::Groller) => refused(path, "only `groller` measures a given mesh"),
            (_, [_, path, ..]) => refused(path, "`groller` measures one mesh"),
            _ => Ok(()),
        }?;
        Ok(Self {
            scenes: if names.contains(&Name::Limit) { read_scenes(&scenes)? } else { Vec::new() },
            mesh: match meshes.first() {
                _ if !names.contains(&Name::Groller) => Mesh { vertices: Vec::new(), triangles: Vec::new() },
                given => Mesh::load(given.map_or(Path::new("scenes/data/bunny.obj"), |path| path))?,
            },
        })
    }
}

fn read_scenes(given: &[&PathBuf]) -> Result<Vec<(String, Scene)>, Error> {
    let paths = match given {
        [] => super::chart::scenes_in(Path::new("scenes"))?,
        given => given.iter().map(|path| (*path).clone()).collect(),
    };
    let name = |path: &Path| path.file_stem().map_or_else(|| "scene".to_owned(), |s| s.to_string_lossy().into_owned());
    paths.iter().map(|path| Ok((name(path), Scene::load(path, &[])?))).collect()
}
