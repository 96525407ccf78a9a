//! Files as they come out.

mod diagrams;
mod files;
mod images;
mod parts;
mod plots;
mod precision;
mod report;
mod tables;

use std::path::{Path, PathBuf};

use tempfile::TempDir;

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> Vec<PathBuf> {
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into()).collect();
    names.sort();
    names
}
