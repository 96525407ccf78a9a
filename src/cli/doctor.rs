//! `bentray doctor`: is everything there that a render may need, and what is to be done if not?

use std::fs;
use std::process::{Command, ExitCode, Stdio};

use clap::Args;

use super::decisions;
use crate::error::Error;
use crate::gpu::{AdapterReport, GpuError, adapters};
use crate::output::check_film;

/// Look whether everything is there that a render may need, and say what to install
#[derive(Debug, Args)]
pub(super) struct Arguments {}

pub(super) fn run(_: &Arguments) -> Result<ExitCode, Error> {
    let adapters = adapters();
    say!("device       {}", device(&adapters));
    if let Some(words) = double(&adapters) {
        say!("64 bits      {words}");
    }
    let video = match check_film("film.mp4".as_ref()) {
        Ok(()) => "yes: .mp4 and .webm by ffmpeg",
        Err(_) => "no ffmpeg: films are .gif or animated .png; apt-get install ffmpeg brings .mp4 and .webm",
    };
    say!("video        {video}");
    say!("cache        {}", cache());
    let queues = [("sbatch", "Slurm"), ("kubectl", "Kubernetes"), ("parallel", "GNU parallel")];
    let found: Vec<&str> = queues.into_iter().filter(|(program, _)| is_there(program)).map(|(_, name)| name).collect();
    say!("farm         {}", if found.is_empty() { "no queue found here".to_owned() } else { found.join(", ") });
    Ok(if adapters.is_empty() { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// What would render.
fn device(adapters: &[AdapterReport]) -> String {
    let Some(best) = adapters.first() else { return format!("none: {}", GpuError::NoDevice) };
    let more = match adapters.len() - 1 {
        0 => String::new(),
        others => format!(", and {others} more: `bentray devices`"),
    };
    format!("{} ({:?}, {}){more}", best.info.name, best.info.device_type, best.info.backend)
}

/// Can it compute in 64 bits, or another one?
fn double(adapters: &[AdapterReport]) -> Option<String> {
    let best = adapters.first()?;
    let other = adapters.iter().find(|adapter| adapter.f64);
    Some(match other {
        Some(_) if best.f64 => "yes: --precision f64, --verify and the best checks of `auto`".to_owned(),
        Some(other) => format!("only on {0}: --precision f64 with --device '{0}'", other.info.name),
        None => "no: --precision f64 and --verify cannot be had; lavapipe has them".to_owned(),
    })
}

/// Where decisions are kept, and whether they can be.
fn cache() -> String {
    let Some(folder) = decisions::folder() else { return "none: every render looks for its method anew".to_owned() };
    let writable = fs::create_dir_all(&folder).is_ok() && tempfile::tempfile_in(&folder).is_ok();
    let shown = folder.display();
    if writable {
        shown.to_string()
    } else {
        format!("{shown} cannot be written: every render looks for its method anew")
    }
}

fn is_there(program: &str) -> bool {
    let mut command = Command::new(program);
    command.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok()
}
