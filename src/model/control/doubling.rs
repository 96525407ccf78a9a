//! Step doubling: compares one step h with two steps of h/2 (W04 §4.2), and either rejects steps or follows the rule of W04.
//!
//! W04 adjusts only the next step, by two thresholds, and accepts a step with too large a difference. `REJECTING` repeats such a step with
//! a shorter h.

use super::{Control, ControlKind, falling};
use crate::document::reader::TableReader;
use crate::document::values::{positive, word};
use crate::document::{Key, keys};
use crate::model::{Row, row};

/// The setting of every control that keeps the error under a tolerance.
pub const TOLERANCE: Key = keys! {
    tolerance: "number above 0" = "1e-5", "steps shrink above this relative error";
}[0];

const KEYS: &[Key] = &[
    keys! {
        doubling: "rejecting | paper" = "rejecting", "retry a step over the tolerance, or only shorten the next one";
    }[0],
    TOLERANCE,
    keys! {
        grow_below: "number above 0, below tolerance" = "tolerance / 10", "steps grow below this relative difference";
    }[0],
    super::scaled::SCALED_STEP,
];

/// The control that repeats a step over the tolerance with a shorter h.
pub static REJECTING: ControlKind = ControlKind {
    name: "rejecting",
    keys: KEYS,
    parts: &["method/control/doubling"],
    values,
    evaluations: |step, steps, rejected| 3.0 * step * (steps + rejected),
    suffix: "-doubling",
    usual,
    rejects: true,
    has_tolerance: true,
    read,
    ..ControlKind::EXACT
};

/// The control with two thresholds that adjusts only the next step (W04 §4.2).
pub static PAPER: ControlKind = ControlKind { name: "paper", remark: " (paper)", keeps_errors: true, ..REJECTING };

fn values(control: &Control) -> Row {
    row! { tolerance: Float(control.setting), grow_below: Float(control.grow_below), eta: Float(control.cap) }
}

fn usual(control: &Control, refined: i32) -> Control {
    with(control.kind, 1e-4 * 0.1_f64.powi(refined), 0.3 * 0.5_f64.powi(refined))
}

/// Returns the control with a tolerance; steps grow while the difference is below a tenth of it.
#[must_use]
pub fn with(kind: &'static ControlKind, tolerance: f64, cap: f64) -> Control {
    Control { grow_below: 0.1 * tolerance, ..Control::new(kind, tolerance, cap) }
}

/// Returns the settings of a chart, from a tolerance of 0.1 downwards by half orders of magnitude.
#[must_use]
pub fn sweep(kind: &'static ControlKind, count: i32) -> Vec<Control> {
    falling(0.1, 0.316_227_766, count).map(|tolerance| with(kind, tolerance, 0.3)).collect()
}

fn read(table: &TableReader) -> Control {
    let paper = table.or("doubling", false, word(&[("rejecting", false), ("paper", true)]));
    let tolerance = table.or("tolerance", 1e-5, positive);
    let grow_below = table.or("grow_below", tolerance / 10.0, positive);
    if grow_below >= tolerance {
        let problem = format!("expected `grow_below` less than the tolerance, {tolerance:e}");
        table.fault(&["grow_below"], problem, "remove it to use a tenth of the tolerance");
    }
    let cap = table.or("scaled_step", 0.3, positive);
    Control { grow_below, ..Control::new(if paper { &PAPER } else { &REJECTING }, tolerance, cap) }
}
