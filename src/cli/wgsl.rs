//! `bentray wgsl`: prints the program that a scene runs.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;

use super::options::{SceneOptions, program_options, schedules};
use crate::error::Error;
use crate::gpu::{Geometry, adapters};
use crate::program::{DeviceProfile, Program, ProgramOptions, Schedule};
use crate::scene::Scene;

/// Print the linked program of a scene, pass by pass, with the module's file name above each piece
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The scene file, or - for standard input
    scene: PathBuf,
    /// Print only this pass (setup, advance, shade, …)
    #[arg(long)]
    pass: Option<String>,
    #[command(flatten)]
    changes: SceneOptions,
    /// Schedule for which the program is linked
    #[arg(long, value_parser = schedules(), default_value = Schedule::Whole.name())]
    schedule: Schedule,
    /// Kind of device for which the program is linked [default: the best device of this machine]
    #[arg(long, value_name = "DEVICE", value_parser = PossibleValuesParser::new(DeviceProfile::NAMES))]
    for_device: Option<String>,
}

/// Returns the profile to link for: of the requested kind of device, or of the device that would render here.
fn profile(asked: Option<&str>) -> DeviceProfile {
    let here = || adapters().first().map(|device| device.profile);
    asked.map_or_else(here, DeviceProfile::named).unwrap_or_default()
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let scene = Scene::load(&arguments.scene, &arguments.changes.overrides()?)?;
    let geometry = Geometry::new(&scene);
    let options =
        ProgramOptions { device: profile(arguments.for_device.as_deref()), ..program_options(arguments.schedule) };
    let program = Program::new(&scene, &geometry.analysis, &options, geometry.extent())?;
    let names: Vec<_> = program.passes.iter().map(|(pass, _, _)| pass.entry()).collect();
    if let Some(wanted) = arguments.pass.as_deref().filter(|wanted| !names.contains(wanted)) {
        return Err(usage!("unknown pass `{wanted}`; the passes of this program are {}", names.join(", ")));
    }
    for (pass, linked, _) in &program.passes {
        if arguments.pass.as_deref().is_none_or(|wanted| wanted == pass.entry()) {
            say!("// ==== pass {}\n\n{}", pass.entry(), linked.source);
        }
    }
    Ok(())
}
