//! `bentray import`: a scene from a file of another program.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use crate::error::Error;
use crate::output::{AtomicFile, OutputError};
use crate::scene::import::import;
use crate::scene::{Gltf, SceneError};

/// Write a scene from a glTF file: objects, materials, cameras and lights
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The file, .gltf or .glb
    file: PathBuf,
    /// Where to write the scene; pictures within the file are written beside it, and nothing that is there already is replaced
    #[arg(short, long, value_name = "SCENE")]
    output: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let Arguments { file: path, output } = arguments;
    let bytes = std::fs::read(path).map_err(|source| SceneError::Read { path: path.clone(), source })?;
    let imported = import(&Gltf::open(bytes, path)?, output)?;
    let folder = output.parent().unwrap_or(Path::new(""));
    let pictures = imported.pictures.iter().map(|(name, bytes)| (folder.join(name), bytes.as_slice()));
    // The scene last: where it is, its pictures are.
    let files: Vec<(PathBuf, &[u8])> = pictures.chain([(output.clone(), imported.text.as_bytes())]).collect();
    if let Some((path, _)) = files.iter().rev().find(|(path, _)| path.exists()) {
        let problem = "this file exists; name another scene, or remove it first".to_owned();
        return Err(OutputError::Setting { path: path.clone(), problem }.into());
    }
    for (path, bytes) in &files {
        let mut file = AtomicFile::create(path)?;
        file.write_all(bytes).map_err(|cause| OutputError::Write { path: path.clone(), cause })?;
        file.finish()?;
    }
    for line in &imported.left_out {
        tell!("{line}");
    }
    say!("wrote {0}; render it with `bentray render {0} -o picture.png`", output.display());
    Ok(ExitCode::SUCCESS)
}
