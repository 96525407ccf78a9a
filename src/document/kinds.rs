//! A table that is one of several kinds, named by one of its keys.

use super::reader::TableReader;
use super::values::choice;
use super::{Key, KeyReference};

/// A kind of what a table describes: `READ` is the function that reads one.
pub struct Kind<READ: 'static> {
    /// As a scene file has it.
    pub name: &'static str,
    /// The keys that it reads.
    pub keys: &'static [Key],
    /// Reads it; none if it cannot be used.
    pub(crate) read: READ,
}

/// All that a table may describe.
pub struct Kinds<READ: 'static> {
    /// The table.
    pub table: &'static str,
    /// The key that names the kind.
    pub chooser: &'static str,
    /// What that key means.
    pub meaning: &'static str,
    /// A kind to name in the message where none is named; without one the first is taken.
    pub example: Option<&'static str>,
    /// Every kind, in the order of the reference.
    pub all: &'static [&'static Kind<READ>],
}

impl<READ> Kinds<READ> {
    /// What reads the kind that a table names; none if there is no such kind.
    pub(crate) fn chosen(&self, table: &TableReader) -> Option<&'static READ> {
        let names: Vec<&str> = self.all.iter().map(|kind| kind.name).collect();
        let kind = match self.example {
            Some(example) => table.decide_required(self.chooser, &format!("\"{example}\""), choice(&names)),
            None => table.decide(self.chooser, 0, choice(&names)),
        };
        kind.map(|kind| &self.all[kind].read)
    }

    /// The rows of the key that names the kind, and of the keys that kinds read.
    #[must_use]
    pub fn reference(&self) -> Vec<KeyReference> {
        let kinds: Vec<(&str, &[Key])> = self.all.iter().map(|kind| (kind.name, kind.keys)).collect();
        let default = self.example.map_or(kinds[0].0, |_| "required");
        kind_rows(self.table, (self.chooser, default, self.meaning), &kinds)
    }
}

/// The rows of a table that is one of several kinds: first that of the key that names the kind, with its default and its meaning,
/// then those of each kind's keys. Kinds that mean the same by a key share its row.
#[must_use]
pub fn kind_rows(
    table: &'static str,
    (chooser, default, meaning): (&'static str, &'static str, &'static str),
    kinds: &[(&str, &[Key])],
) -> Vec<KeyReference> {
    let names: Vec<&str> = kinds.iter().map(|(name, _)| *name).collect();
    let head = KeyReference { table, key: chooser, when: String::new(), value: names.join(" | "), default, meaning };
    let mut rows: Vec<(Key, Vec<&str>)> = Vec::new();
    for (kind, keys) in kinds {
        for key in *keys {
            match rows.iter_mut().find(|(known, _)| known == key) {
                Some((_, with)) => with.push(kind),
                None => rows.push((*key, vec![kind])),
            }
        }
    }
    let row = |(key, with): (Key, Vec<&str>)| KeyReference {
        table,
        key: key.key,
        when: format!("{chooser} = {}{}", alternatives(&with), key.also),
        value: key.value.to_owned(),
        default: key.default,
        meaning: key.meaning,
    };
    std::iter::once(head).chain(rows.into_iter().map(row)).collect()
}

/// `"a"`, `"a" or "b"`, `"a", "b" or "c"`.
fn alternatives(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    match quoted.as_slice() {
        [most @ .., last] if !most.is_empty() => format!("{} or {last}", most.join(", ")),
        all => all.concat(),
    }
}
