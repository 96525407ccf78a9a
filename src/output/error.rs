//! Output errors, whose messages contain the path and a remedy.

use std::{io, path::PathBuf};

use crate::document::brief;

/// Returns the remedy for a failed write, if there is one.
fn remedy(cause: &io::Error) -> &'static str {
    match cause.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "; make room on the disk, or write elsewhere",
        io::ErrorKind::PermissionDenied => "; check the folder's permissions, or write elsewhere",
        _ => "",
    }
}

/// An error in writing a file or reading a table.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The folder of the file does not exist.
    #[error("{path}: the folder {folder} does not exist; create it, or write elsewhere")]
    MissingFolder {
        /// The requested file.
        path: PathBuf,
        /// The folder of the file.
        folder: PathBuf,
    },
    /// The path is not a regular file.
    #[error("{path}: this is {what}, and only a regular file can be replaced; name another file")]
    NotAFile {
        /// The requested file.
        path: PathBuf,
        /// The type of the existing item, with its article.
        what: &'static str,
    },
    /// The file exists and is read-only.
    #[error("{path}: the file is read-only; make it writable, or name another file")]
    ReadOnly {
        /// The requested file.
        path: PathBuf,
    },
    /// No file can be created in the folder.
    #[error("{path}: cannot create a file in {folder} ({cause}); check the folder's permissions, or write elsewhere")]
    Create {
        /// The requested file.
        path: PathBuf,
        /// The folder of the file.
        folder: PathBuf,
        /// The error of the operating system.
        cause: io::Error,
    },
    /// Writing failed.
    #[error("{path}: writing failed ({cause}){} (an existing file with this name is unchanged)", remedy(cause))]
    Write {
        /// The file being written.
        path: PathBuf,
        /// The error of the operating system.
        cause: io::Error,
    },
    /// A table could not be written to standard output.
    #[error("standard output could not be written: {0}")]
    Stdout(io::Error),
    /// The extension is not that of a supported image format.
    #[error(
        "{path}: the name must end in .png (color, for viewing), in .exr, .npz, .fits or .h5 (all layers, exact), or in .npy (color)"
    )]
    Format {
        /// The requested file.
        path: PathBuf,
    },
    /// The extension is not that of a supported plot format.
    #[error("{path}: the name of a plot must end in .svg (vector graphics) or .png (pixels)")]
    PlotFormat {
        /// The requested file.
        path: PathBuf,
    },
    /// The settings are invalid for the format.
    #[error("{path}: {problem}")]
    Setting {
        /// The requested file.
        path: PathBuf,
        /// The problem and the remedy.
        problem: String,
    },
    /// A band is not the next one, or has the wrong planes.
    #[error("{path}: the band of rows from {row} does not fit: {problem}")]
    Band {
        /// The image being written.
        path: PathBuf,
        /// The first row of the band.
        row: u32,
        /// The problem and the remedy.
        problem: String,
    },
    /// The image was finished before its last row.
    #[error("{path}: only {rows} of {height} rows were written; write the rest before finishing (no file was created)")]
    Incomplete {
        /// The image being written.
        path: PathBuf,
        /// The number of rows written.
        rows: u32,
        /// The number of rows of the image.
        height: u32,
    },
    /// The encoder failed.
    #[error("{path}: the image could not be encoded: {problem}")]
    Encode {
        /// The image being written.
        path: PathBuf,
        /// The message of the encoder.
        problem: String,
    },
    /// A file could not be read.
    #[error("{path}: cannot read the file ({cause}); check its name and permissions")]
    Read {
        /// The requested file.
        path: PathBuf,
        /// The error of the operating system.
        cause: io::Error,
    },
    /// A file is not a part of the image to be merged.
    #[error("{path}: {}", brief(problem))]
    Part {
        /// The file being read, or the output if a part is missing.
        path: PathBuf,
        /// The problem and the remedy.
        problem: String,
    },
    /// A table is invalid.
    #[error("{path}: line {line}: {}", brief(problem))]
    Table {
        /// The file being read.
        path: PathBuf,
        /// The line number, from 1.
        line: usize,
        /// The column if it matters, the invalid text, and the remedy.
        problem: String,
    },
    /// A plot could not be drawn.
    #[error("{path}: the plot could not be drawn: {problem}")]
    Plot {
        /// The plot being written.
        path: PathBuf,
        /// The problem and the remedy.
        problem: String,
    },
}
