//! Bentray renders scenes in which light does not travel straight.

pub mod chart;
pub mod cli;
pub mod error;
pub mod gpu;
pub mod output;
pub mod program;
pub mod render;
pub mod scene;
