//! From launch to the first pixel: what a start takes, part by part, before anything is in the driver's cache and after.
//!
//! *Practice.* Every start is a process of its own, which says itself what its parts took; caches of drivers are sent to a folder
//! that is empty at the first of two starts. wgpu's own pipeline cache is not used: a device takes it as it is, so that opening one
//! is `unsafe`, which this crate forbids; and drivers keep a cache of their own.

use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use super::{Bench, Report, Table, Times};
use crate::measure::calibrate_for;
use crate::render::{RenderError, RenderSettings, Renderer, StartUp};
use crate::scene::{Override, Scene};

/// Width and height of the picture that is started.
const SIZE: u32 = 64;
/// Folders for what drivers compile, those of Mesa, NVIDIA and AMD, and of all that follow the desktop's rules; and for what `auto`
/// decided.
const CACHES: [&str; 5] = [
    "MESA_SHADER_CACHE_DIR",
    "__GL_SHADER_DISK_CACHE_PATH",
    "AMD_SHADER_DISK_CACHE_PATH",
    "XDG_CACHE_HOME",
    "BENTRAY_CACHE",
];

/// Starts of `program`, which is this one, for each of the scenes.
pub fn start(bench: &Bench, program: &Path, scenes: &[PathBuf]) -> Result<Report, RenderError> {
    let parts = StartUp::PARTS.join(" | ");
    let header = format!("scene | cache | launch to first pixel (s) | spread | {parts} | second picture (s)");
    let mut table = Table::new("start", "From launch to the first pixel", &header);
    for path in scenes {
        let name = path.file_stem().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let [mut cold, mut warm] = [Vec::new(), Vec::new()];
        for _ in 0..bench.repeats.max(1) {
            let folder = tempfile::tempdir().map_err(failed)?;
            for starts in [&mut cold, &mut warm] {
                starts.push(started(bench, program, path, folder.path())?);
            }
        }
        let second = second(bench, path)?;
        for (cache, starts) in [("empty", cold), ("filled", warm)] {
            let times = |k: usize| Times::from(starts.iter().map(|parts| parts[k]).collect::<Vec<f64>>());
            let whole = [times(0).median, times(0).spread];
            let parts = (1..=StartUp::PARTS.len()).map(|k| times(k).median);
            table.row(&[&name, cache], whole.into_iter().chain(parts).chain([second.median]));
        }
    }
    let intro = format!(
        "{SIZE}×{SIZE} pixels, each start in a process of its own, with the caches of the driver and of \
         `auto` empty and then filled. The second picture is rendered again by what the first has compiled."
    );
    Ok(Report {
        name: "start",
        title: "Start-up".to_owned(),
        intro: vec![intro],
        tables: vec![table],
        plots: Vec::new(),
    })
}

fn failed(cause: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> RenderError {
    RenderError::Output(Box::new(io::Error::other(cause)))
}

/// One start with the driver's cache in `folder`.
fn started(bench: &Bench, program: &Path, scene: &Path, folder: &Path) -> Result<Vec<f64>, RenderError> {
    let mut command = Command::new(program);
    command.arg("render").arg(scene).args(["--json", "--size", &format!("{SIZE}x{SIZE}")]);
    command.args(["--device", &bench.gpu.info.name, "-o"]).arg(folder.join("first.png"));
    command.env_remove("MESA_SHADER_CACHE_DISABLE");
    for cache in CACHES {
        command.env(cache, folder.join("cache"));
    }
    let output = command.output().map_err(failed)?;
    let text = String::from_utf8_lossy(&output.stderr);
    parts(&output.stdout).ok_or_else(|| failed(format!("{}: {text}", scene.display())))
}

/// Seconds from launch to the first pixel, then those of each part, of what `render --json` prints.
fn parts(printed: &[u8]) -> Option<Vec<f64>> {
    let picture: Value = serde_json::from_slice(printed).ok()?;
    let part = |name: &str| picture["start_seconds"][name.replace(' ', "_")].as_f64();
    let parts: Vec<f64> = StartUp::PARTS.into_iter().map(part).collect::<Option<_>>()?;
    Some([vec![parts.iter().sum()], parts].concat())
}

/// A picture by a program that is compiled already.
fn second(bench: &Bench, path: &Path) -> Result<Times, RenderError> {
    let size: Vec<Override> = format!("image.size=[{SIZE}, {SIZE}]").parse().into_iter().collect();
    let mut scene = Scene::load(path, &size).map_err(|error| RenderError::Output(Box::new(error)))?;
    let rays = u64::from(SIZE) * u64::from(SIZE) * u64::from(scene.image.samples);
    let mut settings = RenderSettings::default();
    if let Some(found) = calibrate_for(bench.gpu, &scene, &settings, rays)? {
        settings.choice.layers.clone_from(&found.layers);
        scene = found.applied(&scene);
    }
    let mut renderer = Renderer::new(bench.gpu, &scene, settings)?;
    Times::of(bench.repeats, || Ok(renderer.picture()?.totals.wall))
}
