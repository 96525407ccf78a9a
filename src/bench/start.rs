//! The time from launch to the first pixel, by stage, with an empty and with a filled driver cache.
//!
//! *Practice.* Every start is a separate process, which reports the times of its stages. Driver caches are redirected to a folder that is
//! empty at the first of two starts. The pipeline cache of wgpu is not used: a device accepts its data without checks, so that opening one
//! is `unsafe`, which this crate forbids; and drivers have a separate cache.

use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use super::{Bench, Report, Table, Times};
use crate::measure::calibrate_for;
use crate::render::{RenderError, RenderSettings, Renderer, StartUp};
use crate::scene::{Override, Scene};

/// The width and height of the image.
const SIZE: u32 = 64;
/// The variables for the folders of driver caches, for Mesa, NVIDIA, AMD, and drivers that follow the XDG rules, and for the decisions of
/// `auto`.
const CACHES: [&str; 5] = [
    "MESA_SHADER_CACHE_DIR",
    "__GL_SHADER_DISK_CACHE_PATH",
    "AMD_SHADER_DISK_CACHE_PATH",
    "XDG_CACHE_HOME",
    "BENTRAY_CACHE",
];

/// Measures starts of `program`, which is this program, for each of the scenes.
///
/// # Errors
///
/// Returns [`RenderError::Output`] if `program` cannot be run or fails, or if a scene is invalid, and another error if the device fails.
pub fn start(bench: &Bench, program: &Path, scenes: &[PathBuf]) -> Result<Report, RenderError> {
    let parts = StartUp::PARTS.join(" | ");
    let header = format!("scene | cache | launch to first pixel (s) | spread | {parts} | second image (s)");
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
        "{SIZE}×{SIZE} pixels, each start in a separate process, first with empty and then with filled caches of the \
         driver and of method = \"auto\". The second image reuses the program that was compiled for the first."
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

/// Measures one start with the driver's cache in `folder`.
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

/// Returns the seconds from launch to the first pixel, followed by those of each stage, from the output of `render --json`.
fn parts(printed: &[u8]) -> Option<Vec<f64>> {
    let picture: Value = serde_json::from_slice(printed).ok()?;
    let part = |name: &str| picture["start_seconds"][name.replace(' ', "_")].as_f64();
    let parts: Vec<f64> = StartUp::PARTS.into_iter().map(part).collect::<Option<_>>()?;
    Some([vec![parts.iter().sum()], parts].concat())
}

/// Measures an image by a compiled program.
fn second(bench: &Bench, path: &Path) -> Result<Times, RenderError> {
    let size: Vec<Override> = format!("image.size=[{SIZE}, {SIZE}]").parse().into_iter().collect();
    let mut scene = Scene::load(path, &size).map_err(|error| RenderError::Output(Box::new(error)))?;
    let rays = u64::from(SIZE) * u64::from(SIZE) * u64::from(scene.image.samples);
    let mut settings = RenderSettings::default();
    if let Some(found) = calibrate_for(bench.gpu, &scene, &settings, rays)? {
        settings.options.layers.clone_from(&found.layers);
        scene = found.applied(&scene);
    }
    let mut renderer = Renderer::new(bench.gpu, &scene, settings)?;
    Times::of(bench.repeats, || Ok(renderer.render()?.totals.wall))
}
