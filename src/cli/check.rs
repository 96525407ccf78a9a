//! `bentray check`: is a scene right, and what will be modelled?

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::frames::Film;
use super::options::{SceneOptions, choice, schedules};
use crate::error::Error;
use crate::gpu::{Built, Geometry, Grid, LightVolume, light_bytes, memory};
use crate::model::medium::VISIBLE;
use crate::program::{Choice, Program, Schedule};
use crate::scene::{Beam, Scene, Shadows, reference_markdown};

/// Validate scenes, and say what will be modelled: parts, passes, bytes per pixel
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene files
    #[arg(required_unless_present = "reference")]
    scenes: Vec<PathBuf>,
    /// Print every key of the scene format instead
    #[arg(long)]
    reference: bool,
    #[command(flatten)]
    changes: SceneOptions,
    /// The schedule to count passes and memory for
    #[arg(long, value_parser = schedules(), default_value = Schedule::Whole.name())]
    schedule: Schedule,
}

/// Every scene is checked, and every mistake reported, before the exit code says whether there were any.
pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    if arguments.reference {
        say!("{}", reference_markdown().trim_end());
        return Ok(ExitCode::SUCCESS);
    }
    let mut code = ExitCode::SUCCESS;
    for path in &arguments.scenes {
        match check(path, arguments) {
            Ok(()) => {}
            Err(Error::Closed) => return Err(Error::Closed),
            Err(error) => {
                tell!("error: {error}");
                code = ExitCode::FAILURE;
            }
        }
    }
    Ok(code)
}

fn check(path: &Path, arguments: &Arguments) -> Result<(), Error> {
    let scene = Scene::load(path, &arguments.changes.overrides()?)?;
    let geometry = Geometry::new(&scene);
    let choice = choice(arguments.schedule);
    let program = Program::new(&scene, &geometry.analysis, &choice, geometry.extent())?;
    let [width, height] = scene.image.size;
    say!("{}: {width}×{height}, samples {}, objects {}", path.display(), scene.image.samples, scene.objects.len());
    if let Some(tolerance) = scene.image.adaptive {
        say!(
            "  adaptive: a ray a pixel through its corner, then 16 and on to {}, until the error is below {tolerance}",
            scene.image.samples
        );
    }
    if let Some(words) = structure_words(&geometry) {
        say!("  {words}");
    }
    for (pass, linked, reflection) in &program.passes {
        let lines = linked.source.lines().count();
        say!(
            "  pass {:<10} {lines:>4} lines, {:>2} bindings: {}",
            pass.entry(),
            reflection.bindings.len(),
            linked.parts().join(" ")
        );
    }
    if let Some(remark) = scene.law.remark(scene.rays.bound.center, scene.rays.bound.radius) {
        say!("  {remark}");
    }
    if let Some(words) = scene.rounded_away() {
        say!("  warning: {words}");
    }
    for light in scene.swallowed_lights() {
        say!("  light {light} (from 0) is inside of what captures rays, and lights nothing");
    }
    for (i, light) in scene.lights.iter().enumerate().filter(|(_, light)| light.shadows == Shadows::Grid) {
        let volume = LightVolume::new(&scene, light.grid.voxels);
        let [x, y, z] = volume.count;
        let bytes = light_bytes(volume.voxels() as u64);
        say!("  light {i} (from 0): a grid of {x}×{y}×{z} voxels, {} paths, at least {bytes} bytes", light.grid.paths);
    }
    for line in random_words(&scene) {
        say!("  {line}");
    }
    if scene.rays.auto.is_some() {
        say!("  method auto: measured when the scene is rendered; counted here for rk4");
    }
    print_memory(&scene, &program, &choice)?;
    check_frames(path, arguments, &choice, &scene)
}

