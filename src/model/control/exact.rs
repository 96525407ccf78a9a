//! No control: a closed form leads to the end in one arc.

use super::{Control, Kind};

/// What is known of it.
pub static KIND: Kind = Kind::EXACT;

/// The only one there is.
pub const CONTROL: Control = Control::new(&KIND, 0.0, 0.0);
