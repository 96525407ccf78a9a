//! `bentray light`: the paths that lead from a scene's lights to given places.

use std::path::PathBuf;
use std::process::ExitCode;

use glam::DVec3;

use super::decisions::Rays;
use super::frames::Film;
use super::options::{DeviceFlags, SceneOptions};
use super::render::warn;
use super::settle::settle;
use crate::error::Error;
use crate::output::csv::{LightRow, Table, read_places};
use crate::render::{LightPath, light_paths};
use crate::scene::{LightSource, Scene, Shadows};

/// Find the paths that lead from a scene's lights to given places, and write their directions and the spread of their bundles
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The scene file; of its lights those with shadows = "shooting" are used
    scene: PathBuf,
    /// A CSV file with the header x,y,z: the places
    #[arg(long, value_name = "FILE")]
    at: PathBuf,
    /// Where to write the paths as CSV, a line for each, and one where there is none; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    arguments.device.check()?;
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?);
    let scene = film.load(None)?;
    let lights = shot_lights(&scene);
    if lights.is_empty() {
        let problem = "the scene has no light with shadows = \"shooting\", and paths are found from such lights";
        return Err(Error::Usage(problem.to_owned()));
    }
    let places: Vec<DVec3> = read_places(&arguments.at)?.into_iter().map(DVec3::from).collect();
    let mut table = Table::create::<LightRow>(&arguments.output)?;
    let gpu = opening.finish()?;
    let aimed: Vec<[f64; 6]> = places.iter().map(|x| aimed(lights[0].1, *x)).collect();
    let settings = arguments.device.settings(Vec::new());
    let (scene, settings) = settle(&gpu, (&film, None), scene, settings, Rays::Given(&aimed))?;
    let pairs: Vec<[DVec3; 2]> =
        places.iter().flat_map(|place| lights.iter().map(|(_, source)| [*place, *source])).collect();
    let (found, totals) = light_paths(&gpu, &scene, &settings, &pairs)?;
    for (i, paths) in found.iter().enumerate() {
        let (place, light) = (i / lights.len(), lights[i % lights.len()].0);
        for row in rows(place, light, paths) {
            table.write(&row)?;
        }
    }
    eprintln!(
        "{} paths from {} lights to {} places",
        found.iter().map(Vec::len).sum::<usize>(),
        lights.len(),
        places.len()
    );
    warn(&totals);
    table.finish()?;
    Ok(ExitCode::SUCCESS)
}

/// The lights that are found by shooting, each with its place in the scene file.
fn shot_lights(scene: &Scene) -> Vec<(usize, DVec3)> {
    let lights = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows == Shadows::Shooting);
    lights
        .filter_map(|(i, light)| match light.source {
            LightSource::Point(position) => Some((i, position)),
            LightSource::Directional(_) => None,
        })
        .collect()
}

/// A ray from a light straight to a place, for a calibration to try.
fn aimed(source: DVec3, place: DVec3) -> [f64; 6] {
    let d = (place - source).normalize_or(DVec3::X);
    [source.x, source.y, source.z, d.x, d.y, d.z]
}

fn rows(place: usize, light: usize, paths: &[LightPath]) -> Vec<LightRow> {
    let none = LightRow { place, light, status: "none", leaves: None, arrives: None, spread: None };
    let row = |path: &LightPath| LightRow {
        status: if path.clear { "lit" } else { "shadow" },
        leaves: Some(path.leaves),
        arrives: Some(path.arrives),
        spread: Some(path.spread),
        ..none
    };
    if paths.is_empty() { vec![none] } else { paths.iter().map(row).collect() }
}
