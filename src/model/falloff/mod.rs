//! Fall-offs: the dependence of a source's force on the distance r from it; one file per kind.
//!
//! *Practice.* [`FALLOFFS`] lists each kind once. The WGSL contract is `KIND_acceleration(x)`, the sum over the sources of one kind, and
//! `KIND_distance(x)`, the distance of the nearest of them.

mod cubic;
mod inverse_square;
mod yukawa;

use std::fmt;

use super::dyn_eq::named;
use super::{Row, Value};
use crate::document::reader::TableReader;
use crate::document::values::positive;
use crate::document::{Key, KeyReference, Node, Value as Written};

/// The list of all kinds; the first is the default.
pub const FALLOFFS: [&FalloffKind; 3] = [&inverse_square::KIND, &cubic::KIND, &yukawa::KIND];

/// The description of a kind of fall-off.
pub struct FalloffKind {
    /// The name in a scene file.
    pub name: &'static str,
    /// The name and key of the length or rate, if the kind has one, as a member of its sources in WGSL; a scene file then writes `{ name =
    /// number }`.
    pub parameter: Option<(&'static str, Key)>,
    /// The name of the WGSL module in `shaders/law/falloff/`, and the prefix of its functions and list.
    pub wgsl: &'static str,
    /// The potential V at a distance r from a source of strength 1; 0 at infinity.
    pub potential: fn(r: f64, parameter: f64) -> f64,
    /// The distance beyond which the force vanishes; 0 if the range is infinite.
    pub reach: fn(parameter: f64) -> f64,
    /// The WGSL module of an orbit around a single center.
    pub orbit: &'static str,
    /// Is `true` if the force falls off as an inverse power, so that the asymptote of an orbit has a closed form.
    pub is_free_far_away: bool,
}

/// A fall-off with its parameter.
#[derive(Clone, Copy, PartialEq)]
pub struct Falloff {
    /// The kind of fall-off.
    pub kind: &'static FalloffKind,
    /// The length or rate; 0 if the kind has none.
    pub parameter: f64,
}

impl Falloff {
    /// The inverse-square fall-off 1/r².
    pub const INVERSE_SQUARE: Self = Self { kind: FALLOFFS[0], parameter: 0.0 };

    /// Returns the fall-off of the kind `name` with a parameter, or `None` if there is no such kind.
    #[must_use]
    pub fn named(name: &str, parameter: f64) -> Option<Self> {
        FALLOFFS.into_iter().find(|kind| kind.name == name).map(|kind| Self { kind, parameter })
    }

    /// Returns the potential V at a distance from a source of strength 1.
    #[must_use]
    pub fn potential(&self, r: f64) -> f64 {
        (self.kind.potential)(r, self.parameter)
    }

    /// Returns the radius beyond which the force vanishes; 0 if the range is infinite.
    #[must_use]
    pub fn reach(&self) -> f64 {
        (self.kind.reach)(self.parameter)
    }

    /// Returns the member of a source in WGSL that only this kind has.
    #[must_use]
    pub fn values(&self) -> Row {
        self.kind.parameter.map(|(member, _)| (member.into(), Value::Float(self.parameter))).into_iter().collect()
    }
}

named!(FalloffKind);

impl fmt::Debug for Falloff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.kind.name, self.parameter)
    }
}

/// Reads a fall-off from a node of `table`.
pub(crate) fn read(table: &TableReader, node: &Node) -> Option<Falloff> {
    let (words, tables): (Vec<&FalloffKind>, Vec<&FalloffKind>) =
        FALLOFFS.into_iter().partition(|kind| kind.parameter.is_none());
    let written: Vec<String> = words.iter().map(|kind| format!("\"{}\"", kind.name)).collect();
    let braces = |kind: &&FalloffKind| Some(format!("{{ {} = {} }}", kind.name, kind.parameter?.1.value));
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

/// Returns the reference rows of the fall-offs that have a parameter.
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
