//! The absence of step-size control: a closed form leads to the end of a path in one arc.

use super::{Control, ControlKind};

/// The description of this control.
pub static KIND: ControlKind = ControlKind::EXACT;

/// The only control of this kind.
pub const CONTROL: Control = Control::new(&KIND, 0.0, 0.0);
