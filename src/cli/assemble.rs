//! `bentray assemble`: parts of a picture to the whole.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use super::paths;
use crate::error::Error;
use crate::output::assemble;

/// Put the parts of a picture together, EXRs rendered with --crop: the same file as if it had been rendered at once
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The parts; where they overlap, they must agree
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
    /// Where to write the whole: .exr
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    if !arguments.output.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("exr")) {
        return Err(Error::Usage(format!(
            "{}: a whole is an EXR, so its name must end in .exr",
            arguments.output.display()
        )));
    }
    let parts: Vec<_> = arguments.parts.iter().map(|part| (part.clone(), "one of the parts")).collect();
    paths::check([arguments.output.as_path()], &parts)?;
    assemble(&arguments.parts, &arguments.output)?;
    Ok(ExitCode::SUCCESS)
}
