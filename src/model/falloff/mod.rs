//! Fall-offs: how a source's force depends on the distance r from it, one kind a file.
//!
//! *Practice.* [`FALLOFFS`] names each kind once. The WGSL contract is `KIND_acceleration(x)`, the sum over the sources of that
//! kind, and `KIND_distance(x)`, how near the nearest of them is.

mod cubic;
mod inverse_square;
mod yukawa;

use std::fmt;

use super::same::named;
use super::{Row, Value};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::document::{Key, KeyReference, Node, Value as Written};

/// Every kind; the first is that of a source that names none.
pub const FALLOFFS: [&Kind; 3] = [&inverse_square::KIND, &cubic::KIND, &yukawa::KIND];

/// What is known of a kind of fall-off.
pub struct Kind {
    /// As a scene file has it.
    pub name: &'static str,
    /// Its length or rate, if it has one, as a member of its sources in WGSL; a scene file writes `{ name = number }` then.
    pub parameter: Option<(&'static str, Key)>,
    /// The name of its WGSL part in `shaders/law/falloff/`, of its functions and of its list.
    pub wgsl: &'static str,
    /// V at a distance, of a source of strength 1; 0 far away.
    pub potential: fn(r: f64, parameter: f64) -> f64,
    /// Outside of this distance there is no force; 0 if there is some everywhere.
    pub reach: fn(parameter: f64) -> f64,
    /// The WGSL part of an orbit about a single centre.
    pub orbit: &'static str,
    /// Does it fall by an inverse power, so that an orbit has an asymptote in closed form?
    pub is_free_far_away: bool,
}

/// A fall-off with its parameter.
#[derive(Clone, Copy, PartialEq)]
pub struct Falloff {
    /// Its kind.
    pub kind: &'static Kind,
    /// Its length or rate; 0 if it has none.
    pub parameter: f64,
}

impl Falloff {
    /// 1/r².
    pub const INVERSE_SQUARE: Self = Self { kind: FALLOFFS[0], parameter: 0.0 };

    /// The kind of this name at a parameter.
    #[must_use]
    pub fn named(name: &str, parameter: f64) -> Option<Self> {
        FALLOFFS.into_iter().find(|kind| kind.name == name).map(|kind| Self { kind, parameter })
    }

    /// V at a distance from a source of strength 1.
    #[must_use]
    pub fn potential(&self, r: f64) -> f64 {
        (self.kind.potential)(r, self.parameter)
    }

    /// The radius outside of which there is no force; 0 if there is some everywhere.
    #[must_use]
    pub fn reach(&self) -> f64 {
        (self.kind.reach)(self.parameter)
    }

    /// Its own member of a source in WGSL.
    #[must_use]
    pub fn values(&self) -> Row {
        self.kind.parameter.map(|(member, _)| (member.into(), Value::Float(self.parameter))).into_iter().collect()
    }
}

named!(Kind);

impl fmt::Debug for Falloff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.kind.name, self.parameter)
    }
}

/// The fall-off that a node of `table` gives.
pub(crate) fn read(table: &TableReader, node: &Node) -> Option<Falloff> {
    let (words, tables): (Vec<&Kind>, Vec<&Kind>) = FALLOFFS.into_iter().partition(|kind| kind.parameter.is_none());
    let written: Vec<String> = words.iter().map(|kind| format!("\"{}\"", kind.name)).collect();
    let braces = |kind: &&Kind| Some(format!("{{ {} = {} }}", kind.name, kind.parameter?.1.value));
    let all: Vec<String> = written.into_iter().chain(tables.iter().filter_map(braces)).collect();
    let choices = match all.as_slice() {
        [most @ .., last] if !most.is_empty() => format!("{} or {last}", most.join(", ")),
        all => all.concat(),
    };
    match &node.value {
        Written::Text(word) => {
            if let Some(kind) = words.into_iter().find(|kind| kind.name == word) {
                return Some(Falloff { kind, parameter: 0.0 });
            }
        }
        Written::Table(_) => {
            let own = table.reader.open("law.sources.falloff", node)?;
            let names: Vec<&'static str> = tables.iter().map(|kind| kind.name).collect();
            let given = own.required_one_of(&names, &choices);
            let value = given.and_then(|(key, node)| Some((key, own.reader.accept(positive(node))?)));
            own.finish();
            let (name, parameter) = value?;
            return Falloff::named(name, parameter);
        }
        _ => {}
    }
    table.reader.fault(node.expected(&choices));
    None
}

/// The reference's rows of the fall-offs that have a parameter.
#[must_use]
pub fn reference() -> Vec<KeyReference> {
    let keys: Vec<(&str, Key)> = FALLOFFS.iter().filter_map(|kind| Some((kind.name, kind.parameter?.1))).collect();
    let row = |(name, key): &(&'static str, Key)| KeyReference {
        table: "law.sources.falloff",
        key: name,
        when: keys
            .iter()
            .filter(|(other, _)| other != name)
            .map(|(other, _)| format!("no {other}"))
            .collect::<Vec<_>>()
            .join(" and "),
        value: "number above 0".to_owned(),
        default: key.default,
        meaning: key.meaning,
    };
    keys.iter().map(row).collect()
}
