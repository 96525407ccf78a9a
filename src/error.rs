//! Every stage's errors, as one.

use thiserror::Error;

use crate::gpu::GpuError;
use crate::output::OutputError;
use crate::program::ProgramError;
use crate::render::RenderError;
use crate::scene::SceneError;

/// What a command can fail with.
#[derive(Debug, Error)]
pub enum Error {
    /// The scene file is wrong.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The scene's program cannot be made.
    #[error("{0}")]
    Program(#[from] ProgramError),
    /// The device is missing or too small.
    #[error("{0}")]
    Gpu(#[from] GpuError),
    /// The render failed.
    #[error("{0}")]
    Render(#[from] RenderError),
    /// Standard output could not be written.
    #[error("standard output could not be written: {0}")]
    Stdout(std::io::Error),
    /// Whoever read standard output has had enough: no failure.
    #[error("standard output was closed")]
    Closed,
    /// A frame of a film, or a moment after it while the shutter is open, is wrong.
    #[error("frame {frame}: {error}")]
    Frame {
        /// Which.
        frame: f64,
        /// What is wrong with it.
        error: Box<Self>,
    },
    /// A word of the command line that only the scene can tell wrong.
    #[error("{0}")]
    Usage(String),
    /// A file could not be written, or a table not read.
    #[error("{0}")]
    Output(#[from] OutputError),
}
