//! Steps of an iteration: each has the size that the scene specifies, whatever the law's length scale.

use super::{Control, ControlKind, fixed};
use crate::document::values::positive;
use crate::model::row;

/// The description of this control; a scene must specify the step.
pub static KIND: ControlKind = ControlKind {
    name: "iterated",
    parts: &["method/control/iterated"],
    values: |control| row! { step: Float(control.setting) },
    has_chooser: false,
    read: |table| {
        let step = table.required(KIND.keys[0].key, "0.1", positive);
        Control::new(&KIND, step.unwrap_or(1.0), f64::INFINITY)
    },
    ..fixed::KIND
};
