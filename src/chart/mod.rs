//! Measurements: the sources' own tables, repeated.

mod paper;
mod shadow;

pub use paper::{ACCELERATED_2004, PLAIN_2004, PaperBench, Sample, Schedules, TableRow};
pub use shadow::{CRITICAL, shadow_edge};
