//! A linked program, which maps every position back to its source.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::ProgramError;
use super::declarations::Declaration;
use super::location::Location;
use super::tokens::Origin;
use super::unit::{Author, Unit};

/// Rejects a declaration that contains one of these names, even as a local variable: the linker reserves them for itself.
pub(super) fn refuse(declaration: &Declaration, names: &BTreeSet<String>, units: &[Unit]) -> Result<(), ProgramError> {
    match declaration.mentions(names) {
        Some((origin, name)) => {
            Err(ProgramError::Reserved { place: Location::of(units, origin), name: name.to_owned() })
        }
        None => Ok(()),
    }
}

/// The program of one pass.
#[derive(Debug, Clone)]
pub struct LinkedProgram {
    /// The entry point's name.
    pub entry: String,
    /// The WGSL module.
    pub source: String,
    /// The units it was linked from; the passes of a program share them.
    units: Arc<Vec<Unit>>,
    /// The indices of the units with declarations in it, in order.
    files: Vec<usize>,
    /// The position of each token in the module, and its origin.
    marks: Vec<(usize, Origin)>,
}

impl LinkedProgram {
    /// Creates an empty program, to be written from these units.
    pub(super) fn new(entry: &str, units: Arc<Vec<Unit>>) -> Self {
        Self { entry: entry.to_owned(), source: String::new(), units, files: Vec::new(), marks: Vec::new() }
    }

    /// Appends declarations, under the names of their files. An empty line separates two declarations, except if both take one line.
    pub(super) fn push(&mut self, declarations: &[Declaration]) {
        let mut last = None;
        for declaration in declarations {
            let unit = declaration.origin().unit;
            let is_line = !declaration.tokens.0.iter().any(|token| token.gap.contains('\n'));
            if !last.is_some_and(|last| last == (unit, true) && is_line) && !self.source.is_empty() {
                self.source.push('\n');
            }
            let file = |unit: usize| self.units.get(unit).map(|unit| &unit.file);
            if last.is_none_or(|(last, _)| file(last) != file(unit)) {
                self.files.push(unit);
                self.source += &["// ---- ", &*self.units[unit].file, "\n"].concat();
            }
            for token in &declaration.tokens.0 {
                self.source += &token.gap;
                self.marks.push((self.source.len(), token.origin));
                self.source += &token.word;
            }
            self.source.push('\n');
            last = Some((unit, is_line));
        }
    }

    /// Returns the files of the modules that it contains, in order.
    #[must_use]
    pub fn parts(&self) -> Vec<&str> {
        self.files.iter().map(|unit| &*self.units[*unit].file).collect()
    }

    /// Returns `true` if the program contains no WGSL of a user.
    #[must_use]
    pub fn is_own(&self) -> bool {
        self.files.iter().all(|unit| self.units[*unit].author != Author::User)
    }

    /// Returns the source location of position `at` of the module.
    #[must_use]
    pub fn place(&self, at: usize) -> Location {
        let next = self.marks.partition_point(|(from, _)| *from <= at);
        let Some((from, origin)) = next.checked_sub(1).map(|last| self.marks[last]) else {
            return Location::at_start(self.entry.clone());
        };
        // Text that the linker generated for a token has the location of that token.
        let end = self.marks.get(next).map_or(at, |(next, _)| at.min(*next));
        Location::of(&self.units, Origin { at: origin.at + (end - from).min(self.width(origin)), ..origin })
    }

    /// Returns the length of the word at this origin.
    fn width(&self, origin: Origin) -> usize {
        let text = self.units.get(origin.unit).map_or("", |unit| &unit.text[origin.at.min(unit.text.len())..]);
        text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len())
    }
}
