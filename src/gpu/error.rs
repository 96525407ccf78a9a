//! What can go wrong on the way to a device and on it.

use thiserror::Error;

fn others(there: &[String]) -> String {
    if there.is_empty() { String::new() } else { format!(" ({})", there.join(", ")) }
}

/// What to do about a limit, where something can be done.
fn remedy(limit: &str) -> &'static str {
    match limit {
        "max_storage_buffer_binding_size" => ": use fewer triangles or objects, or a coarser grid",
        "max_texture_dimension_2d" => ": use a smaller picture for it",
        _ => "",
    }
}

/// A device that is missing, too small, or failed.
#[derive(Debug, Error)]
pub enum GpuError {
    /// No adapter at all.
    #[error(
        "no Vulkan, Metal or DX12 device found; for one on the processor, install Mesa's: `apt-get install \
         mesa-vulkan-drivers` (Debian, Ubuntu), `dnf install mesa-vulkan-drivers` (Fedora), `pacman -S vulkan-swrast` (Arch)"
    )]
    NoDevice,
    /// No adapter of that name.
    #[error("no device named `{wanted}`; there are: {}", .there.join(", "))]
    NoSuchDevice {
        /// What was asked for.
        wanted: String,
        /// What there is.
        there: Vec<String>,
    },
    /// The driver refused.
    #[error("{device} could not be opened: {reason}")]
    Refused {
        /// The adapter's name.
        device: String,
        /// The driver's words.
        reason: String,
    },
    /// A limit of the device is too low for the scene.
    #[error("{device} allows {allowed} {what}, and this scene needs {needed} ({limit}){}", remedy(limit))]
    Limit {
        /// The adapter's name.
        device: String,
        /// wgpu's name of the limit.
        limit: &'static str,
        /// What it counts.
        what: String,
        /// Its value.
        allowed: u64,
        /// What would be enough.
        needed: u64,
    },
    /// The budget is too small for any tile.
    #[error(
        "{allowed} bytes of device memory are too few: this scene needs at least {needed} for the smallest tile; raise --memory"
    )]
    Memory {
        /// The budget.
        allowed: u64,
        /// What would be enough.
        needed: u64,
    },
    /// The device has no memory left.
    #[error(
        "the device has no memory left for {what} ({reason}): lower --memory, render at a smaller --size, or use another device"
    )]
    Full {
        /// What it was for.
        what: String,
        /// The driver's words.
        reason: String,
    },
    /// The device has no 64-bit numbers.
    #[error("{device} has no 64-bit numbers in shaders: use precision f32, or another device{}", others(.there))]
    NoDouble {
        /// The adapter's name.
        device: String,
        /// Those that have them.
        there: Vec<String>,
    },
    /// The host's values do not fit the WGSL's layout: a slip in the program, found before anything runs.
    #[error("`{binding}`: {problem}")]
    Layout {
        /// The binding.
        binding: String,
        /// What does not fit.
        problem: String,
    },
    /// The driver refused a pass.
    #[error("the driver refused the pass `{pass}`: {reason}")]
    Pass {
        /// Its entry point.
        pass: String,
        /// The driver's words.
        reason: String,
    },
    /// The device stopped answering.
    #[error("the device stopped answering: {0}")]
    Lost(String),
}
