//! Files that a command reads and writes: which names are one file, so that nothing is written over what is read.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use crate::error::Error;

/// What two names of one file have in common, whether it is there or not.
fn identity(path: &Path) -> PathBuf {
    if let Ok(found) = path.canonicalize() {
        return found;
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    path.file_name().map_or_else(|| folder.clone(), |name| folder.join(name))
}

/// Refuses to write two things to one file, or over what is read: each of these with what it is.
pub(super) fn check<'a>(
    outputs: impl IntoIterator<Item = &'a Path>,
    inputs: &[(PathBuf, &'static str)],
) -> Result<(), Error> {
    let read: HashMap<PathBuf, &str> = inputs.iter().map(|(path, what)| (identity(path), *what)).collect();
    let mut written: HashMap<PathBuf, &Path> = HashMap::new();
    for path in outputs.into_iter().filter(|path| *path != Path::new("-")) {
        let own = identity(path);
        let shown = path.display();
        if let Some(what) = read.get(&own) {
            return Err(Error::Usage(format!("{shown}: this is {what}, which would be lost: name another file")));
        }
        if let Some(other) = written.insert(own, path) {
            let other = if other == path { String::new() } else { format!(" as {}", other.display()) };
            return Err(Error::Usage(format!("{shown} is named twice{other}: a file holds one thing")));
        }
    }
    Ok(())
}
