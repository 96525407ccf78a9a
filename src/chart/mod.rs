//! Work–precision charts of methods, and charts of formulas from T.

mod files;
mod formulas;
mod noise;
mod stability;
mod sweep;
mod timed;
mod transfer;

pub use files::{fastest_table, write_chart};
pub use formulas::{
    beer_chart, fresnel_chart, reflectance, refracted_sine, snell_chart, spiral_angle, spiral_chart, spiral_plot,
};
pub use noise::{noise_chart, noise_sum, wrapped_chart};
pub use stability::{Outcome, StabilityCase, default_settings};
pub use sweep::{MethodCurve, Point, SceneChart, Sweep};
pub use transfer::TransferPoint;
