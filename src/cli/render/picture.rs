//! The result of a render for each image, as text and as JSON.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::{Value, json};

use crate::cli::format::{CommandResult, shown};
use crate::cli::share::Target;
use crate::measure::{Quantiles, Verification};
use crate::render::{
    Adaptive, Clamped, FrequencyReport, LightReport, Noise, StarImages, StartUp, Status, Totals, Window,
    frequency_reports,
};
use crate::scene::{Rays, Scene};

/// An image, a frame of an animation, or a band of either.
pub(super) struct Picture<'a> {
    /// The scene file.
    pub scene: &'a Path,
    pub target: Target,
    pub files: Vec<PathBuf>,
    /// The details of the render; `None` if the files existed already.
    pub made: Option<&'a Made<'a>>,
}

/// The details and costs of a render.
pub(super) struct Made<'a> {
    pub scene: &'a Scene,
    /// The command line that repeats the render.
    pub again: &'a str,
    /// The name of the device, with its driver.
    pub device: String,
    /// The window of the image that was rendered.
    pub window: Window,
    /// The time from the start of the frame to its first pass.
    pub ready: Duration,
    /// The times of the process's start, for its first image.
    pub launch: Option<&'a StartUp>,
    pub totals: Totals,
    /// The results of the photon grids.
    pub lights: &'a [&'a LightReport],
    pub verification: Option<&'a Verification>,
}

impl Made<'_> {
    /// Returns the number of rays that could not be followed, of the image and of its lights.
    pub(super) fn unfollowed(&self) -> u64 {
        self.lights.iter().map(|light| light.unfollowed()).sum::<u64>() + self.totals.unfollowed()
    }
}

impl CommandResult for Picture<'_> {
    fn text(&self) -> String {
        let Some(made) = self.made else { return String::new() };
        let mut lines: Vec<String> = made.launch.iter().map(ToString::to_string).collect();
        lines.extend(made.lights.iter().map(ToString::to_string));
        let (totals, ready) = (&made.totals, made.ready.as_secs_f64());
        match self.target.frame {
            Some(frame) => lines.push(format!("frame {frame}: ready after {ready:.3} s; {totals}")),
            None => lines.extend([format!("reproduce with: {}", made.again), totals.to_string()]),
        }
        lines.extend(frequency_reports(made.scene, &totals.radiation).iter().map(told_frequency));
        lines.join("\n")
    }

    fn json(&self) -> Value {
        let mut found = json!({
            "scene": shown(self.scene),
            "frame": self.target.frame,
            "files": self.files.iter().map(shown).collect::<Vec<_>>(),
            "rendered": self.made.is_some(),
        });
        if let Some(made) = self.made {
            for part in [scene(made), counts(made), times(made), quality(made)] {
                merge(&mut found, part);
            }
        }
        found
    }
}

/// Returns the light at a frequency in words.
fn told_frequency(report: &FrequencyReport) -> String {
    let at = report.frequency_hz.map_or_else(|| report.frequency.to_string(), |hertz| format!("{hertz:e} Hz"));
    let mut text = format!("frequency {at}: brightest {:.6e}", report.brightest);
    if let Some(kelvins) = report.brightest_temperature_k {
        let _ = write!(text, " ({kelvins:.4e} K)"); // writing to a String cannot fail
    }
    match (report.flux_jy, report.flux) {
        (Some(flux), _) => text + &format!(", flux {flux:.6} Jy"),
        (None, Some(flux)) => text + &format!(", flux {flux:.6e}"),
        (None, None) => text,
    }
}

/// Adds the keys of another object.
fn merge(to: &mut Value, from: Value) {
    if let (Value::Object(to), Value::Object(from)) = (to, from) {
        to.extend(from);
    }
}

/// Returns the scene, the device and the settings as JSON.
fn scene(made: &Made) -> Value {
    json!({
        "command": made.again,
        "device": made.device,
        "size": made.window.size,
        "origin": made.window.origin,
        "samples": made.scene.image.samples,
        "integrator": followed(&made.scene.rays),
    })
}

