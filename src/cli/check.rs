//! `bentray check`: validates scenes, and prints what will be compiled.

mod catalogs;
mod mistakes;
mod modelled;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use serde_json::{Value, json};

use self::mistakes::InvalidScene;
use self::modelled::Modelled;
use super::format::{CommandResult, Format};
use super::frames::Film;
use super::options::{SceneOptions, program_options, schedules};
use crate::error::Error;
use crate::gpu::{Geometry, adapters, check_meshes, memory};
use crate::program::{Program, ProgramOptions, Schedule};
use crate::scene::{REFERENCE, Scene, reference_markdown};

/// Validate scenes, and print what will be compiled: modules, passes, bytes per pixel
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene files; - is standard input
    #[arg(required_unless_present = "reference")]
    scenes: Vec<PathBuf>,
    /// Print every key of the scene format instead
    #[arg(long)]
    reference: bool,
    /// Print the shader modules of each pass, as files of shaders/
    #[arg(long)]
    parts: bool,
    /// Print the dispatches of one iteration of a sample
    #[arg(long)]
    commands: bool,
    #[command(flatten)]
    changes: SceneOptions,
    /// Schedule for which passes and memory are counted
    #[arg(long, value_parser = schedules(), default_value = Schedule::Whole.name())]
    schedule: Schedule,
    #[command(flatten)]
    format: Format,
}

/// Checks every scene, reports every error, and returns an exit code that reports whether there were any.
pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    if arguments.reference {
        arguments.format.say(&Reference)?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut code = ExitCode::SUCCESS;
    for path in &arguments.scenes {
        match check(path, arguments) {
            Ok(modelled) => arguments.format.say(&modelled)?,
            Err(error) => {
                arguments.format.tell(&InvalidScene { path, error })?;
                code = ExitCode::FAILURE;
            }
        }
    }
    Ok(code)
}

fn check<'a>(path: &'a Path, arguments: &Arguments) -> Result<Modelled<'a>, Error> {
    let film = Film::new(path, arguments.changes.overrides()?).on(None);
    let scene = film.load(None)?;
    let geometry = Geometry::new(&scene);
    let options = program_options(arguments.schedule);
    let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent())?;
    if scene.objects.iter().any(|object| object.shape.mesh().is_some())
        && let Some(device) = adapters().first()
    {
        check_meshes(&program, &geometry, device)?;
    }
    let memory = memory(&program);
    let frames_checked = check_frames(&film, &options, &scene)?;
    Ok(Modelled {
        path,
        scene,
        geometry,
        program,
        memory,
        frames_checked,
        names_parts: arguments.parts,
        names_commands: arguments.commands,
    })
}

/// The maximum number of frames that are checked.
const FRAMES: usize = 256;

/// Checks that the frames are valid and run the first frame's program. Returns the number of frames that were checked.
fn check_frames(film: &Film, options: &ProgramOptions, scene: &Scene) -> Result<u32, Error> {
    let Some(animation) = &scene.animation else { return Ok(0) };
    film.look_ahead(options, animation, &(0..animation.frames).collect::<Vec<_>>(), FRAMES)
}

/// Every key of the scene format.
struct Reference;

impl CommandResult for Reference {
    fn text(&self) -> String {
        reference_markdown()
    }

    fn json(&self) -> Value {
        json!({ "keys": *REFERENCE })
    }
}
