//! The TOML document as written: a tree in which every key and value has its source location.
//!
//! *Theory.* An error is useful only with its location, and one run should find all errors. The text therefore first
//! becomes a tree ([`Document`]). The scene is then read from the tree: `values` convert one node to a value or a
//! [`SpannedError`], and [`reader`] walks tables, collects the faults and reports the keys that nothing has read.
//!
//! *Practice.* A document has one source for the file and one for each `--set`. A [`Span`] names its source, so an
//! invalid value from the command line is reported there.

mod error;
mod keys;
mod kinds;
mod listing;
mod overrides;
pub mod reader;
pub(crate) mod synonyms;
mod text;
mod units;
pub(crate) mod values;

pub(crate) use error::brief;
pub use error::{Diagnostic, SceneError};
pub use keys::{Key, KeyReference};
pub(crate) use keys::{key_rows, keys};
pub use kinds::{Kind, Kinds, kind_rows};
pub use overrides::{Override, names};
pub(crate) use text::{
    given_name, lenient_text, read_bytes, read_given, read_given_text, read_text, strict_text, unmarked,
};
pub use units::{ARCSECOND, C, Dimension, Quantity, Units};

use std::borrow::Cow;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A scene file and its overrides as one tree.
pub struct Document {
    sources: Vec<SourceText>,
    /// The top-level table.
    pub root: Table,
    /// The errors found while the overrides were applied.
    faults: Vec<SpannedError>,
}

/// A text that places refer to.
struct SourceText {
    name: PathBuf,
    text: String,
}

/// A range of bytes, `start..end`, of a source.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span {
    source: usize,
    start: usize,
    end: usize,
}

/// An error whose place has not been converted to a line and column yet.
#[derive(Debug, Clone)]
pub struct SpannedError {
    /// The location of the error.
    pub place: Span,
    /// The problem.
    pub problem: String,
    /// The remedy; may be empty.
    pub help: String,
}

/// A value and its location.
#[derive(Debug, Clone)]
pub struct Node {
    /// The location; for a table, its header or its braces.
    pub place: Span,
    /// The value.
    pub value: Value,
}

/// The kinds of TOML value.
#[derive(Debug, Clone)]
pub enum Value {
    /// A string.
    Text(String),
    /// A string that is a number with a unit, if the document has a table `[units]`.
    Quantity(Quantity),
    /// A whole number.
    Integer(i64),
    /// Any other number, or a whole one too large for 64 bits.
    Float(f64),
    /// `true` or `false`.
    Boolean(bool),
    /// A date or time, which no scene uses.
    Date,
    /// An array, which includes `[[tables]]`.
    Array(Vec<Node>),
    /// A table.
    Table(Table),
}

/// The entries of a table in the order of the file: key, location of the key, and value.
pub type Table = Vec<(String, Span, Node)>;

impl Document {
    /// Parses `text`, read from `path`, and applies the overrides. After a syntax error no other error is reported.
    pub(crate) fn parse(text: &str, path: &Path, overrides: &[Override]) -> Result<Self, SceneError> {
        let mut document = Self {
            sources: vec![SourceText { name: path.to_owned(), text: text.to_owned() }],
            root: Vec::new(),
            faults: Vec::new(),
        };
        let base = Base::default();
        match DeTable::parse(text) {
            Ok(table) => document.root = entries(table.get_ref(), base),
            Err(error) => {
                let fault = SpannedError {
                    place: base.place(error.span().unwrap_or_default()),
                    problem: format!("not valid TOML: {}", error.message()),
                    help: match error.message() {
                        "duplicate key" => {
                            "this name is already defined above; tables that can repeat, such as objects and lights, \
                             have double brackets: [[objects]]"
                                .to_owned()
                        }
                        _ => String::new(),
                    },
                };
                return Err(SceneError::Diagnostics(vec![document.locate(fault)]));
            }
        }
        for over in overrides {
            let source = document.sources.len();
            document.sources.push(SourceText { name: PathBuf::from(over.name()), text: over.text().to_owned() });
            if let Err(fault) = over.apply(&mut document.root, source) {
                document.faults.push(fault);
            }
        }
        Ok(document)
    }

    /// Sets the key at `path` to a frame's value; `key` is the location at which the animation names the key.
    pub fn animate(&mut self, path: &[String], value: Node, key: Span) {
        match overrides::reach(&mut self.root, path, key) {
            Ok(old) if old.place.source != 0 && old.place.source != key.source => {
                let problem = format!("`{}` is animated and cannot be set to another value", path.join("."));
                let help = "change the values of its track instead".to_owned();
                self.faults.push(SpannedError { place: old.place, problem, help });
            }
            Ok(old) => *old = value,
            Err(fault) => self.faults.push(fault),
        }
    }

    /// Returns the path of the file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.sources[0].name
    }

    /// Returns the location of a part of a string, given in bytes of its text; exact unless the string is written with escapes.
    #[must_use]
    pub fn inside(&self, node: &Node, part: Range<usize>) -> Span {
        let Span { source, start, end } = node.place;
        let written = self.sources[source].text.get(start..end);
        let offset = match &node.value {
            Value::Text(text) | Value::Quantity(Quantity { text, .. }) => {
                written.and_then(|written| written.find(text.as_str()))
            }
            _ => None,
        };
        match offset {
            Some(offset) => Span { source, start: start + offset + part.start, end: start + offset + part.end },
            None => node.place,
        }
    }

    /// Converts the location of a fault to a line and column.
    #[must_use]
    pub fn locate(&self, fault: SpannedError) -> Diagnostic {
        let Span { source, start, end } = fault.place;
        let source = &self.sources[source];
        Diagnostic::locate(source.name.clone(), &source.text, start, end, fault.problem, fault.help)
    }
}

/// The start of the file, the location of missing things that have no other location.
pub const TOP: Span = Span { source: 0, start: 0, end: 0 };

/// The origin of the locations in a tree.
#[derive(Debug, Clone, Copy, Default)]
struct Base {
    source: usize,
    /// The number of bytes before the parsed text.
    offset: usize,
}

impl Base {
    fn place(self, span: Range<usize>) -> Span {
        Span { source: self.source, start: span.start + self.offset, end: span.end + self.offset }
    }
}

fn entries(table: &DeTable, base: Base) -> Table {
    let entry = |(key, value): (&Spanned<Cow<str>>, &Spanned<DeValue>)| {
        let name = key.get_ref().clone().into_owned();
        (name, base.place(key.span()), node(value, base))
    };
    table.iter().map(entry).collect()
}

fn node(value: &Spanned<DeValue>, base: Base) -> Node {
    // Rust parses every float that TOML allows; a float that is too large for 64 bits becomes infinite and is rejected later.
    let float = |digits: &str| Value::Float(digits.parse().unwrap_or(f64::NAN));
    Node {
        place: base.place(value.span()),
        value: match value.get_ref() {
            DeValue::String(text) => Value::Text(text.to_string()),
            DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
                .map_or_else(|_| float(digits.as_str()), Value::Integer),
            DeValue::Float(digits) => float(digits.as_str()),
            DeValue::Boolean(value) => Value::Boolean(*value),
            DeValue::Datetime(_) => Value::Date,
            DeValue::Array(items) => Value::Array(items.iter().map(|v| node(v, base)).collect()),
            DeValue::Table(table) => Value::Table(entries(table, base)),
        },
    }
}
