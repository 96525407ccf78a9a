//! A linked program, every place of which knows where it was written.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::ProgramError;
use super::declarations::Declaration;
use super::place::Place;
use super::tokens::Origin;
use super::unit::Unit;

/// Refuses a declaration that has one of these names, be it of a local variable: the linker makes them for its own use.
pub(super) fn refuse(declaration: &Declaration, names: &BTreeSet<String>, units: &[Unit]) -> Result<(), ProgramError> {
    match declaration.mentions(names) {
        Some((origin, name)) => Err(ProgramError::Reserved { place: Place::of(units, origin), name: name.to_owned() }),
        None => Ok(()),
    }
}

/// One pass's program.
#[derive(Debug, Clone)]
pub struct Linked {
    /// The entry point's name.
    pub entry: String,
    /// The WGSL module.
    pub source: String,
    /// What it was written in: its program's passes share them.
    units: Arc<Vec<Unit>>,
    /// Whose declarations are in it, in order.
    files: Vec<usize>,
    /// Where each token stands in the module, and where it was written.
    marks: Vec<(usize, Origin)>,
}

impl Linked {
    /// An empty one, to be written from these.
    pub(super) fn new(entry: &str, units: Arc<Vec<Unit>>) -> Self {
        Self { entry: entry.to_owned(), source: String::new(), units, files: Vec::new(), marks: Vec::new() }
    }

    /// Appends declarations, under the names of their files. An empty line stands between two, except where both take a line.
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

    /// The parts that are in it, in order.
    #[must_use]
    pub fn parts(&self) -> Vec<&str> {
        self.files.iter().map(|unit| &*self.units[*unit].file).collect()
    }

    /// Where a part has what is at `at` in the module.
    #[must_use]
    pub fn place(&self, at: usize) -> Place {
        let next = self.marks.partition_point(|(from, _)| *from <= at);
        let Some((from, origin)) = next.checked_sub(1).map(|last| self.marks[last]) else {
            return Place::at_start(self.entry.clone());
        };
        // What the linker wrote for a token stands where that did.
        let end = self.marks.get(next).map_or(at, |(next, _)| at.min(*next));
        Place::of(&self.units, Origin { at: origin.at + (end - from).min(self.width(origin)), ..origin })
    }

    /// The length of the word that was written here.
    fn width(&self, origin: Origin) -> usize {
        let text = self.units.get(origin.unit).map_or("", |unit| &unit.text[origin.at.min(unit.text.len())..]);
        text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len())
    }
}
