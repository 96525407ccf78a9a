//! The documentation of a table's keys, declared next to the code that reads them.
//!
//! Each kind of law, medium, shape and so on lists its [`Key`]s; the reference states for each key which kinds accept it.

use serde::Serialize;

/// A key, as documented by its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Key {
    /// The key.
    pub key: &'static str,
    /// A condition in addition to the kind, such as ` and no points`; empty if there is none.
    pub also: &'static str,
    /// The values that the key takes; words are quoted in the file.
    pub value: &'static str,
    /// The default, or `required`.
    pub default: &'static str,
    /// The meaning of the key, with its unit.
    pub meaning: &'static str,
}

/// Builds [`Key`]s from lines `key (also): value = default, meaning;`.
macro_rules! keys {
    ($($key:ident $(($also:literal))?: $value:literal = $default:literal, $meaning:literal;)*) => {
        &[$($crate::document::Key {
            key: stringify!($key),
            also: concat!($($also)?),
            value: $value,
            default: $default,
            meaning: $meaning,
        },)*]
    };
}
pub(crate) use keys;

/// A row of the reference, which documents one key.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct KeyReference {
    /// The table of the key, such as `rays.bounding_sphere`; empty for the top level; NAME represents a name that the user chooses.
    pub table: &'static str,
    /// The key.
    pub key: &'static str,
    /// The condition under which the key is valid; empty if it is always valid.
    pub when: String,
    /// The values that the key takes; words are quoted in the file.
    pub value: String,
    /// The default, or `required`.
    pub default: &'static str,
    /// The meaning of the key, with its unit.
    pub meaning: &'static str,
}

/// Builds rows of the reference, `table { key if when: value = default, meaning; … }`, for keys that no table of kinds lists.
macro_rules! key_rows {
    ($($table:literal {
        $($key:ident $(if $when:literal)?: $value:literal = $default:literal, $meaning:literal;)*
    })*) => {
        vec![$($($crate::document::KeyReference {
            table: $table,
            key: stringify!($key),
            when: concat!($($when)?).to_owned(),
            value: $value.to_owned(),
            default: $default,
            meaning: $meaning,
        },)*)*]
    };
}
pub(crate) use key_rows;
