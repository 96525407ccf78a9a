//! Steps h = η · scale, a fixed fraction of the law's length scale.

use super::{Control, ControlKind, falling};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::document::{Key, keys};
use crate::model::row;

/// η, which is the setting of this control and the cap of all others except the exact one.
pub const SCALED_STEP: Key = keys! {
    scaled_step: "number above 0" = "0.1; 0.5 with step or curvature_step; 0.3 for doubling and embedded methods",
        "η: a step is η times the length scale of the law at that position, or at most that if another key sets the step; for planar, radians around the center";
}[0];

/// The description of this control.
pub static KIND: ControlKind = ControlKind {
    name: "scaled",
    keys: &[SCALED_STEP],
    parts: &["method/control/planned", "method/control/scaled"],
    values: |control| row! { eta: Float(control.setting) },
    usual: |_, refined| with(0.1 * 0.5_f64.powi(refined)),
    divides: true,
    read,
    ..ControlKind::EXACT
};

/// Returns the control with h = η · scale.
#[must_use]
pub fn with(eta: f64) -> Control {
    Control::new(&KIND, eta, eta)
}

/// Returns the settings of a chart, from η = 0.5 downwards; larger steps jump over features of the law.
#[must_use]
pub fn sweep(count: i32) -> Vec<Control> {
    falling(0.5, 0.75, count).map(with).collect()
}

fn read(table: &TableReader) -> Control {
    with(table.or("scaled_step", 0.1, positive))
}
