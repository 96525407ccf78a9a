//! Steps of a fixed size h, or of η · scale where this is shorter.

use super::ControlKind;
use crate::document::keys;
use crate::model::row;

/// The description of this control.
pub static KIND: ControlKind = ControlKind {
    name: "fixed",
    keys: keys! {
        step (" (the others choose their steps)"): "number above 0" = "none",
            "step length, in τ; cannot be combined with curvature_step";
    },
    parts: &["method/control/planned", "method/control/fixed"],
    values: |control| row! { step: Float(control.setting), eta: Float(control.cap) },
    has_chooser: true,
    ..ControlKind::EXACT
};
