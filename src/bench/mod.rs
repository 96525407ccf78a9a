//! Reproducible measurements: the tables of the published sources, the growth of time, and the distance of a render from the device's
//! limit.
//!
//! *Practice.* Values to compare are measured in one run, in alternation for two of a kind. Every time is the median of repeats, after a
//! first run that compiles, with its spread, the ratio of the longest to the shortest. A measurement is a [`Report`]: text, a CSV file per
//! table, JSON, and a section of a page.

mod ceiling;
mod compaction;
mod curves;
mod gpu;
mod groller;
mod lights;
mod limit;
mod paper;
mod paths;
mod report;
mod sampling;
mod scaling;
mod schedules;
mod shadow;
mod start;
mod times;

use std::path::Path;

use crate::gpu::Gpu;
use crate::measure::calibrate;
use crate::render::{RenderError, RenderSettings};
use crate::scene::Scene;

pub use compaction::compaction;
pub use gpu::gpu;
pub use groller::groller;
pub use lights::lights;
pub use limit::limit;
pub use paper::paper;
pub use paths::paths;
pub use report::{Cell, Report, Table};
pub use sampling::sampling;
pub use scaling::scaling;
pub use schedules::schedules;
pub use shadow::{CRITICAL, shadow_edge};
pub use start::start;
pub use times::Times;

/// The device and the settings of measurements.
#[derive(Debug, Clone, Copy)]
pub struct Bench<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// The number of repeats, whose median is each time.
    pub repeats: usize,
    /// The width and height of images: 800×600 as in W04, except in trials.
    pub size: [u32; 2],
}

impl Bench<'_> {
    /// Returns the number of pixels of an image.
    fn pixels(&self) -> f64 {
        f64::from(self.size[0]) * f64::from(self.size[1])
    }

    /// Returns the scene at the size of this measurement, with the method that `auto` finds if the scene leaves it open.
    fn prepared(&self, mut scene: Scene) -> Result<Scene, RenderError> {
        scene.image.size = self.size;
        let found = calibrate(self.gpu, &scene, &RenderSettings::default(), None)?;
        Ok(found.map_or_else(|| scene.clone(), |found| found.applied(&scene)))
    }
}

/// Parses the text of a scene that is part of a measurement.
fn own_scene(text: &str) -> Result<Scene, RenderError> {
    Scene::parse(text, Path::new("bench"), &[]).map_err(|error| RenderError::Output(Box::new(error)))
}
