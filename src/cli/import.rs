//! `bentray import`: converts a file of another program to a scene.

use std::path::{Path, PathBuf};

use clap::Args;

use super::paths;
use super::written::{check_scene_name, say_written};
use crate::document::read_bytes;
use crate::error::Error;
use crate::output::{AtomicFile, OutputError};
use crate::scene::Gltf;
use crate::scene::import::import;

/// Write a scene from a glTF file: objects, materials, cameras and lights
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The input file, .gltf or .glb
    #[arg(value_parser = paths::file())]
    file: PathBuf,
    /// Output scene, or - for standard output; embedded images are written next to it, and no existing file is replaced
    #[arg(short, long, value_name = "SCENE")]
    output: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let Arguments { file: path, output } = arguments;
    check_scene_name(output)?;
    let bytes = read_bytes(path)?;
    let imported = import(&Gltf::open(bytes, path)?, output)?;
    let tell_left_out = || imported.left_out.iter().for_each(|line| tell!("{line}"));
    if paths::is_standard(output) {
        if let Some((name, _)) = imported.pictures.first() {
            let problem = format!(
                "-: embedded images such as {name} are written next to the scene, so the scene needs a file name"
            );
            return Err(Error::Usage(problem));
        }
        say!("{}", imported.text.trim_end());
        tell_left_out();
        return Ok(());
    }
    let folder = output.parent().unwrap_or(Path::new(""));
    let pictures = imported.pictures.iter().map(|(name, bytes)| (folder.join(name), bytes.as_slice()));
    // The scene is the last file, so that its images exist before it does.
    let files: Vec<(PathBuf, &[u8])> = pictures.chain([(output.clone(), imported.text.as_bytes())]).collect();
    if let Some((path, _)) = files.iter().rev().find(|(path, _)| path.exists()) {
        let problem = "the file exists already; name another scene, or remove it first".to_owned();
        return Err(OutputError::Setting { path: path.clone(), problem }.into());
    }
    for (path, bytes) in &files {
        AtomicFile::write_whole(path, bytes)?;
    }
    tell_left_out();
    say_written(output)
}
