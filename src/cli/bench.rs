//! `bentray bench`: the sources' tables repeated, how time grows, how far from the device's limit a render is, and what a start
//! takes.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value, json};

use super::options::parse_size;
use crate::bench::{Bench, Report, compaction, limit, paper, scaling, schedules, start};
use crate::error::Error;
use crate::gpu::Gpu;
use crate::output::OutputError;
use crate::output::report::{Section, write_report};
use crate::scene::Scene;

/// Measure: the 2004 paper's tables, schedules, how time grows, the device's limit, and starts
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Which measurement
    #[arg(value_enum)]
    name: Name,
    /// Scenes for `limit`, `compaction` and `start`; without any those of scenes/, of scenes/bench/, and the black hole
    scenes: Vec<PathBuf>,
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
    /// The same work cut into passes in different ways
    Schedules,
    /// How time grows with pixels, steps, spheres, lights and samples
    Scaling,
    /// The device's own ceilings, and how much of a render its steps alone are
    Limit,
    /// What a dense list of the living is worth, where few rays go on and where all do
    Compaction,
    /// From launch to the first pixel, with the driver's cache empty and filled
    Start,
    /// All of them
    All,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    // Read before the first measurement.
    wanted(arguments.name).into_iter().try_for_each(|name| scenes(name, arguments).map(drop))?;
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
        let report = measure(&bench, name, &scenes(name, arguments)?, &arguments.scenes)?;
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
        Name::All => vec![Name::Paper, Name::Schedules, Name::Scaling, Name::Limit, Name::Compaction, Name::Start],
        one => vec![one],
    }
}

fn measure(bench: &Bench, name: Name, scenes: &[(String, Scene)], paths: &[PathBuf]) -> Result<Report, Error> {
    Ok(match name {
        Name::Paper => paper(bench)?,
        Name::Schedules => schedules(bench)?,
        Name::Scaling => scaling(bench)?,
        Name::Limit | Name::All => limit(bench, scenes)?,
        Name::Compaction => compaction(bench, scenes)?,
        Name::Start => {
            let program = std::env::current_exe()
                .map_err(|cause| Error::Usage(format!("this program cannot be started again: {cause}")))?;
            let default = [PathBuf::from("scenes/black_hole.toml")];
            start(bench, &program, if paths.is_empty() { &default } else { paths })?
        }
    })
}

/// The scenes that a measurement is about, by name.
fn scenes(measured: Name, arguments: &Arguments) -> Result<Vec<(String, Scene)>, Error> {
    let folder = match measured {
        Name::Limit => "scenes",
        Name::Compaction => "scenes/bench",
        _ if arguments.name == measured && measured != Name::Start && !arguments.scenes.is_empty() => {
            let path = arguments.scenes[0].display();
            return Err(Error::Usage(format!("{path}: only `limit`, `compaction` and `start` measure given scenes")));
        }
        _ => return Ok(Vec::new()),
    };
    let paths = match arguments.scenes.as_slice() {
        [] => super::chart::scenes_in(Path::new(folder))?,
        given => given.to_vec(),
    };
    let name = |path: &Path| path.file_stem().map_or_else(|| "scene".to_owned(), |s| s.to_string_lossy().into_owned());
    paths.iter().map(|path| Ok((name(path), Scene::load(path, &[])?))).collect()
}
