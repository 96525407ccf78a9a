//! The TOML as written: a tree in which every key and value knows its place.
//!
//! *Theory.* A mistake is only useful with its place, and a run that finds one should find them all. So the text
//! becomes a tree first ([`Document`]), and is then asked for what it should hold: [`values`] turn one node to a
//! value or a [`Fault`], [`reader`] walks tables, collects the faults and tells the keys that nobody asked for.
//!
//! *Practice.* A document has one source for the file and one for each `--set`, and a [`Place`] names its source, so
//! that a value given on the command line is found there when it is wrong.

mod error;
mod keys;
mod kinds;
mod listing;
mod overrides;
pub mod reader;
pub(crate) mod synonyms;
mod text;
pub mod values;

pub(crate) use error::brief;
pub use error::{Mistake, SceneError};
pub use keys::{Key, KeyReference};
pub(crate) use keys::{key_rows, keys};
pub use kinds::{Kind, Kinds, kind_rows};
pub use overrides::{Override, names};
pub use text::{given_name, lenient_text, read_bytes, read_given, read_given_text, read_text, strict_text, unmarked};

use std::borrow::Cow;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A scene file and its overrides as one tree.
pub struct Document {
    sources: Vec<Source>,
    /// The top level.
    pub root: Table,
    /// What went wrong while the overrides were put in.
    faults: Vec<Fault>,
}

/// A text that places refer to.
struct Source {
    name: PathBuf,
    text: String,
}

/// Bytes `start..end` of a source.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    source: usize,
    start: usize,
    end: usize,
}

/// A mistake, its place not yet looked up.
#[derive(Debug, Clone)]
pub struct Fault {
    /// Where.
    pub place: Place,
    /// What is wrong.
    pub problem: String,
    /// What would be right; may be empty.
    pub help: String,
}

/// A value and where it stands.
#[derive(Debug, Clone)]
pub struct Node {
    /// A table's place is its header, or its braces.
    pub place: Place,
    /// What it is.
    pub value: Value,
}

/// The kinds of TOML value.
#[derive(Debug, Clone)]
pub enum Value {
    /// A string.
    Text(String),
    /// A whole number.
    Integer(i64),
    /// Any other number, or a whole one too large for 64 bits.
    Float(f64),
    /// `true` or `false`.
    Boolean(bool),
    /// A date or time: no scene has use for one.
    Date,
    /// Also `[[tables]]`.
    Array(Vec<Node>),
    /// A table.
    Table(Table),
}

/// Keys, with their places, and values, in the order of the file.
pub type Table = Vec<(String, Place, Node)>;

impl Document {
    /// Parses `text`, read from `path`, and puts the overrides in; a syntax error is the only mistake found.
    pub fn parse(text: &str, path: &Path, overrides: &[Override]) -> Result<Self, SceneError> {
        let mut document = Self {
            sources: vec![Source { name: path.to_owned(), text: text.to_owned() }],
            root: Vec::new(),
            faults: Vec::new(),
        };
        let base = Base::default();
        match DeTable::parse(text) {
            Ok(table) => document.root = entries(table.get_ref(), base),
            Err(error) => {
                let fault = Fault {
                    place: base.place(error.span().unwrap_or_default()),
                    problem: format!("not TOML: {}", error.message()),
                    help: match error.message() {
                        "duplicate key" => {
                            "it stands above already; what there may be several of, such as objects and lights, has \
                                            two brackets, each time: [[objects]]"
                                .to_owned()
                        }
                        _ => String::new(),
                    },
                };
                return Err(SceneError::Mistakes(vec![document.locate(fault)]));
            }
        }
        for over in overrides {
            let source = document.sources.len();
            document.sources.push(Source { name: PathBuf::from(over.name()), text: over.text().to_owned() });
            if let Err(fault) = over.apply(&mut document.root, source) {
                document.faults.push(fault);
            }
        }
        Ok(document)
    }

    /// Puts the value of a frame where `path` leads; `key` is where the animation names it.
    pub fn animate(&mut self, path: &[String], value: Node, key: Place) {
        match overrides::reach(&mut self.root, path, key) {
            Ok(old) if old.place.source != 0 && old.place.source != key.source => {
                let problem = format!("`{}` is animated, so that no other value is asked for", path.join("."));
                let help = "set the values of its track instead".to_owned();
                self.faults.push(Fault { place: old.place, problem, help });
            }
            Ok(old) => *old = value,
            Err(fault) => self.faults.push(fault),
        }
    }

    /// The file's path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.sources[0].name
    }

    /// The place of a part of a string, in bytes of its text: exact unless the string is written with escapes.
    #[must_use]
    pub fn inside(&self, node: &Node, part: Range<usize>) -> Place {
        let Place { source, start, end } = node.place;
        let written = self.sources[source].text.get(start..end);
        let offset = match &node.value {
            Value::Text(text) => written.and_then(|written| written.find(text.as_str())),
            _ => None,
        };
        match offset {
            Some(offset) => Place { source, start: start + offset + part.start, end: start + offset + part.end },
            None => node.place,
        }
    }

    /// Looks a fault's place up.
    #[must_use]
    pub fn locate(&self, fault: Fault) -> Mistake {
        let Place { source, start, end } = fault.place;
        let source = &self.sources[source];
        Mistake::locate(source.name.clone(), &source.text, start, end, fault.problem, fault.help)
    }
}

/// The start of the file: where something is missing that has no other place.
pub const TOP: Place = Place { source: 0, start: 0, end: 0 };

/// Where the places of a tree count from.
#[derive(Debug, Clone, Copy, Default)]
struct Base {
    source: usize,
    /// Bytes before the parsed text.
    offset: usize,
}

impl Base {
    fn place(self, span: Range<usize>) -> Place {
        Place { source: self.source, start: span.start + self.offset, end: span.end + self.offset }
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
    // Rust reads every float that TOML writes; one too large for 64 bits becomes infinite, and is refused as such.
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
