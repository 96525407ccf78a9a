//! `bentray trace`: given rays to where they end.

mod beams;
mod diagram;
mod pairs;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use glam::DVec3;

use self::beams::Beam;
use self::diagram::{DiagramOptions, Group};
use super::decisions::Rays;
use super::frames::Film;
use super::options::{DeviceFlags, SceneOptions};
use super::render::warn;
use super::settle::settle;
use crate::error::Error;
use crate::measure::drift;
use crate::output::csv::{PathRow, ResultRow, Table, read_rays};
use crate::output::plot::check_plot;
use crate::render::{PathPoint, Traced, trace, trace_paths};
use crate::scene::{CutPlane, Scene};

/// Follow given rays through the same passes as a picture's, and write where they end or draw their paths
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("starts").args(["rays", "fan", "bundle"]).required(true).multiple(true)))]
#[command(group(clap::ArgGroup::new("results").args(["output", "plot", "focus", "windings"]).required(true).multiple(true)))]
pub(super) struct Arguments {
    /// The scene file; its camera is not used
    scene: PathBuf,
    /// A CSV file with the header x,y,z,vx,vy,vz: each ray's start, its velocity taken as it is
    #[arg(long, value_name = "FILE")]
    rays: Option<PathBuf>,
    /// Rays from a point, such as "from=[-5,0,0] toward=[0,0,0] spread=30 count=9": SPREAD degrees between the outermost
    /// (repeatable)
    #[arg(long, value_name = "FAN", value_parser = Beam::fan)]
    fan: Vec<Beam>,
    /// Parallel rays, such as "from=[-5,0,0] toward=[0,0,0] width=2 count=9": WIDTH between the outermost (repeatable)
    #[arg(long, value_name = "BUNDLE", value_parser = Beam::bundle)]
    bundle: Vec<Beam>,
    /// Where to write the results as CSV; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Write every segment's end instead of the path's
    #[arg(long, requires = "output")]
    path: bool,
    /// Draw the paths in a plane as SVG or PNG, with the surfaces that cross it
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    diagram: DiagramOptions,
    /// Print by how much what the law keeps (energy, angular momentum, |v| = n) drifted along the rays
    #[arg(long, conflicts_with = "path")]
    drift: bool,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    arguments.device.check()?;
    if arguments.plot.is_some() && arguments.plot == arguments.output {
        return Err(Error::Usage("--plot and -o name the same file".to_owned()));
    }
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?);
    let scene = film.load(None)?;
    if arguments.drift && scene.rays.asymptotic {
        return Err(Error::Usage(
            "--drift compares a ray's two ends, and with rays.asymptotic they lie at infinity".into(),
        ));
    }
    let starts = Starts::of(arguments)?;
    let rays = &starts.rays;
    let mut table = match &arguments.output {
        Some(output) if arguments.path => Some(Table::create::<PathRow>(output)?),
        Some(output) => Some(Table::create::<ResultRow>(output)?),
        None => None,
    };
    arguments.plot.as_deref().map_or(Ok(()), check_plot)?;
    let gpu = opening.finish()?;
    let settings = arguments.device.settings(Vec::new());
    let (scene, settings) = settle(&gpu, (&film, None), scene, settings, Rays::Given(rays))?;
    if !arguments.path && (table.is_some() || arguments.drift) {
        let (traced, totals) = trace(&gpu, &scene, &settings, rays)?;
        for (i, ray) in traced.iter().enumerate() {
            table.as_mut().map_or(Ok(()), |table| table.write(&result_row(i, ray)))?;
        }
        eprintln!("{totals}");
        warn(&totals);
        if arguments.drift {
            print_drift(&scene, rays, &traced);
        }
    }
    let drawn = arguments.plot.is_some() || arguments.diagram.focus || arguments.diagram.windings.is_some();
    if arguments.path || drawn {
        let paths = trace_paths(&gpu, &scene, &settings, rays)?;
        if let Some(table) = table.as_mut().filter(|_| arguments.path) {
            for (i, (_, points)) in paths.iter().enumerate() {
                for (index, point) in points.iter().enumerate() {
                    table.write(&path_row(i, index, point))?;
                }
            }
        }
        if drawn {
            let diagram = arguments.diagram.of(starts.plane, &starts.groups, &paths);
            diagram.finish(&scene, arguments.plot.as_deref())?;
        }
    }
    table.map_or(Ok(()), Table::finish)?;
    Ok(ExitCode::SUCCESS)
}

/// All rays in the order of the results: the file's, then the fans', then the bundles'.
struct Starts {
    rays: Vec<[f64; 6]>,
    groups: Vec<Group>,
    /// The plane that is asked for, in which fans and bundles lie.
    plane: Option<CutPlane>,
}

impl Starts {
    fn of(arguments: &Arguments) -> Result<Self, Error> {
        let mut rays = arguments.rays.as_deref().map_or(Ok(Vec::new()), read_rays)?;
        let file = arguments.rays.as_ref().map(|path| Group { name: path.display().to_string(), count: rays.len() });
        let mut groups: Vec<Group> = file.into_iter().collect();
        let beams = [arguments.fan.as_slice(), &arguments.bundle].concat();
        let plane = arguments.diagram.asked_plane(&beams, &rays);
        for (beam, own) in beams.iter().zip(beams::rays(&beams, plane.as_ref())?) {
            groups.push(Group { name: beam.name(), count: own.len() });
            rays.extend(own);
        }
        Ok(Self { rays, groups, plane })
    }
}

fn print_drift(scene: &Scene, rays: &[[f64; 6]], traced: &[Traced]) {
    let start = |[x, y, z, a, b, c]: [f64; 6]| {
        let x = DVec3::new(x, y, z);
        [x, scene.law.starting_velocity(x, DVec3::new(a, b, c))]
    };
    let found = drift(&*scene.law, rays.iter().map(|ray| start(*ray)).zip(traced));
    if found.is_empty() {
        eprintln!("the law keeps nothing that could drift, or no ray came to an end");
        return;
    }
    eprintln!("{:<18}{:>12}{:>12}{:>12}", "relative drift", "median", "99 %", "max");
    for (name, q) in found {
        eprintln!("{name:<18}{:>12.2e}{:>12.2e}{:>12.2e}", q.median, q.p99, q.max);
    }
}

fn result_row(ray: usize, end: &Traced) -> ResultRow<'static> {
    ResultRow {
        ray,
        status: end.status.name(),
        position: end.x,
        velocity: end.v,
        tau: end.tau,
        depth: end.depth,
        steps: end.steps,
        rejected: end.rejected,
        object: end.object,
    }
}

fn path_row(ray: usize, index: usize, point: &PathPoint) -> PathRow {
    PathRow { ray, index, position: point.x, velocity: point.v, tau: point.tau }
}
