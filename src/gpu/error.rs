//! The errors of opening and using a device.

use thiserror::Error;

fn others(there: &[String]) -> String {
    if there.is_empty() { String::new() } else { format!(" ({})", there.join(", ")) }
}

/// Returns a remedy for an exceeded limit, if there is one. what: the limited quantity.
fn remedy(limit: &str, what: &str) -> &'static str {
    match limit {
        _ if what.contains("`star_list`") => ": show fewer stars, by a lower `sky.stars.limit`",
        "max_storage_buffer_binding_size" => ": use fewer triangles or objects, or a coarser grid",
        "max_texture_dimension_2d" => ": use a smaller image",
        _ => "",
    }
}

/// A device that is missing, too small, or failed.
#[derive(Debug, Error)]
pub enum GpuError {
    /// There is no adapter.
    #[error(
        "no Vulkan, Metal or DX12 device found; to render on the CPU, install Mesa's lavapipe: `apt-get install \
         mesa-vulkan-drivers` (Debian, Ubuntu), `dnf install mesa-vulkan-drivers` (Fedora), `pacman -S \
         vulkan-swrast` (Arch)"
    )]
    NoDevice,
    /// No adapter has this name.
    #[error("no device named `{wanted}`; available: {}", .there.join(", "))]
    NoSuchDevice {
        /// The requested name.
        wanted: String,
        /// The names of the available devices.
        there: Vec<String>,
    },
    /// The driver refused to open the device.
    #[error("{device} could not be opened: {reason}")]
    Refused {
        /// The adapter's name.
        device: String,
        /// The driver's message.
        reason: String,
    },
    /// A limit of the device is too low for the scene.
    #[error("{device} allows {allowed} {what}, but this scene needs {needed} ({limit}){}", remedy(limit, what))]
    Limit {
        /// The adapter's name.
        device: String,
        /// The name of the limit in wgpu.
        limit: &'static str,
        /// A description of the limited quantity.
        what: String,
        /// The value of the limit.
        allowed: u64,
        /// The value that the scene needs.
        needed: u64,
    },
    /// The memory budget is too small for any tile.
    #[error(
        "{allowed} bytes of device memory are too few: this scene needs at least {needed} for the smallest tile; raise --memory"
    )]
    Memory {
        /// The memory budget, in bytes.
        allowed: u64,
        /// The bytes that would suffice.
        needed: u64,
    },
    /// The device has no memory left.
    #[error(
        "the device has no memory left for {what} ({reason}): lower --memory, render at a smaller --size, or use another device"
    )]
    Full {
        /// The purpose of the memory.
        what: String,
        /// The driver's message.
        reason: String,
    },
    /// The device has no 64-bit numbers.
    #[error("{device} does not support 64-bit floats in shaders: use precision f32, or another device{}", others(.there))]
    NoDouble {
        /// The adapter's name.
        device: String,
        /// The names of the devices that support them.
        there: Vec<String>,
    },
    /// The host's values do not match the WGSL's layout: an error in the program, found before anything runs.
    #[error("`{binding}`: {problem}")]
    Layout {
        /// The binding.
        binding: String,
        /// The mismatch.
        problem: String,
    },
    /// The driver rejected a pass.
    #[error("the driver rejected the pass `{pass}`: {reason}")]
    Pass {
        /// The entry point of the pass.
        pass: String,
        /// The driver's message.
        reason: String,
    },
    /// The work was cancelled ([`Progress::cancel`](crate::progress::Progress::cancel)).
    #[error("the work was cancelled")]
    Cancelled,
    /// The device stopped answering.
    #[error("the device stopped responding: {0}")]
    Lost(String),
}
