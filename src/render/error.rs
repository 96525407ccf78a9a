//! The errors of a render.

use thiserror::Error;

use super::Window;
use crate::gpu::GpuError;
use crate::program::ProgramError;

/// An error of an image or a trace.
#[derive(Debug, Error)]
pub enum RenderError {
    /// The program could not be linked.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// The device refused or failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The scene has no camera.
    #[error(
        "the scene has no [camera]: add one, such as\n    [camera]\n    position = [0, 2, 15]\n    look_at = [0, 0, 0]"
    )]
    NoCamera,
    /// The requested window is not inside the image.
    #[error(
        "the window {window} is not inside the image of {}x{} pixels; use X,Y,WxH with its left column, top row and \
         size",
        .picture[0], .picture[1]
    )]
    Window {
        /// The requested window.
        window: Window,
        /// The size of the image.
        picture: [u32; 2],
    },
    /// The lights' grids alone exceed the memory budget.
    #[error(
        "the photon grids have {voxels} voxels and need {needed} bytes of device memory, but {allowed} are allowed: \
         raise --memory, or lower the `voxels` of the lights"
    )]
    LightGrid {
        /// The number of voxels of all lights.
        voxels: usize,
        /// The bytes that would suffice.
        needed: u64,
        /// The memory budget, in bytes.
        allowed: u64,
    },
    /// More light passed through a voxel than its sums can hold.
    #[error(
        "lights[{light}]: its paths cross one voxel of the photon grid more often than it can count; raise `voxels`"
    )]
    LightLost {
        /// The index of the light in the scene file.
        light: usize,
    },
    /// The camera has no ray for a pixel, for example outside the disk of a fisheye.
    #[error("the camera has no ray through pixel {},{}, where the image is empty", .pixel[0], .pixel[1])]
    NoRay {
        /// The column and row of the pixel.
        pixel: [u32; 2],
    },
    /// The scene requires another program than the compiled one.
    #[error("this scene requires a different shader program than the compiled one")]
    OtherProgram,
    /// The measurement needs the time of a pass, which the device cannot measure.
    #[error("this device cannot time its passes, because it has no timestamp queries")]
    NoTimes,
    /// The consumer of finished rows failed.
    #[error("{0}")]
    Output(Box<dyn std::error::Error + Send + Sync>),
}
