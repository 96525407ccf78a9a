//! Tables that describe one of several kinds, which one of their keys names.

use super::reader::TableReader;
use super::values::choice;
use super::{Key, KeyReference};

/// One kind of the things that a table describes; `READ` is the type of the function that reads it.
pub struct Kind<READ: 'static> {
    /// The name in a scene file.
    pub name: &'static str,
    /// The keys that the kind reads.
    pub keys: &'static [Key],
    /// The function that reads the kind; it returns `None` if the table cannot be used.
    pub(crate) read: READ,
}

/// All kinds that a table may describe.
pub struct Kinds<READ: 'static> {
    /// The table.
    pub table: &'static str,
    /// The key that names the kind.
    pub chooser: &'static str,
    /// The meaning of that key.
    pub meaning: &'static str,
    /// The kind that the error message suggests if the key is missing; if `None`, the first kind is the default.
    pub example: Option<&'static str>,
    /// Every kind, in the order of the reference.
    pub all: &'static [&'static Kind<READ>],
}

impl<READ> Kinds<READ> {
    /// Returns the reader of the kind that a table names, or `None` if there is no such kind.
    pub(crate) fn chosen(&self, table: &TableReader) -> Option<&'static READ> {
        let names: Vec<&str> = self.all.iter().map(|kind| kind.name).collect();
        let kind = match self.example {
            Some(example) => table.decide_required(self.chooser, &format!("\"{example}\""), choice(&names)),
            None => table.decide(self.chooser, 0, choice(&names)),
        };
        kind.map(|kind| &self.all[kind].read)
    }

    /// Returns the reference rows of the key that names the kind, and of the keys that the kinds read.
    #[must_use]
    pub fn reference(&self) -> Vec<KeyReference> {
        let kinds: Vec<(&str, &[Key])> = self.all.iter().map(|kind| (kind.name, kind.keys)).collect();
        let default = self.example.map_or(kinds[0].0, |_| "required");
        kind_rows(self.table, (self.chooser, default, self.meaning), &kinds)
    }
}

/// Returns the reference rows of a table that is one of several kinds: first the row of the key that names the kind, with its default and
/// meaning, then the rows of each kind's keys. Kinds for which a key has the same meaning share its row.
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

/// Formats names as `"a"`, `"a" or "b"`, or `"a", "b" or "c"`.
fn alternatives(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    match quoted.as_slice() {
        [most @ .., last] if !most.is_empty() => format!("{} or {last}", most.join(", ")),
        all => all.concat(),
    }
}
