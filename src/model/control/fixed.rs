//! Steps of one size h, shorter where η · scale is less.

use super::Kind;
use crate::document::keys;
use crate::model::row;

/// What is known of it.
pub static KIND: Kind = Kind {
    name: "fixed",
    keys: keys! {
        step (" (the others choose their steps)"): "number above 0" = "none",
            "length of a step, in τ; excludes curvature_step";
    },
    parts: &["method/control/planned", "method/control/fixed"],
    memory: "method/memory_step",
    values: |control| row! { step: Float(control.setting), eta: Float(control.cap) },
    evaluations: |step, steps, _| step * steps,
    suffix: "",
    setting: |control| control.setting,
    from_file: |written| written,
    usual: |control, _| *control,
    divides: false,
    rejects: false,
    keeps_errors: false,
    has_tolerance: false,
};
