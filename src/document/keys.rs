//! What there is to know of the keys of a table, written where the key is read.
//!
//! A kind of law, medium, shape, … lists its own [`Key`]s; the reference says of each with which kinds it goes.

use serde::Serialize;

/// A key as its kind documents it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Key {
    /// The key.
    pub key: &'static str,
    /// What it goes with besides its kind, such as ` and no points`; empty for nothing.
    pub also: &'static str,
    /// What values it takes; words stand in quotes in the file.
    pub value: &'static str,
    /// What holds without it, or `required`.
    pub default: &'static str,
    /// What it means, with its unit.
    pub meaning: &'static str,
}

/// `key (also): value = default, meaning;` as [`Key`]s.
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

/// A row of the reference: what there is to know of a key.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct KeyReference {
    /// The table it stands in, such as `rays.bounding_sphere`; empty for the top level, NAME for a name of the user's.
    pub table: &'static str,
    /// The key.
    pub key: &'static str,
    /// What it goes with; empty if it always may stand.
    pub when: String,
    /// What values it takes; words stand in quotes in the file.
    pub value: String,
    /// What holds without it, or `required`.
    pub default: &'static str,
    /// What it means, with its unit.
    pub meaning: &'static str,
}

/// Rows of the reference: `table { key if when: value = default, meaning; … }`, for keys that no table of kinds has.
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
