//! Measurements that anyone can repeat: the sources' own tables, how time grows, and how far from the device's limit a render is.
//!
//! *Practice.* What is compared is measured in one run, by turns where it is two of a kind; every time is the median of repeats,
//! after one that compiles, and stands beside its spread, the longest over the shortest. A measurement is a [`Report`]: text, a
//! table for each in CSV, JSON, and a part of a page.

mod ceiling;
mod compaction;
mod curves;
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

/// Where and how to measure.
#[derive(Debug, Clone, Copy)]
pub struct Bench<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// Each time is the median of so many.
    pub repeats: usize,
    /// Width and height of pictures: the paper's 800×600 unless it is a trial.
    pub size: [u32; 2],
}

impl Bench<'_> {
    /// Returns the number of pixels of a picture.
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
