//! Overrides, `--set KEY=VALUE`, which are applied to the tree before anything is read from it.

use super::error::SceneError;
use super::{Base, Node, Span, SpannedError, Table, Value, node};
use std::str::FromStr;
use toml::de::{DeTable, DeValue};

/// A value for one key, given on the command line: `rays.step=0.05`, `objects.0.radius=2`, `law.form=geodesic`. An empty value, as in
/// `rays.accuracy=`, removes the key.
#[derive(Debug, Clone)]
pub struct Override {
    /// The argument as given.
    text: String,
    /// The option that messages name as the source of the override; `None` for `--set`.
    option: Option<String>,
    /// The names that lead to the key; a number is the index of a table in an array, from 0.
    path: Vec<String>,
    change: Change,
}

/// The change that an override makes to its key.
#[derive(Debug, Clone)]
enum Change {
    /// The key gets this value.
    Set(Node),
    /// The key is removed; it is an error if the key does not exist.
    LeaveOut,
    /// The key is removed if it exists.
    LeaveOutIfThere,
}

impl FromStr for Override {
    type Err = SceneError;

    /// Parses `KEY=VALUE`. A value that is neither TOML nor likely to be meant as TOML, such as a bare word, is a string.
    fn from_str(text: &str) -> Result<Self, SceneError> {
        let error = |problem: &str| SceneError::Override(format!("`{text}`: {problem}"));
        let Some((key, written)) = text.split_once('=') else {
            return Err(error("expected KEY=VALUE, such as rays.step=0.05 or objects.0.radius=2"));
        };
        let path = names(key).ok_or_else(|| error("the key must be names joined by dots, such as image.size"))?;
        let trimmed = written.trim();
        let base = Base { source: 0, offset: key.len() + 1 + written.len() - written.trim_start().len() };
        let change = match DeValue::parse(trimmed) {
            Ok(value) => Change::Set(node(&value, base)),
            Err(_) if trimmed.is_empty() => Change::LeaveOut,
            Err(e) if trimmed.starts_with(['"', '\'', '[', '{']) => {
                return Err(error(&format!("the value is not valid TOML: {}", e.message())));
            }
            Err(_) => Change::Set(Node { place: base.place(0..trimmed.len()), value: Value::Text(trimmed.to_owned()) }),
        };
        Ok(Self { text: text.to_owned(), option: None, path, change })
    }
}

/// Splits a dotted key into its names, some of which may be quoted; `None` if the key is invalid.
#[must_use]
pub fn names(key: &str) -> Option<Vec<String>> {
    let text = format!("{key} = 0");
    let document = DeTable::parse(&text).ok()?;
    let mut table = document.get_ref();
    let mut names = Vec::new();
    loop {
        let (name, value) = table.iter().next()?;
        names.push(name.get_ref().clone().into_owned());
        match value.get_ref() {
            DeValue::Table(inner) => table = inner,
            _ => return Some(names),
        }
    }
}

impl Override {
    /// Returns an override that removes `key` from `table`, if it exists.
    #[must_use]
    pub fn without(table: &str, key: &str) -> Self {
        Self {
            text: format!("{table}.{key}"),
            option: None,
            path: vec![table.to_owned(), key.to_owned()],
            change: Change::LeaveOutIfThere,
        }
    }

    /// Returns the override with another option, such as `--size 320x180`, as the source that messages name.
    #[must_use]
    pub fn from_option(self, option: String) -> Self {
        Self { option: Some(option), ..self }
    }

    /// Returns the name under which messages report the errors of this override.
    pub(super) fn name(&self) -> String {
        self.option.clone().unwrap_or_else(|| format!("--set {}", self.text))
    }

    /// Returns `KEY=VALUE` as it was given.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Applies the override to a tree in which this override's text is source number `source`. Missing tables are created.
    pub(super) fn apply(&self, root: &mut Table, source: usize) -> Result<(), SpannedError> {
        let key = Span { source, start: 0, end: self.text.find('=').unwrap_or(0) };
        match &self.change {
            Change::Set(value) => {
                let mut value = value.clone();
                relocate(&mut value, source);
                *reach(root, &self.path, key)? = value;
            }
            Change::LeaveOut if !leave_out(root, &self.path) => {
                let problem = format!("cannot remove `{}`, which does not exist", self.path.join("."));
                return Err(SpannedError { place: key, problem, help: "write a value after `=`".to_owned() });
            }
            Change::LeaveOut => {}
            Change::LeaveOutIfThere => _ = leave_out(root, &self.path),
        }
        Ok(())
    }
}

/// Returns the value at `path`: each name leads to a table, which may be new, or
/// to an array that contains the next one. `key` is the location of the names.
pub(super) fn reach<'a>(root: &'a mut Table, path: &[String], key: Span) -> Result<&'a mut Node, SpannedError> {
    let mut at = entry(root, &path[0], key);
    for (depth, name) in path.iter().enumerate().skip(1) {
        let fault = |problem: String| SpannedError { place: key, problem, help: String::new() };
        let above = path[..depth].join(".");
        at = match &mut at.value {
            Value::Table(table) => entry(table, name, key),
            Value::Array(items) => {
                let count = items.len();
                let entries = if count == 1 { "entry" } else { "entries" };
                let item = name.parse().ok().and_then(|i: usize| items.get_mut(i));
                item.ok_or_else(|| fault(format!("`{above}` has {count} {entries}, counted from 0, and no `{name}`")))?
            }
            _ => return Err(fault(format!("`{above}` is not a table"))),
        };
    }
    Ok(at)
}

/// Removes the key at `path` from a table, and returns whether it existed.
fn leave_out(table: &mut Table, path: &[String]) -> bool {
    let [first, rest @ ..] = path else { return false };
    let Some(at) = table.iter().position(|(name, ..)| name == first) else { return false };
    if rest.is_empty() {
        table.remove(at);
        return true;
    }
    leave_out_of(&mut table[at].2.value, rest)
}

fn leave_out_of(value: &mut Value, path: &[String]) -> bool {
    match value {
        Value::Table(inner) => leave_out(inner, path),
        Value::Array(items) => {
            let item = path[0].parse().ok().filter(|at: &usize| *at < items.len());
            match (item, &path[1..]) {
                (Some(at), []) => {
                    items.remove(at);
                    true
                }
                (Some(at), rest) => leave_out_of(&mut items[at].value, rest),
                (None, _) => false,
            }
        }
        _ => false,
    }
}

/// Returns the value of `name`, an empty table if the key is new.
fn entry<'a>(table: &'a mut Table, name: &str, key: Span) -> &'a mut Node {
    let index = table.iter().position(|(n, ..)| n == name);
    let index = index.unwrap_or_else(|| {
        let empty = Node { place: key, value: Value::Table(Table::new()) };
        table.push((name.to_owned(), key, empty));
        table.len() - 1
    });
    &mut table[index].2
}

/// Sets the source of all locations to `source`.
fn relocate(node: &mut Node, source: usize) {
    node.place.source = source;
    match &mut node.value {
        Value::Array(items) => items.iter_mut().for_each(|item| relocate(item, source)),
        Value::Table(table) => {
            for (_, place, value) in table {
                place.source = source;
                relocate(value, source);
            }
        }
        _ => {}
    }
}
