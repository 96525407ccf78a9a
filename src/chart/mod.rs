//! Measurements: speed against accuracy, and the sources' own tables, repeated.

mod files;
mod paper;
mod shadow;
mod sweep;

pub use files::{fastest_table, write_chart};
pub use paper::{ACCELERATED_2004, PLAIN_2004, PaperBench, Sample, Schedules, TableRow};
pub use shadow::{CRITICAL, shadow_edge};
pub use sweep::{Curve, Point, SceneChart, Sweep};
