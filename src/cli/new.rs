//! `bentray new`: a scene to start from.

use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::error::Error;
use crate::output::{AtomicFile, OutputError};
use crate::scene::TEMPLATE;

/// Write a commented scene to start from
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Where to write it; a file that is there already is left alone
    file: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let path = &arguments.file;
    if path.exists() {
        let problem = "this file exists; name another, or remove it first".to_owned();
        return Err(OutputError::Setting { path: path.clone(), problem }.into());
    }
    let mut file = AtomicFile::create(path)?;
    file.write_all(TEMPLATE.as_bytes()).map_err(|cause| OutputError::Write { path: path.clone(), cause })?;
    file.finish()?;
    say!("wrote {0}; render it with `bentray render {0} -o picture.png`", path.display());
    Ok(ExitCode::SUCCESS)
}