/// Returns the integration settings by the keys of `[rays]`; null if they are not a table.
pub(in crate::cli) fn followed(rays: &Rays) -> Value {
    let table: Option<toml::Table> = toml::from_str(&format!("rays = {}", rays.followed())).ok();
    table.and_then(|mut table| serde_json::to_value(table.remove("rays")?).ok()).unwrap_or_default()
}

/// Returns the numbers of rays by their ends.
fn counts(made: &Made) -> Value {
    let totals = &made.totals;
    let ends = Status::ENDS.into_iter().chain([Status::Alive]);
    json!({
        "rays": totals.rays,
        "steps": totals.steps,
        "rejected_steps": totals.rejected,
        "segments": totals.segments,
        "terminations": ends.map(|status| (status.name(), totals.count(status))).collect::<Value>(),
        "unresolved_rays": made.unfollowed(),
        "unlit_points": totals.unlit,
        "undefined_matter": totals.undefined,
        "matter_unconverged": totals.unsettled,
        "radiation": frequency_reports(made.scene, &totals.radiation),
        "overrun_segments": totals.overrun,
    })
}

/// Returns the times of the render, and of its photon grids.
fn times(made: &Made) -> Value {
    let stages = ["setup", "advance", "intersect", "scatter", "shade"];
    let by_stage = |times: [Duration; 5]| -> Value { stages.into_iter().zip(times.map(seconds)).collect() };
    let by_part = |launch: &StartUp| -> Value {
        launch.parts().map(|(part, time)| (part.replace(' ', "_"), seconds(time))).collect()
    };
    json!({
        "seconds": seconds(made.totals.wall),
        "device_seconds": made.totals.device.map(by_stage),
        "ready_seconds": seconds(made.ready),
        "start_seconds": made.launch.map(by_part),
        "light_grids": made.lights.iter().map(|report| light(report)).collect::<Vec<_>>(),
    })
}

fn seconds(time: Duration) -> f64 {
    time.as_secs_f64()
}

fn light(report: &LightReport) -> Value {
    json!({
        "of": report.of.to_string(),
        "voxels": report.count,
        "refined_voxels": report.refined[0],
        "paths": report.totals.rays,
        "unresolved_paths": report.unfollowed(),
        "bytes": report.bytes,
        "seconds": seconds(report.wall),
    })
}

/// Returns the quality of the image, as far as it is known.
fn quality(made: &Made) -> Value {
    let Totals { adaptive, noise, clamped, stars, .. } = &made.totals;
    json!({
        "adaptive": adaptive.as_ref().map(|adaptive: &Adaptive| json!({
            "samples_per_pixel": adaptive.mean(),
            "capped_pixels": adaptive.capped,
            "tolerance": adaptive.tolerance,
        })),
        "noise": noise.as_ref().map(|noise: &Noise| json!({
            "over_mean": noise.mean(),
            "median_pixel": noise.median(),
        })),
        "clamped": clamped.as_ref().map(|clamped: &Clamped| json!({
            "samples": clamped.samples,
            "share_of_light": clamped.share(),
        })),
        "stars": stars.as_ref().map(|stars: &StarImages| json!({
            "images": stars.images,
            "limited": stars.limited,
            "averaged": stars.averaged,
        })),
        "verification": made.verification.map(verification),
    })
}

fn verification(verification: &Verification) -> Value {
    let found = &verification.found;
    // Without rays there are no numbers, which JSON represents as null.
    let quantiles = |q: &Quantiles| json!({ "median": q.median, "p99": q.p99, "max": q.max });
    json!({
        "rays": found.rays,
        "unresolved": found.unresolved,
        "wrong_terminations": found.wrong,
        "flagged": found.flagged,
        "tolerance": verification.tolerance,
        "angle_radians": quantiles(&found.angle),
        "position": quantiles(&found.position),
        "tau": quantiles(&found.tau),
        "intensity": found.light.as_ref().map(quantiles),
    })
}
