//! `bentray merge`: parts of a picture to the whole.

use std::path::PathBuf;

use clap::Args;

use super::{paths, screen};
use crate::error::Error;
use crate::output::assemble;

/// Put the parts of a picture together, EXRs rendered with --crop or --part: the same files as if it had been rendered at once
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The parts; where they overlap, they must agree
    #[arg(required = true, value_name = "PART", value_parser = paths::file())]
    parts: Vec<PathBuf>,
    /// Where to write the whole: .exr, or .png (repeatable)
    #[arg(short, long, required = true, value_name = "FILE", value_parser = paths::file())]
    output: Vec<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let parts: Vec<_> = arguments.parts.iter().map(|part| (part.clone(), "one of the parts")).collect();
    paths::check(arguments.output.iter().map(PathBuf::as_path), &parts)?;
    let _stage = screen::progress().stage("assembling the parts");
    Ok(assemble(&arguments.parts, &arguments.output)?)
}
