//! `bentray merge`: combines parts of an image.

use std::path::PathBuf;

use clap::Args;

use super::{paths, screen};
use crate::error::Error;
use crate::output::merge;

/// Combine the parts of an image (EXRs rendered with --crop or --part) into the files that one whole render would write
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The parts; overlapping parts must agree
    #[arg(required = true, value_name = "PART", value_parser = paths::file())]
    parts: Vec<PathBuf>,
    /// Output file: .exr, .npz, .npy, .fits, .h5 or .png (repeatable)
    #[arg(short, long, required = true, value_name = "FILE", value_parser = paths::file())]
    output: Vec<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let parts: Vec<_> = arguments.parts.iter().map(|part| (part.clone(), "one of the parts")).collect();
    paths::check(arguments.output.iter().map(PathBuf::as_path), &parts)?;
    let _stage = screen::progress().stage("assembling the parts");
    Ok(merge(&arguments.parts, &arguments.output)?)
}
