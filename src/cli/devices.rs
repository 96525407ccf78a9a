//! `bentray devices`: lists the devices that can render.

use clap::Args;
use serde_json::{Value, json};

use super::format::{CommandResult, Format};
use crate::error::Error;
use crate::gpu::{AdapterReport, GpuError, adapters};

/// List the devices that can render, best first, with their capabilities
#[derive(Debug, Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let adapters = adapters();
    if adapters.is_empty() {
        return Err(GpuError::NoDevice.into());
    }
    arguments.format.say(&Devices(adapters))
}

/// The devices that can render, best first.
pub(super) struct Devices(pub Vec<AdapterReport>);

impl CommandResult for Devices {
    fn text(&self) -> String {
        self.0.iter().map(words).collect::<Vec<_>>().join("\n")
    }

    fn json(&self) -> Value {
        json!({ "devices": self.0.iter().map(object).collect::<Vec<_>>() })
    }
}

fn words(adapter: &AdapterReport) -> String {
    let info = &adapter.info;
    let rows = [
        ("driver", format!("{} {}", info.driver, info.driver_info)),
        ("largest texture", format!("{0} × {0}", adapter.texture_side)),
        ("largest buffer", format!("{} MiB", adapter.storage_buffer >> 20)),
        ("storage textures", format!("{} per pass", adapter.storage_textures)),
        ("timestamps", yes(adapter.timestamps)),
        ("f64", yes(adapter.f64)),
    ];
    let rows = rows.iter().map(|(name, value)| format!("\n    {name:<20}{value}"));
    let name = format!("{} ({:?}, {})", info.name, info.device_type, info.backend);
    [name].into_iter().chain(rows).collect()
}

fn yes(is_so: bool) -> String {
    if is_so { "yes" } else { "no" }.to_owned()
}

fn object(adapter: &AdapterReport) -> Value {
    let info = &adapter.info;
    json!({
        "name": info.name,
        "kind": format!("{:?}", info.device_type),
        "backend": info.backend.to_string(),
        "driver": info.driver,
        "driver_info": info.driver_info,
        "texture_side_pixels": adapter.texture_side,
        "buffer_bytes": adapter.storage_buffer,
        "storage_textures": adapter.storage_textures,
        "timestamps": adapter.timestamps,
        "f64": adapter.f64,
    })
}
