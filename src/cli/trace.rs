//! `bentray trace`: given rays to where they end.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use glam::DVec3;

use super::options::{DeviceOptions, SceneOptions};
use super::render::warn;
use crate::error::Error;
use crate::measure::drift;
use crate::output::csv::{PathRow, ResultRow, Table, read_rays};
use crate::output::plot::{PathLine, plot_paths};
use crate::render::{PathPoint, Status, Traced, trace, trace_paths};
use crate::scene::Scene;

/// Follow given rays through the same passes as a picture's, and write where they end
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file; its camera is not used
    scene: PathBuf,
    /// A CSV file with the header x,y,z,vx,vy,vz: each ray's start, its velocity taken as it is
    #[arg(long, value_name = "FILE")]
    rays: PathBuf,
    /// Where to write the results as CSV; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Write every segment's end instead of the path's
    #[arg(long)]
    path: bool,
    /// Draw the paths as SVG, on the two axes along which they extend most
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print by how much what the law keeps (energy, angular momentum, |v| = n) drifted along the rays
    #[arg(long, conflicts_with = "path")]
    drift: bool,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceOptions,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    if arguments.plot.as_ref() == Some(&arguments.output) {
        return Err(Error::Usage("--plot and -o name the same file".to_owned()));
    }
    let scene = Scene::load(&arguments.scene, &arguments.changes.overrides())?;
    if arguments.drift && scene.rays.asymptotic {
        return Err(Error::Usage(
            "--drift compares a ray's two ends, and with rays.asymptotic they lie at infinity".into(),
        ));
    }
    let rays = read_rays(&arguments.rays)?;
    let mut table = if arguments.path {
        Table::create::<PathRow>(&arguments.output)?
    } else {
        Table::create::<ResultRow>(&arguments.output)?
    };
    let gpu = arguments.device.open()?;
    let settings = arguments.device.settings(Vec::new());
    let (scene, settings) = arguments.device.settle(&gpu, scene, settings, Some(&rays))?;
    if !arguments.path {
        let (traced, totals) = trace(&gpu, &scene, &settings, &rays)?;
        for (i, ray) in traced.iter().enumerate() {
            table.write(&result_row(i, ray))?;
        }
        eprintln!("{totals}");
        warn(&totals);
        if arguments.drift {
            print_drift(&scene, &rays, &traced);
        }
    }
    if arguments.path || arguments.plot.is_some() {
        let paths = trace_paths(&gpu, &scene, &settings, &rays)?;
        if arguments.path {
            for (i, (_, points)) in paths.iter().enumerate() {
                for (index, point) in points.iter().enumerate() {
                    table.write(&path_row(i, index, point))?;
                }
            }
        }
        if let Some(plot) = &arguments.plot {
            let bound = (scene.rays.bound.center.to_array(), scene.rays.bound.radius);
            plot_paths(plot, &paths.iter().map(path_line).collect::<Vec<_>>(), Some(bound))?;
        }
    }
    table.finish()?;
    Ok(ExitCode::SUCCESS)
}

fn print_drift(scene: &Scene, rays: &[[f64; 6]], traced: &[Traced]) {
    let start = |[x, y, z, a, b, c]: [f64; 6]| {
        let x = DVec3::new(x, y, z);
        [x, scene.law.starting_velocity(x, DVec3::new(a, b, c))]
    };
    let found = drift(&scene.law, rays.iter().map(|ray| start(*ray)).zip(traced));
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

fn path_line((status, points): &(Status, Vec<PathPoint>)) -> PathLine<'static> {
    PathLine { points: points.iter().map(|p| p.x).collect(), status: status.name() }
}
