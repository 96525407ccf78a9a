//! What can go wrong on the way out: every message names the path and what to do.

use std::{io, path::PathBuf};

use crate::document::brief;

/// What to do about a write that failed, where something can be done.
fn remedy(cause: &io::Error) -> &'static str {
    match cause.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "; make room on the disk, or write elsewhere",
        io::ErrorKind::PermissionDenied => "; check the folder's permissions, or write elsewhere",
        _ => "",
    }
}

/// Why something was not written, or a table not read.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The folder that would hold the file is not there.
    #[error("{path}: the folder {folder} does not exist; create it, or write elsewhere")]
    MissingFolder {
        /// The file asked for.
        path: PathBuf,
        /// Its folder.
        folder: PathBuf,
    },
    /// The path is taken by something that is not a file.
    #[error("{path}: this is {what}, and only a regular file can be replaced; name another file")]
    NotAFile {
        /// The file asked for.
        path: PathBuf,
        /// What stands there, with its article.
        what: &'static str,
    },
    /// The file is there and marked read-only.
    #[error("{path}: the file is read-only; make it writable, or name another file")]
    ReadOnly {
        /// The file asked for.
        path: PathBuf,
    },
    /// No file can be made in the folder.
    #[error("{path}: cannot create a file in {folder}: {cause}; check the folder's permissions, or write elsewhere")]
    Create {
        /// The file asked for.
        path: PathBuf,
        /// Its folder.
        folder: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
    /// Writing broke off.
    #[error("{path}: writing failed: {cause}{} (an older file of this name is untouched)", remedy(cause))]
    Write {
        /// The file being written.
        path: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
    /// A table could not be written to standard output.
    #[error("standard output could not be written: {0}")]
    Stdout(io::Error),
    /// The extension names no format that can be written.
    #[error("{path}: the name must end in .png (colour to look at) or .exr (every plane, exact)")]
    Format {
        /// The file asked for.
        path: PathBuf,
    },
    /// The extension names no format of a plot.
    #[error("{path}: the name of a plot must end in .svg (shapes, to print) or .png (pixels)")]
    PlotFormat {
        /// The file asked for.
        path: PathBuf,
    },
    /// The settings do not suit the format.
    #[error("{path}: {problem}")]
    Setting {
        /// The file asked for.
        path: PathBuf,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A band is not the next one, or not shaped as promised.
    #[error("{path}: the band of rows from {row} does not fit: {problem}")]
    Band {
        /// The picture being written.
        path: PathBuf,
        /// The first row of the band.
        row: u32,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// The picture was finished before its last row.
    #[error("{path}: only {rows} of {height} rows were written; write the rest before finishing (no file was made)")]
    Incomplete {
        /// The picture being written.
        path: PathBuf,
        /// Rows written.
        rows: u32,
        /// Rows the picture has.
        height: u32,
    },
    /// The encoder refused, for a reason of its own.
    #[error("{path}: the picture could not be encoded: {problem}")]
    Encode {
        /// The picture being written.
        path: PathBuf,
        /// What the encoder said.
        problem: String,
    },
    /// A file could not be read.
    #[error("{path}: cannot read the file: {cause}; check its name and permissions")]
    Read {
        /// The file asked for.
        path: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
    /// A picture is no part of the whole that is to be put together.
    #[error("{path}: {}", brief(problem))]
    Part {
        /// The file being read, or the whole where a part of it is missing.
        path: PathBuf,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A table does not say what it should.
    #[error("{path}: line {line}: {}", brief(problem))]
    Table {
        /// The file being read.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column if it matters, the offending text, and what would be right.
        problem: String,
    },
    /// A plot could not be drawn.
    #[error("{path}: the plot could not be drawn: {problem}")]
    Plot {
        /// The plot being written.
        path: PathBuf,
        /// What is wrong, and what would be right.
        problem: String,
    },
}
