//! No control: a closed form leads to the end in one arc.

use super::{Control, Kind};

/// What is known of it.
pub static KIND: Kind = Kind {
    name: "exact",
    keys: &[],
    parts: &[],
    memory: "method/memory_step",
    values: |_| Vec::new(),
    evaluations: |step, steps, _| step * steps,
    suffix: "",
    setting: |_| 0.0,
    from_file: |written| written,
    usual: |control, _| *control,
    divides: false,
    rejects: false,
    keeps_errors: false,
    has_tolerance: false,
};

/// The only one there is.
pub const CONTROL: Control = Control::new(&KIND, 0.0, 0.0);
