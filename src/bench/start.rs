//! From launch to the first pixel: what a start takes, part by part, before anything is in the driver's cache and after.
//!
//! *Practice.* Every start is a process of its own, which says itself what its parts took; caches of drivers are sent to a folder
//! that is empty at the first of two starts. wgpu's own pipeline cache is not used: a device takes it as it is, so that opening one
//! is `unsafe`, which this crate forbids; and drivers keep a cache of their own.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use super::{Bench, Cell, Report, Table, Times};
use crate::measure::calibrate_for;
use crate::render::{RenderError, RenderSettings, Renderer};
use crate::scene::{Override, Scene};

/// Width and height of the picture that is started.
const SIZE: u32 = 64;
/// Folders for what drivers compile: those of Mesa, NVIDIA and AMD, and of all that follow the desktop's rules.
const CACHES: [&str; 4] =
    ["MESA_SHADER_CACHE_DIR", "__GL_SHADER_DISK_CACHE_PATH", "AMD_SHADER_DISK_CACHE_PATH", "XDG_CACHE_HOME"];

/// The parts of a start, in order.
const PARTS: [&str; 5] = ["scene", "device", "method", "program", "first picture"];
/// How a line that says them begins.
const WORDS: &str = "first pixel after ";

/// What the parts of a start took.
#[derive(Debug, Clone, PartialEq)]
pub struct StartUp {
    last: Instant,
    parts: Vec<Duration>,
}

impl Default for StartUp {
    /// Launched now.
    fn default() -> Self {
        Self { last: Instant::now(), parts: Vec::new() }
    }
}

impl StartUp {
    /// The next part is done.
    pub fn next(&mut self) {
        let now = Instant::now();
        self.parts.push(now - self.last);
        self.last = now;
    }

    /// Are all of them?
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.parts.len() >= PARTS.len()
    }
}

impl fmt::Display for StartUp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{WORDS}{:.3} s", self.parts.iter().sum::<Duration>().as_secs_f64())?;
        for (i, (name, time)) in PARTS.iter().zip(&self.parts).enumerate() {
            write!(f, "{} {name} {:.3}", if i == 0 { ":" } else { "," }, time.as_secs_f64())?;
        }
        Ok(())
    }
}

/// The seconds of a line that [`StartUp`] wrote: the whole, then its parts.
fn read(line: &str) -> Option<Vec<f64>> {
    let (whole, parts) = line.strip_prefix(WORDS)?.split_once(" s:")?;
    let part = |part: &str| part.rsplit_once(' ')?.1.parse().ok();
    let parts: Vec<f64> = parts.split(',').map(part).collect::<Option<_>>()?;
    (parts.len() == PARTS.len()).then(|| [vec![whole.parse().unwrap_or(f64::NAN)], parts].concat())
}

/// Starts of `program`, which is this one, for each of the scenes.
pub fn start(bench: &Bench, program: &Path, scenes: &[PathBuf]) -> Result<Report, RenderError> {
    let header = ["scene", "cache", "launch to first pixel (s)", "spread"].into_iter().chain(PARTS);
    let header: Vec<&str> = header.chain(["second picture (s)"]).collect();
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
            let mut row: Vec<Cell> = vec![name.as_str().into(), cache.into()];
            row.extend([times(0).median.into(), times(0).spread.into()]);
            row.extend((1..=PARTS.len()).map(|k| Cell::from(times(k).median)));
            row.push(second.median.into());
            table.rows.push(row);
        }
    }
    let intro = format!(
        "{SIZE}×{SIZE} pixels by the fused schedule, each start in a process of its own, with the driver's cache empty and then \
         filled. The second picture is rendered again by what the first has compiled."
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
    command.arg("render").arg(scene).args(["--size", &format!("{SIZE}x{SIZE}"), "--schedule", "fused"]);
    command.args(["--device", &bench.gpu.info.name, "-o"]).arg(folder.join("first.png"));
    command.env_remove("MESA_SHADER_CACHE_DISABLE");
    for cache in CACHES {
        command.env(cache, folder.join("cache"));
    }
    let output = command.output().map_err(failed)?;
    let text = String::from_utf8_lossy(&output.stderr);
    text.lines().find_map(read).ok_or_else(|| failed(format!("{}: {text}", scene.display())))
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
    let renderer = Renderer::new(bench.gpu, &scene, settings)?;
    Times::of(bench.repeats, || Ok(renderer.picture()?.totals.wall))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_says_what_can_be_read_back() {
        let mut launch = StartUp::default();
        for _ in PARTS {
            assert!(!launch.is_complete());
            launch.next();
        }
        launch.parts = vec![Duration::from_millis(250); PARTS.len()];
        assert!(launch.is_complete());
        assert_eq!(read(&launch.to_string()), Some(vec![1.25, 0.25, 0.25, 0.25, 0.25, 0.25]));
        assert_eq!(read("first pixel after a while: scene 1"), None);
    }
}
