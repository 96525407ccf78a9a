//! `bentray doctor`: checks for everything that a render may need, and prints what to install.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};

use clap::Args;
use serde_json::{Value, json};

use super::decisions;
use super::devices::Devices;
use super::format::{CommandResult, Format, shown};
use crate::error::Error;
use crate::gpu::{AdapterReport, GpuError, adapters};
use crate::output::check_film;

/// Check that everything a render needs is installed, and print what to install
#[derive(Debug, Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Error> {
    let found = Findings::look();
    arguments.format.say(&found)?;
    Ok(if found.devices.0.is_empty() { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// The results of the checks.
struct Findings {
    devices: Devices,
    /// `true` if videos can be encoded.
    video: bool,
    /// The folder for stored decisions, and `true` if it is writable.
    cache: Option<(PathBuf, bool)>,
    /// The job queues that were found.
    queues: Vec<&'static str>,
}

impl Findings {
    fn look() -> Self {
        let queues = [("sbatch", "Slurm"), ("kubectl", "Kubernetes"), ("parallel", "GNU parallel")];
        let is_writable =
            |folder: &PathBuf| fs::create_dir_all(folder).is_ok() && tempfile::tempfile_in(folder).is_ok();
        Self {
            devices: Devices(adapters()),
            video: check_film("film.mp4".as_ref(), [1, 1]).is_ok(),
            cache: decisions::folder().map(|folder| (folder.clone(), is_writable(&folder))),
            queues: queues.into_iter().filter(|(program, _)| is_there(program)).map(|(_, name)| name).collect(),
        }
    }

    fn cache(&self) -> String {
        match &self.cache {
            None => "none: every render searches for its method again".to_owned(),
            Some((folder, true)) => folder.display().to_string(),
            Some((folder, false)) => {
                format!("{} is not writable: every render searches for its method again", folder.display())
            }
        }
    }
}

impl CommandResult for Findings {
    fn text(&self) -> String {
        let devices = &self.devices.0;
        let video = if self.video {
            "yes: .mp4 and .webm with ffmpeg"
        } else {
            "no ffmpeg: only .gif and animated .png; install ffmpeg (apt-get install ffmpeg) for .mp4 and .webm"
        };
        let queues = if self.queues.is_empty() { "no queue found".to_owned() } else { self.queues.join(", ") };
        let rows = [
            ("device", Some(device(devices))),
            ("64 bits", double(devices)),
            ("video", Some(video.to_owned())),
            ("cache", Some(self.cache())),
            ("farm", Some(queues)),
        ];
        let rows = rows.into_iter().filter_map(|(name, words)| Some(format!("{name:<13}{}", words?)));
        rows.collect::<Vec<_>>().join("\n")
    }

    fn json(&self) -> Value {
        let mut found = self.devices.json();
        found["video"] = self.video.into();
        found["cache"] = self
            .cache
            .as_ref()
            .map_or(Value::Null, |(folder, is_writable)| json!({ "folder": shown(folder), "writable": is_writable }));
        found["queues"] = json!(self.queues);
        found
    }
}

/// Describes the device that would render, and the number of others.
fn device(adapters: &[AdapterReport]) -> String {
    let Some(best) = adapters.first() else { return format!("none: {}", GpuError::NoDevice) };
    let more = match adapters.len() - 1 {
        0 => String::new(),
        others => format!(", and {others} more (`bentray devices` lists them)"),
    };
    format!("{} ({:?}, {}){more}", best.info.name, best.info.device_type, best.info.backend)
}

/// Describes the support for 64-bit arithmetic, on the best device or another one; `None` if there is no device.
fn double(adapters: &[AdapterReport]) -> Option<String> {
    let best = adapters.first()?;
    let other = adapters.iter().find(|adapter| adapter.f64);
    Some(match other {
        Some(_) if best.f64 => "yes: --precision f64, --verify and the best checks of method = \"auto\"".to_owned(),
        Some(other) => format!("only on {0}: use --precision f64 with --device '{0}'", other.info.name),
        None => {
            "no: --precision f64 and --verify are unavailable; Mesa's CPU device (lavapipe) supports them".to_owned()
        }
    })
}

fn is_there(program: &str) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok()
}
