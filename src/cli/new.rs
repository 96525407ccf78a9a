//! `bentray new`: writes a scene to start from.

use std::path::PathBuf;

use clap::Args;
use clap::builder::TypedValueParser;

use super::options::one_of;
use super::paths::is_standard;
use super::written::{check_scene_name, say_written};
use crate::error::Error;
use crate::output::{AtomicFile, OutputError};
use crate::scene::{TEMPLATES, Template};

/// Write a commented scene to start from
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Output file, or - for standard output; an existing file is not replaced
    file: PathBuf,
    /// Template of the scene
    #[arg(long, value_parser = templates(), default_value = TEMPLATES[0].name)]
    template: &'static Template,
}

fn templates() -> impl TypedValueParser<Value = &'static Template> {
    one_of(TEMPLATES, |template| template.name, |template| template.about)
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let path = &arguments.file;
    if is_standard(path) {
        say!("{}", arguments.template.text.trim_end());
        return Ok(());
    }
    check_scene_name(path)?;
    if path.exists() {
        let problem = "the file exists already; name another file, or remove it first".to_owned();
        return Err(OutputError::Setting { path: path.clone(), problem }.into());
    }
    AtomicFile::write_whole(path, arguments.template.text.as_bytes())?;
    say_written(path)
}
