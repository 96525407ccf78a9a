//! `bentray light`: finds the paths from a scene's lights to given points.

use std::path::PathBuf;

use glam::{DVec3, Vec4};

use super::choose_method::{Settled, settle};
use super::decisions::Rays;
use super::format::counted;
use super::frames::Film;
use super::of_scene;
use super::options::{DeviceFlags, SceneOptions};
use super::paths;
use super::render::warn;
use crate::error::Error;
use crate::output::csv::read_places;
use crate::output::table::{LightRow, Table};
use crate::render::{LightPath, StartUp, light_grids, light_paths};
use crate::scene::{LightSource, Scene, Shadows};

/// Find the paths from a scene's lights to given points, and write their directions and the divergence of their ray bundles
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The scene file, or - for standard input; only lights with shadows = "curved-rays" or "photon-grid" are used
    scene: PathBuf,
    /// A CSV file of the points, with the header x,y,z; `-` is standard input
    #[arg(long, value_name = "FILE")]
    at: PathBuf,
    /// Output table, .csv or .npz, with one row per path; one row if there is no path, and one per point of a photon grid; `-` is standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    arguments.device.check()?;
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?).on(arguments.device.name());
    let scene = film.load(None)?;
    let mut inputs = film.inputs();
    inputs.push((arguments.at.clone(), "the file of points"));
    paths::check([arguments.output.as_path()], &inputs)?;
    let lights: Vec<_> = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows.follows_the_law()).collect();
    let shot = shot_lights(&scene);
    let Some((_, first)) = lights.first() else {
        let problem = "this command requires a light with shadows = \"curved-rays\" or \"photon-grid\"";
        return Err(of_scene(&arguments.scene, problem));
    };
    let places: Vec<DVec3> = read_places(&arguments.at)?.into_iter().map(DVec3::from).collect();
    let mut table = Table::create::<LightRow>(&arguments.output)?;
    let gpu = opening.finish()?;
    let pairs: Vec<[DVec3; 2]> =
        places.iter().flat_map(|place| shot.iter().map(|(_, source)| [*place, *source])).collect();
    let aimed: Vec<[f64; 6]> = places.iter().map(|x| aimed(first.source, *x)).collect();
    let rays = if shot.is_empty() { Rays::Given(&aimed) } else { Rays::Between(&pairs) };
    let settings = arguments.device.settings(Vec::new());
    let Settled { scene, settings, light_tracer, .. } =
        settle(&gpu, (&film, None), scene.clone(), settings, rays, &mut StartUp::default())?;
    let (found, totals) = match light_tracer {
        _ if shot.is_empty() => Default::default(),
        Some(mut tracer) => tracer.paths_between(&pairs)?,
        None => light_paths(&gpu, &scene, &settings, &pairs)?,
    };
    let grids = light_grids(&gpu, &scene, &settings)?;
    for (i, place) in places.iter().enumerate() {
        let (mut paths, mut fields) = (found.iter().skip(i * shot.len()), grids.iter());
        for (light, own) in &lights {
            let rows = if own.shadows == Shadows::Grid {
                fields.next().map(|(field, _)| vec![grid_row(i, *light, field.at(*place))])
            } else {
                paths.next().map(|paths| rows(i, *light, paths))
            };
            for row in rows.into_iter().flatten() {
                table.write(&row)?;
            }
        }
    }
    for (_, report) in &grids {
        tell!("{report}");
    }
    let found = found.iter().map(Vec::len).sum::<usize>();
    let [paths, lights, points] = [(found, "path"), (shot.len(), "light"), (places.len(), "point")].map(counted);
    tell!("{paths} from {lights} to {points}");
    warn(&totals);
    Ok(table.finish()?)
}

/// Returns the lights whose paths are found by the shooting method, each with its index in the scene file.
fn shot_lights(scene: &Scene) -> Vec<(usize, DVec3)> {
    let lights = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows == Shadows::Shooting);
    lights
        .filter_map(|(i, light)| match light.source {
            LightSource::Point(position) => Some((i, position)),
            LightSource::Directional(_) => None,
        })
        .collect()
}

/// Returns a ray from a light straight to a point, for a calibration to try.
fn aimed(source: LightSource, place: DVec3) -> [f64; 6] {
    let (x, d) = match source {
        LightSource::Point(position) => (position, (place - position).normalize_or(DVec3::X)),
        LightSource::Directional(direction) => (place, direction),
    };
    [x.x, x.y, x.z, d.x, d.y, d.z]
}

/// Returns the sum of all paths to a point in a photon grid: their flux-weighted mean direction, and the area of equal brightness.
fn grid_row(place: usize, light: usize, field: Option<Vec4>) -> LightRow {
    let f = field.unwrap_or_default().truncate().as_dvec3();
    let lit = f.length() > 0.0;
    LightRow {
        place,
        light,
        status: match field {
            None => "outside",
            Some(_) if lit => "lit",
            Some(_) => "none",
        },
        leaves: None,
        arrives: lit.then(|| f.normalize().to_array()),
        spread: lit.then(|| 1.0 / f.length()),
    }
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
