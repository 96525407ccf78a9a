//! Combines the errors of all stages in one type.

use thiserror::Error;

use crate::gpu::GpuError;
use crate::output::OutputError;
use crate::program::ProgramError;
use crate::render::RenderError;
use crate::scene::SceneError;

/// The error of a command.
#[derive(Debug, Error)]
pub enum Error {
    /// The scene file is invalid.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// The scene's program cannot be generated.
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
    /// The reader of standard output closed it, which is not a failure.
    #[error("standard output was closed")]
    Closed,
    /// A frame of an animation, or a shutter sample of that frame, is invalid.
    #[error("frame {frame}: {error}")]
    Frame {
        /// The number of the frame.
        frame: f64,
        /// The error of the frame.
        error: Box<Self>,
    },
    /// A word of the command line is invalid for this scene.
    #[error("{0}")]
    Usage(String),
    /// A file could not be written, or a table could not be read.
    #[error("{0}")]
    Output(#[from] OutputError),
}
