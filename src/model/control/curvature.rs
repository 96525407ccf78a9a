//! Step-size control by the ray's curvature: every step turns it through the same angle (G95 Fig. 6b), up to the cap.

use super::{Control, ControlKind, falling};
use crate::document::keys;
use crate::model::row;

/// The description of this control.
pub static KIND: ControlKind = ControlKind {
    name: "curvature",
    keys: keys! {
        curvature_step (" (the others choose their steps)"): "number above 0" = "none",
            "angle by which the ray turns in each step, in degrees";
    },
    parts: &["method/control/planned", "method/control/curvature"],
    values: |control| row! { turn: Float(control.setting), eta: Float(control.cap) },
    evaluations: |step, steps, _| (step + 1.0) * steps,
    setting: |control| control.setting.to_degrees(),
    from_file: f64::to_radians,
    usual: |_, refined| with(0.1 * 0.5_f64.powi(refined), 0.2 * 0.5_f64.powi(refined)),
    has_chooser: true,
    ..ControlKind::EXACT
};

/// Returns the control whose steps turn the ray by `turn` radians and are at most `cap` times the law's length scale.
#[must_use]
pub fn with(turn: f64, cap: f64) -> Control {
    Control::new(&KIND, turn, cap)
}

/// Returns the settings of a chart, from half a radian downwards.
#[must_use]
pub fn sweep(count: i32) -> Vec<Control> {
    falling(0.5, 0.75, count).map(|turn| with(turn, 0.5)).collect()
}
