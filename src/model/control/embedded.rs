//! Step-size control by the error of an embedded pair: a PI controller keeps it under the tolerance (Hairer, Nørsett, Wanner, §II.4).

use super::doubling::TOLERANCE;
use super::scaled::SCALED_STEP;
use super::{Control, ControlKind, falling};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::model::row;

/// The description of this control.
pub static KIND: ControlKind = ControlKind {
    name: "embedded",
    keys: &[TOLERANCE, SCALED_STEP],
    parts: &["method/control/embedded"],
    remembers: true,
    values: |control| row! { tolerance: Float(control.setting), eta: Float(control.cap) },
    evaluations: |step, steps, rejected| 1.0 + step * (steps + rejected),
    usual: |_, refined| with(1e-5 * 0.1_f64.powi(refined), 0.3 * 0.5_f64.powi(refined)),
    divides: true,
    rejects: true,
    has_tolerance: true,
    read,
    ..ControlKind::EXACT
};

/// Returns the control with a tolerance; steps are at most `cap` times the law's length scale.
#[must_use]
pub fn with(tolerance: f64, cap: f64) -> Control {
    Control::new(&KIND, tolerance, cap)
}

/// Returns the settings of a chart, from a tolerance of 1 downwards by half orders of magnitude.
#[must_use]
pub fn sweep(count: i32) -> Vec<Control> {
    falling(1.0, 0.316_227_766, count).map(|tolerance| with(tolerance, 0.5)).collect()
}

fn read(table: &TableReader) -> Control {
    let tolerance = table.or("tolerance", 1e-5, positive);
    with(tolerance, table.or("scaled_step", 0.3, positive))
}
