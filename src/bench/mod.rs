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

use crate::gpu::Gpu;

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
