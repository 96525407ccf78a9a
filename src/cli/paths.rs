//! The files that a command reads and writes. Detects different names of one file, so that no input is overwritten.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use clap::builder::{PathBufValueParser, TypedValueParser};

use crate::error::Error;
use crate::output::destination;

/// Returns a path that is equal for all names of one file, even if the file does not exist yet.
fn identity(path: &Path) -> PathBuf {
    let path = destination(path);
    if path.exists() {
        return path;
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    path.file_name().map_or_else(|| folder.clone(), |name| folder.join(name))
}

/// Returns `true` for the path that means standard input or output.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Creates a parser for the name of a file, which cannot be standard input or output.
pub(super) fn file() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| if is_standard(&path) { Err(NO_STREAM) } else { Ok(path) })
}

/// The error for files that need a name.
pub(super) const NO_STREAM: &str =
    "standard input and output are not supported here: name a file (`./-` for a file called -)";

/// Rejects outputs that share a file, or that would overwrite an input. Each input comes with its description.
pub(super) fn check<'a>(
    outputs: impl IntoIterator<Item = &'a Path>,
    inputs: &[(PathBuf, &'static str)],
) -> Result<(), Error> {
    let (streams, files): (Vec<_>, Vec<_>) = inputs.iter().partition(|(path, _)| is_standard(path));
    if let [(_, one), (_, other), ..] = streams[..] {
        return Err(usage!("-: standard input cannot be both {one} and {other}; name a file for one of them"));
    }
    let read: HashMap<PathBuf, &str> = files.into_iter().map(|(path, what)| (identity(path), *what)).collect();
    let mut written: HashMap<PathBuf, &Path> = HashMap::new();
    for path in outputs.into_iter().filter(|path| !is_standard(path)) {
        let own = identity(path);
        let shown = path.display();
        if let Some(what) = read.get(&own) {
            return Err(usage!("{shown} is {what} and would be overwritten: name another file"));
        }
        if let Some(other) = written.insert(own, path) {
            let other = if other == path { String::new() } else { format!(" (also as {})", other.display()) };
            return Err(usage!("{shown} is used for two outputs{other}: name another file"));
        }
    }
    Ok(())
}
