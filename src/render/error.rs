//! What can go wrong in a render.

use thiserror::Error;

use super::Window;
use crate::gpu::GpuError;
use crate::program::ProgramError;

/// A picture or a trace that could not be made.
#[derive(Debug, Error)]
pub enum RenderError {
    /// The program could not be linked.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// The device refused or failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// There is nothing to look through.
    #[error(
        "the scene has no [camera]: add one, such as\n    [camera]\n    position = [0, 2, 15]\n    look_at = [0, 0, 0]"
    )]
    NoCamera,
    /// There is no such part.
    #[error(
        "{window} is not inside the picture of {} by {} pixels: a part is X,Y,WxH, its left column, top row and size",
        .picture[0], .picture[1]
    )]
    Window {
        /// What was to be rendered.
        window: Window,
        /// The picture's size.
        picture: [u32; 2],
    },
    /// The lights' grids alone are more than the budget.
    #[error(
        "the lights' grids have {voxels} voxels together and need {needed} bytes of device memory, and {allowed} are allowed: give them \
         more, or the lights fewer `voxels`"
    )]
    LightGrid {
        /// Of all lights.
        voxels: usize,
        /// What would be enough.
        needed: u64,
        /// The budget.
        allowed: u64,
    },
    /// More light came through a voxel than its sums can hold.
    #[error(
        "light {light} (from 0): its paths wind more often through one voxel of its grid than that can count; give it more `voxels`"
    )]
    LightLost {
        /// The light's place in the scene file.
        light: usize,
    },
    /// A pixel that the camera has no ray for, as outside a fisheye's disk.
    #[error("the camera has no ray through pixel {},{}: the picture shows nothing there", .pixel[0], .pixel[1])]
    NoRay {
        /// Its column and row.
        pixel: [u32; 2],
    },
    /// A scene that needs passes of its own.
    #[error("this scene needs another program than the one that was compiled")]
    OtherProgram,
    /// What is measured is a pass.
    #[error("this device does not tell how long its passes take: it has no timestamp queries")]
    NoTimes,
    /// The consumer of finished rows failed.
    #[error("{0}")]
    Output(Box<dyn std::error::Error + Send + Sync>),
}
