//! A gravity line: every point of a straight line attracts in the perpendicular direction (G95 §2.1).

use super::SourceKind;
use crate::document::keys;
use crate::document::values::direction;

/// The description of this source.
pub static KIND: SourceKind = SourceKind {
    name: "line",
    keys: keys! { direction: "[x, y, z]" = "required", "direction of the line through position"; },
    along: |table| table.required("direction", "[0, 0, 1]", direction),
    offset: |d, along| d.reject_from_normalized(along),
    is_point: false,
};
