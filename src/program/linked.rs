//! A linked program, every place of which knows where it was written.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use super::unit::Unit;

/// A piece of a text, and what to write instead.
pub(super) type Edit = (Range<usize>, String);

/// Where the pieces of a text come from.
#[derive(Debug, Clone, Default)]
struct Marks(Vec<Mark>);

/// What stands at `at` in the text, and behind it up to the next mark, comes from `from` in a source.
#[derive(Debug, Clone, Copy)]
struct Mark {
    at: usize,
    source: usize,
    from: usize,
}

impl Marks {
    /// Appends to `text` what `piece` is with its edits, which are in order; `piece` stands at `from` in its source.
    fn append(&mut self, text: &mut String, source: usize, from: usize, piece: &str, edits: &[Edit]) {
        let mut done = 0;
        for (range, new) in edits {
            self.0.push(Mark { at: text.len(), source, from: from + done });
            text.push_str(&piece[done..range.start]);
            self.0.push(Mark { at: text.len(), source, from: from + range.start });
            text.push_str(new);
            done = range.end;
        }
        self.0.push(Mark { at: text.len(), source, from: from + done });
        text.push_str(&piece[done..]);
    }

    /// The source of what stands at `at`, and the place in it.
    fn origin(&self, at: usize) -> (usize, usize) {
        let next = self.0.partition_point(|mark| mark.at <= at);
        let Some(mark) = next.checked_sub(1).map(|last| self.0[last]) else { return (0, 0) };
        // What was put in stands for no more than it replaced.
        let end = self.0.get(next).filter(|next| next.source == mark.source && next.from >= mark.from);
        let from = mark.from + at - mark.at;
        (mark.source, end.map_or(from, |end| from.min(end.from)))
    }
}

/// A unit as it is linked: with the names and bindings of its copy.
#[derive(Debug, Clone)]
pub(super) struct Copy {
    unit: Unit,
    pub(super) text: String,
    marks: Marks,
}

impl Copy {
    pub(super) fn new(unit: &Unit, edits: &[Edit]) -> Self {
        let mut copy = Self { unit: unit.clone(), text: String::new(), marks: Marks::default() };
        copy.marks.append(&mut copy.text, 0, 0, &unit.text, edits);
        copy
    }

    pub(super) fn unit(&self) -> &Unit {
        &self.unit
    }

    /// The place in the unit's own text of what is at `at` in the copy's.
    pub(super) fn place(&self, at: usize) -> Place {
        Place::of(&self.unit, self.marks.origin(at).1)
    }
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file, as messages name it.
    pub file: String,
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
}

impl Place {
    /// Of what stands at `at` in a unit's text.
    pub(super) fn of(unit: &Unit, at: usize) -> Self {
        let text = &unit.text[..at.min(unit.text.len())];
        let line = text.rfind('\n').map_or(0, |end| end + 1);
        let [line, column] = [text.matches('\n').count(), text[line..].chars().count()].map(|before| before + 1);
        Self { file: unit.shown(), line, column }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// One pass's program.
#[derive(Debug, Clone)]
pub struct Linked {
    /// The entry point's name.
    pub entry: String,
    /// The WGSL module.
    pub source: String,
    /// Its program's passes share them.
    copies: Vec<Arc<Copy>>,
    marks: Marks,
}

impl Linked {
    /// An empty one, to be written from these.
    pub(super) fn new(entry: &str, copies: Vec<Arc<Copy>>) -> Self {
        Self { entry: entry.to_owned(), source: String::new(), copies, marks: Marks::default() }
    }

    /// A copy's text.
    pub(super) fn text(&self, copy: usize) -> &str {
        &self.copies[copy].text
    }

    /// Appends the line that says which file follows, unless it is the same as before.
    pub(super) fn open(&mut self, copy: usize) {
        let file = |copy: usize| &self.copies[copy].unit.file;
        if self.marks.0.last().is_none_or(|last| file(last.source) != file(copy)) {
            let heading = format!("// ---- {}\n", file(copy));
            self.marks.append(&mut self.source, copy, 0, "", &[(0..0, heading)]);
        }
    }

    /// Appends a piece of a copy, with edits, and an empty line.
    pub(super) fn push(&mut self, copy: usize, piece: Range<usize>, edits: &[Edit]) {
        let text = &self.copies[copy].text[piece.clone()];
        self.marks.append(&mut self.source, copy, piece.start, text, edits);
        self.source.push_str(if self.source.ends_with('\n') { "\n" } else { "\n\n" });
    }

    /// The parts that are in it, in order.
    #[must_use]
    pub fn parts(&self) -> Vec<&str> {
        let mut parts: Vec<&str> = self.marks.0.iter().map(|mark| &*self.copies[mark.source].unit.file).collect();
        parts.dedup();
        parts
    }

    /// Where a part has what is at `at` in the module.
    #[must_use]
    pub fn place(&self, at: usize) -> Place {
        let (copy, from) = self.marks.origin(at);
        self.copies[copy].place(from)
    }
}