/// What of the picture is drawn at random.
fn random_words(scene: &Scene) -> Vec<String> {
    let mut words = Vec::new();
    if scene.rays.paths.is_some() {
        let lamps: Vec<_> = scene.lamps().iter().map(|lamp| lamp.object.to_string()).collect();
        let lamps =
            (!lamps.is_empty()).then(|| format!("{} lamps: objects {} (from 0)", lamps.len(), lamps.join(", ")));
        let sky = scene.aims_at_sky().then(|| "the sky where it is bright".to_owned());
        let aims: Vec<_> = lamps.into_iter().chain(sky).collect();
        words.push(if aims.is_empty() {
            "paths aim at nothing: they find light by chance".to_owned()
        } else {
            format!("paths aim at {}", aims.join("; and at "))
        });
        words.extend(guide_words(scene));
    } else if scene.has_lobes() {
        words.push("rough surfaces: a direction a sample is drawn at random, and few samples are noisy".to_owned());
    } else if scene.is_occluded() {
        words.push(
            "ambient light: a line a sample is drawn at random, and few samples are noisy; 64 are smooth".to_owned(),
        );
    }
    words.extend(dispersion_words(scene));
    words
}

/// Of what wavelengths light is, if that matters.
fn dispersion_words(scene: &Scene) -> Option<String> {
    scene.disperses().then(|| {
        if scene.rays.paths.is_some() {
            format!("dispersion: each path is of one wavelength, from {} to {} nm", VISIBLE.start(), VISIBLE.end())
        } else {
            format!("dispersion: all light is of {} nm; on paths it is of all visible", scene.rays.wavelength)
        }
    })
}

/// What guides paths, if anything does.
fn guide_words(scene: &Scene) -> Option<String> {
    let beam = |beam: &Beam| match beam.through {
        Some(object) => format!("from {} by {object}", beam.lamp.object),
        None => format!("from {}", beam.lamp.object),
    };
    let beams: Vec<_> = scene.beams().iter().map(beam).collect();
    let paths = scene.guide_grid().paths;
    (!beams.is_empty()).then(|| format!("light guides them, {paths} paths of it each: {}", beams.join(", ")))
}

/// What segments search, if there is anything.
fn structure_words(geometry: &Geometry) -> Option<String> {
    let Built { items, nodes, grid, .. } = &geometry.structure;
    let triangles = geometry.triangles.len();
    Some(match grid {
        _ if items.is_empty() => return None,
        Some(Grid { count: [x, y, z], .. }) => {
            format!("structure: {x}×{y}×{z} cells with {} entries, of them {triangles} triangles", items.len())
        }
        None if nodes.is_empty() => format!("structure: none, {} items, of them {triangles} triangles", items.len()),
        None => format!("structure: {} items, of them {triangles} triangles, in {} nodes", items.len(), nodes.len()),
    })
}

/// Frames that are looked at, at most: of longer films evenly, with the last.
const FRAMES: u32 = 256;

/// All frames are right, and run the first one's program.
fn check_frames(path: &Path, arguments: &Arguments, choice: &Choice, scene: &Scene) -> Result<(), Error> {
    let Some(animation) = &scene.animation else { return Ok(()) };
    let film = Film::new(path, arguments.changes.overrides()?);
    let first = film.program(choice, &|_| 0)?;
    let looked_at = animation.frames.min(FRAMES);
    let last = u64::from(animation.frames - 1);
    for i in 1..looked_at {
        let frame = (u64::from(i) * last / u64::from(looked_at - 1)) as u32;
        if !film.program(choice, &|_| frame)?.runs_as(&first) {
            return Err(film.other_program(&animation.keys, [0, frame]));
        }
    }
    if looked_at < animation.frames {
        say!("  of {} frames {looked_at} are checked, evenly from first to last", animation.frames);
    }
    say!("  {} frames of one program, in which {} change", animation.frames, animation.keys.join(", "));
    Ok(())
}

fn print_memory(scene: &Scene, program: &Program, choice: &Choice) -> Result<(), Error> {
    let memory = memory(program, choice.slots(scene));
    let items: Vec<_> = memory.items.iter().map(|(name, bytes)| format!("{name} {bytes}")).collect();
    say!("  {} bytes per pixel: {}", memory.bytes_per_pixel(), items.join(", "));
    Ok(())
}
