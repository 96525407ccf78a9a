//! `bentray devices`: what could render.

use std::process::ExitCode;

use clap::Args;

use crate::error::Error;
use crate::gpu::{GpuError, adapters};

/// List the devices that could render, best first, and what each can do
#[derive(Debug, Args)]
pub(super) struct Arguments {}

pub(super) fn run(_: &Arguments) -> Result<ExitCode, Error> {
    let adapters = adapters();
    if adapters.is_empty() {
        return Err(GpuError::NoDevice.into());
    }
    for adapter in adapters {
        let info = &adapter.info;
        say!("{} ({:?}, {})", info.name, info.device_type, info.backend);
        say!("    driver              {} {}", info.driver, info.driver_info);
        say!("    largest texture     {0} × {0}", adapter.texture_side);
        say!("    largest buffer      {} MiB", adapter.storage_buffer >> 20);
        say!("    storage textures    {} a pass", adapter.storage_textures);
        say!("    timestamps          {}", if adapter.timestamps { "yes" } else { "no" });
        say!("    f64                 {}", if adapter.f64 { "yes" } else { "no" });
    }
    Ok(ExitCode::SUCCESS)
}
