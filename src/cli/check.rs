//! `bentray check`: is a scene right, and what will be modelled?

mod mistakes;
mod modelled;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use serde_json::{Value, json};

use self::mistakes::Wrong;
use self::modelled::Modelled;
use super::format::{Format, Found};
use super::frames::Film;
use super::options::{SceneOptions, choice, schedules};
use crate::error::Error;
use crate::gpu::{Geometry, memory};
use crate::program::{Choice, Program, Schedule};
use crate::scene::{KeyReference, REFERENCE, Scene, reference_markdown};

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
    #[command(flatten)]
    format: Format,
}

/// Every scene is checked, and every mistake reported, before the exit code says whether there were any.
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
                arguments.format.tell(&Wrong { path, error })?;
                code = ExitCode::FAILURE;
            }
        }
    }
    Ok(code)
}

fn check<'a>(path: &'a Path, arguments: &Arguments) -> Result<Modelled<'a>, Error> {
    let scene = Scene::load(path, &arguments.changes.overrides()?)?;
    let geometry = Geometry::new(&scene);
    let choice = choice(arguments.schedule);
    let program = Program::new(&scene, &geometry.analysis, &choice, geometry.extent())?;
    let memory = memory(&program, choice.slots(&scene));
    let frames_checked = check_frames(path, arguments, &choice, &scene)?;
    Ok(Modelled { path, scene, geometry, program, memory, frames_checked })
}

/// Frames that are looked at, at most: of longer films evenly, with the last.
const FRAMES: u32 = 256;

/// All frames are right, and run the first one's program. Says how many of them were looked at.
fn check_frames(path: &Path, arguments: &Arguments, choice: &Choice, scene: &Scene) -> Result<u32, Error> {
    let Some(animation) = &scene.animation else { return Ok(0) };
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
    Ok(looked_at)
}

/// Every key of the scene format.
struct Reference;

impl Found for Reference {
    fn text(&self) -> String {
        reference_markdown()
    }

    fn json(&self) -> Value {
        let row = |key: &KeyReference| {
            json!({
                "table": key.table,
                "key": key.key,
                "when": key.when,
                "value": key.value,
                "default": key.default,
                "meaning": key.meaning,
            })
        };
        json!({ "keys": REFERENCE.iter().map(row).collect::<Vec<_>>() })
    }
}
