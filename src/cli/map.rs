//! `bentray map`: traces an image once, for `render --from` and other programs.

use std::path::{Path, PathBuf};

use clap::Args;

use super::choose_method::{Settled, settle};
use super::decisions::Rays;
use super::frames::Film;
use super::options::{DeviceFlags, SceneOptions, parse_bytes};
use super::origin::origin;
use super::{of_scene, paths, render};
use crate::error::Error;
use crate::output::{has_extension, lens_map};
use crate::program::{Layer, PathEnds};
use crate::render::{RenderError, RenderSettings, Renderer, StartUp};
use crate::scene::Scene;

/// Trace an image once, and write where each ray ends (an EXR): a lens map for `render --from`, and an ST map for compositing
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or - for standard input
    scene: PathBuf,
    /// Output file: .exr
    #[arg(short, long, value_name = "FILE", value_parser = paths::file())]
    output: PathBuf,
    #[command(flatten)]
    changes: SceneOptions,
    #[command(flatten)]
    device: DeviceFlags,
    /// Device memory that the render may use: a larger image is rendered in tiles
    #[arg(long, value_name = "BYTES", default_value = "1GiB", value_parser = parse_bytes)]
    memory: u64,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    arguments.device.check()?;
    if !has_extension(&arguments.output, "exr") {
        return Err(usage!("{}: a lens map is an .exr", arguments.output.display()));
    }
    let opening = arguments.device.open();
    let film = Film::new(&arguments.scene, arguments.changes.overrides()?)
        .on(arguments.device.name())
        .within(arguments.memory);
    let scene = film.load(None)?;
    paths::check(std::iter::once(arguments.output.as_path()), &film.inputs())?;
    if scene.camera.is_none() {
        return Err(of_scene(&arguments.scene, RenderError::NoCamera));
    }
    refuse(&arguments.scene, &scene)?;
    let gpu = opening.finish()?;
    let wanted: Vec<Layer> = [Layer::Normal, Layer::Object, Layer::Redshift]
        .into_iter()
        .filter(|layer| layer.refused_by(&scene).is_none() && (*layer == Layer::Redshift || !scene.objects.is_empty()))
        .collect();
    let settings = RenderSettings { memory: arguments.memory, ..arguments.device.settings(wanted.clone()) };
    let [width, height] = scene.image.size.map(u64::from);
    let rays = Rays::Camera(width * height * u64::from(scene.image.samples));
    let Settled { scene, mut settings, .. } =
        settle(&gpu, (&film, None), scene, settings, rays, &mut StartUp::default())?;
    refuse(&arguments.scene, &scene)?;
    settings.options.ends = PathEnds::Stored;
    let (map, mut band, totals) = Renderer::new(&gpu, &scene, settings)?.map()?;
    band.layers.retain(|(layer, _)| wanted.contains(layer));
    lens_map::write(&arguments.output, &map, &band, &origin(&film, None, &gpu, &scene)?)?;
    tell!("{totals}");
    render::warn(&totals);
    Ok(())
}

/// Rejects a scene whose paths cannot be stored.
fn refuse(path: &Path, scene: &Scene) -> Result<(), Error> {
    match scene.refuses_map() {
        Some(problem) => Err(of_scene(path, problem)),
        None => Ok(()),
    }
}
