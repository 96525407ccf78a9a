//! `bentray wgsl`: what a scene really runs.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use super::options::{SceneOptions, choice, schedules};
use crate::error::Error;
use crate::gpu::Geometry;
use crate::program::{Program, Schedule};
use crate::scene::Scene;

/// Print the linked program of a scene, pass by pass, with the part's file over each piece
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or - for standard input
    scene: PathBuf,
    /// Only this pass (setup, advance, shade, …)
    #[arg(long)]
    pass: Option<String>,
    #[command(flatten)]
    changes: SceneOptions,
    /// The schedule to link for
    #[arg(long, value_parser = schedules(), default_value = Schedule::Whole.name())]
    schedule: Schedule,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let scene = Scene::load(&arguments.scene, &arguments.changes.overrides()?)?;
    let geometry = Geometry::new(&scene);
    let program = Program::new(&scene, &geometry.analysis, &choice(arguments.schedule), geometry.extent())?;
    let names: Vec<_> = program.passes.iter().map(|(pass, _, _)| pass.entry()).collect();
    if let Some(wanted) = arguments.pass.as_deref().filter(|wanted| !names.contains(wanted)) {
        return Err(Error::Usage(format!("this program has no pass `{wanted}`; it has {}", names.join(", "))));
    }
    for (pass, linked, _) in &program.passes {
        if arguments.pass.as_deref().is_none_or(|wanted| wanted == pass.entry()) {
            say!("// ==== pass {}\n\n{}", pass.entry(), linked.source);
        }
    }
    Ok(ExitCode::SUCCESS)
}
