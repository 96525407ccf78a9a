//! Source locations, as messages print them.

use std::fmt;

use super::tokens::Origin;
use super::unit::Unit;

/// A location in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// The file's name in messages.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
}

impl Location {
    /// Returns the location of a token of a program.
    pub(super) fn of(units: &[Unit], origin: Origin) -> Self {
        units.get(origin.unit).map_or_else(|| Self::at_start(String::new()), |unit| Self::in_unit(unit, origin.at))
    }

    /// Returns the location of byte `at` in a unit's text.
    pub(super) fn in_unit(unit: &Unit, at: usize) -> Self {
        let text = &unit.text[..at.min(unit.text.len())];
        let line = text.rfind('\n').map_or(0, |end| end + 1);
        let [line, column] = [text.matches('\n').count(), text[line..].chars().count()].map(|before| before + 1);
        Self { file: unit.shown(), line, column }
    }

    pub(super) fn at_start(file: String) -> Self {
        Self { file, line: 1, column: 1 }
    }
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}
