//! Scenes that a command writes for its user.

use std::path::Path;

use super::words::quoted;
use crate::error::Error;
use crate::output::{OutputError, is_film, is_picture};

/// Rejects the names of images and videos: a user who gives one intends to render.
pub(super) fn check_scene_name(path: &Path) -> Result<(), Error> {
    if !is_film(path) && !is_picture(path) {
        return Ok(());
    }
    let problem = "this command writes a scene, not an image; use a name such as scene.toml, then render it".to_owned();
    Err(OutputError::Setting { path: path.to_owned(), problem }.into())
}

/// Prints the next steps for a scene that was written.
pub(super) fn say_written(path: &Path) -> Result<(), Error> {
    let command = ["bentray", "render", &path.display().to_string(), "-o", "picture.png"].map(str::to_owned);
    say!("wrote {}; render it with `{}`", path.display(), quoted(&command));
    Ok(())
}
