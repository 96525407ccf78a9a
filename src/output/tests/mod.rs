//! Tests of output files.

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

/// Returns the names in a folder, sorted.
fn names(folder: &Path) -> Vec<PathBuf> {
    let mut names: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into()).collect();
    names.sort();
    names
}
