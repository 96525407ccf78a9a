//! An iteration's own steps: each of the size that the scene gives, whatever the law's scale.

use super::{Control, Kind, fixed};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::model::row;

/// What is known of it.
pub static KIND: Kind = Kind {
    name: "iterated",
    parts: &["method/control/iterated"],
    values: |control| row! { step: Float(control.setting) },
    ..fixed::KIND
};

/// By the keys of a `[rays]` table, of which its step is required.
pub fn read(table: &TableReader) -> Control {
    let step = table.required(KIND.keys[0].key, "0.1", positive);
    Control::new(&KIND, step.unwrap_or(1.0), f64::INFINITY)
}
