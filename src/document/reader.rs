//! Reading a tree: tables are queried for their keys, and errors and unread keys are collected.
//!
//! A [`TableReader`] reads keys, and [`TableReader::finish`] rejects the keys that were not read. The code that reads a
//! table therefore defines its keys. Only the reference lists them again: messages use it to state when a key is valid,
//! and a test compares it with the keys that are read.
//!
//! *Length.* Over 300 lines, because it is one type, with a method for each way to read a key.

use super::error::{Diagnostic, ENOUGH};
use super::values::{Parsed, suggest};
use super::{Document, KeyReference, Node, Span, SpannedError, TOP, Table, Value};
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

/// A collector of the errors that are found while a document is read.
pub struct Reader<'a> {
    document: &'a Document,
    reference: &'a [KeyReference],
    mistakes: RefCell<Vec<Diagnostic>>,
    asked: RefCell<BTreeSet<(&'static str, &'static str)>>,
}

impl<'a> Reader<'a> {
    /// Creates a reader that starts with the errors of the document's overrides; `reference` lists the keys that are valid together.
    #[must_use]
    pub fn new(document: &'a Document, reference: &'a [KeyReference]) -> Self {
        let faults = document.faults.iter().cloned();
        Self {
            document,
            reference,
            mistakes: RefCell::new(faults.map(|f| document.locate(f)).collect()),
            asked: RefCell::default(),
        }
    }

    /// Returns a reader of the top-level table.
    pub fn root(&self) -> TableReader<'_, 'a> {
        self.table("", &self.document.root, TOP)
    }

    /// Records a fault.
    pub fn fault(&self, fault: SpannedError) {
        if self.mistakes.borrow().len() < ENOUGH {
            self.mistake(self.document.locate(fault));
        }
    }

    /// Returns the folder of the scene file, to which the file names in it are relative.
    pub fn folder(&self) -> &Path {
        self.document.path().parent().unwrap_or(Path::new(""))
    }

    /// Returns the line of a location, from 1.
    pub fn line(&self, place: Span) -> usize {
        self.document.locate(SpannedError { place, problem: String::new(), help: String::new() }).line
    }

    /// Records an error in a part of a string, given in bytes of its text.
    pub fn fault_inside(&self, node: &Node, part: Range<usize>, problem: String, help: String) {
        self.fault(SpannedError { place: self.document.inside(node, part), problem, help });
    }

    /// Records an error of another file.
    pub fn mistake(&self, mistake: Diagnostic) {
        self.mistakes.borrow_mut().push(mistake);
    }

    /// Returns the recorded errors.
    pub fn into_mistakes(self) -> Vec<Diagnostic> {
        self.mistakes.into_inner()
    }

    /// Returns every key that was read, with its table.
    #[cfg(test)]
    pub fn asked(&self) -> BTreeSet<(&'static str, &'static str)> {
        self.asked.borrow().clone()
    }

    /// Returns the value, or records the fault and returns `None`.
    pub fn accept<T>(&self, read: Parsed<T>) -> Option<T> {
        read.map_err(|fault| self.fault(fault)).ok()
    }

    /// Returns a reader of a node that must be a table; `path` is the table's name in the reference.
    pub fn open(&self, path: &'static str, node: &'a Node) -> Option<TableReader<'_, 'a>> {
        if let Value::Table(table) = &node.value {
            return Some(self.table(path, table, node.place));
        }
        self.fault(node.expected("a table"));
        None
    }

    fn table(&self, path: &'static str, table: &'a Table, place: Span) -> TableReader<'_, 'a> {
        TableReader { reader: self, path, table, place, asked: RefCell::default(), lenient: Cell::new(false) }
    }
}

/// A reader of one table.
pub struct TableReader<'r, 'a> {
    /// The reader that collects errors.
    pub reader: &'r Reader<'a>,
    path: &'static str,
    table: &'a Table,
    /// The table's header or braces.
    pub place: Span,
    asked: RefCell<Vec<&'static str>>,
    lenient: Cell<bool>,
}

impl<'r, 'a> TableReader<'r, 'a> {
    /// Returns `true` if the table has the key, without marking the key as read.
    pub fn gives(&self, key: &str) -> bool {
        self.table.iter().any(|(name, _, _)| name == key)
    }

    /// Returns the node of a key and marks the key as read; `None` if the table does not have it.
    pub fn node(&self, key: &'static str) -> Option<&'a Node> {
        let mut asked = self.asked.borrow_mut();
        if !asked.contains(&key) {
            asked.push(key);
        }
        self.reader.asked.borrow_mut().insert((self.path, key));
        let mut entries = self.table.iter();
        entries.find_map(|(name, _, node)| (name == key).then_some(node))
    }

    /// Returns the value of a key, or `None` if it is missing or wrong.
    pub fn optional<T>(&self, key: &'static str, read: impl Fn(&'a Node) -> Parsed<T>) -> Option<T> {
        self.accept(key, read(self.node(key)?))
    }

    /// Returns the value, or records the fault of the key's value; a fault without help gets its help from the reference.
    fn accept<T>(&self, key: &str, read: Parsed<T>) -> Option<T> {
        let explained = |fault: SpannedError| {
            if fault.help.is_empty() { SpannedError { help: self.meaning(key), ..fault } } else { fault }
        };
        self.reader.accept(read.map_err(explained))
    }

    /// Returns the meaning of a key in the reference; empty if each of many kinds gives it a different meaning.
    fn meaning(&self, key: &str) -> String {
        const TOLD: usize = 3;
        let rows = self.reader.reference.iter().filter(|row| row.table == self.path && row.key == key);
        let mut told: Vec<(String, &str)> = Vec::new();
        for row in rows {
            let said = format!("{} ({})", row.meaning, row.value);
            if told.iter().all(|(other, _)| *other != said) {
                told.push((said, &row.when));
            }
        }
        match &told[..] {
            [(said, _)] => format!("`{key}`: {said}"),
            several if several.len() <= TOLD => {
                let each = several.iter().map(|(said, when)| match *when {
                    "" => format!("`{key}`: {said}"),
                    when => format!("`{key}` with {when}: {said}"),
                });
                each.collect::<Vec<_>>().join("; ")
            }
            _ => String::new(),
        }
    }

    /// Returns the value of a key, or `default` if it is missing or wrong.
    pub fn or<T>(&self, key: &'static str, default: T, read: impl Fn(&'a Node) -> Parsed<T>) -> T {
        self.optional(key, read).unwrap_or(default)
    }

    /// Returns the value of a required key; `example` shows in the error message how to write it.
    pub fn required<T>(&self, key: &'static str, example: &str, read: impl Fn(&'a Node) -> Parsed<T>) -> Option<T> {
        self.accept(key, read(self.required_node(key, example)?))
    }

    /// Returns the node of a required key.
    pub fn required_node(&self, key: &'static str, example: &str) -> Option<&'a Node> {
        let node = self.node(key);
        if node.is_none() {
            let help = format!("for example {key} = {example}");
            self.fault(&[], format!("missing key `{key}`"), help);
        }
        node
    }

    /// Returns the value of a key on which other keys depend; if it is wrong, keys that are valid with any value are not reported.
    pub fn decide<T>(&self, key: &'static str, default: T, read: impl Fn(&'a Node) -> Parsed<T>) -> Option<T> {
        let Some(node) = self.node(key) else {
            return Some(default);
        };
        let value = self.accept(key, read(node));
        self.lenient.set(self.lenient.get() || value.is_none());
        value
    }

    /// Reads a required key as [`Self::decide`] does.
    pub fn decide_required<T>(
        &self,
        key: &'static str,
        example: &str,
        read: impl Fn(&'a Node) -> Parsed<T>,
    ) -> Option<T> {
        let value = self.required(key, example, read);
        self.lenient.set(self.lenient.get() || value.is_none());
        value
    }

    /// Returns a reader of the table that is a key's value.
    pub fn subtable(&self, key: &'static str, path: &'static str) -> Option<TableReader<'r, 'a>> {
        self.reader.open(path, self.node(key)?)
    }

    /// Returns readers of the tables in a key's array; empty if the key is missing.
    pub fn subtables(&self, key: &'static str, path: &'static str) -> Vec<TableReader<'r, 'a>> {
        let Some(node) = self.node(key) else {
            return Vec::new();
        };
        let Value::Array(items) = &node.value else {
            let fault = node.expected(&format!("tables with the header [[{path}]]"));
            self.reader.fault(fault);
            return Vec::new();
        };
        let tables = items.iter().filter_map(|item| self.reader.open(path, item));
        tables.collect()
    }

    /// Returns all keys and values, for a table whose keys are chosen by the user.
    pub fn entries(&self) -> impl Iterator<Item = (&'a str, &'a Node)> {
        self.table.iter().map(|(name, _, node)| (name.as_str(), node))
    }

    /// Reads the entries of a table with names that the user chooses, in order; all are read before the first error returns.
    pub fn named<T>(
        &self,
        key: &'static str,
        path: &'static str,
        read: &dyn Fn(&'a Node) -> Option<T>,
    ) -> Option<Vec<(String, &'a Node, T)>> {
        let Some(node) = self.node(key) else { return Some(Vec::new()) };
        let own = self.reader.open(path, node)?;
        let all: Vec<Option<_>> =
            own.entries().map(|(name, node)| Some((name.to_owned(), node, read(node)?))).collect();
        all.into_iter().collect()
    }

    /// Records an error at the value of a key in a subtable, or else as [`TableReader::fault`] does.
    pub fn fault_within(&self, table: &str, key: &str, problem: String, help: String) {
        let inner = self.table.iter().find(|(name, _, _)| name == table).map(|(_, _, node)| &node.value);
        let node = match inner {
            Some(Value::Table(inner)) => inner.iter().find(|(name, _, _)| name == key).map(|(_, _, node)| node),
            _ => None,
        };
        match node {
            Some(node) => self.reader.fault(SpannedError { place: node.place, problem, help }),
            None => self.fault(&[table], problem, help),
        }
    }

    /// Records an error at the value of the first of these keys that the table has, or else at the table.
    pub fn fault(&self, keys: &[&str], problem: impl Into<String>, help: impl Into<String>) {
        let place = |key: &&str| {
            let mut entries = self.table.iter();
            entries.find_map(|(name, _, node)| (name == key).then_some(node.place))
        };
        self.reader.fault(SpannedError {
            place: keys.iter().find_map(place).unwrap_or(self.place),
            problem: problem.into(),
            help: help.into(),
        });
    }

    /// Returns the one of several exclusive keys that the table has, with its node; two of them are an error.
    pub fn one_of(&self, keys: &[&'static str]) -> Option<(&'static str, &'a Node)> {
        let given = keys.iter().filter_map(|key| Some((*key, self.node(key)?)));
        let given: Vec<_> = given.collect();
        if let [(first, _), (second, node), ..] = given[..] {
            let problem = format!("`{second}` cannot be combined with `{first}`");
            self.reader.fault(node.fault(problem, ""));
            self.lenient.set(true);
        }
        given.first().copied()
    }

    /// Reads a table that must have one of the keys, as [`Self::one_of`] does; `what` describes the expected value in the error message.
    pub fn required_one_of(&self, keys: &[&'static str], what: &str) -> Option<(&'static str, &'a Node)> {
        let given = self.one_of(keys);
        if given.is_none() {
            self.fault(&[], format!("expected {what}"), "");
            self.lenient.set(true);
        }
        given
    }

    /// Records an error for every key that was not read.
    pub fn finish(self) {
        let asked = self.asked.borrow();
        let listed = || self.reader.reference.iter().filter(|r| r.table == self.path);
        for (name, place, _) in self.table {
            let name = name.as_str();
            let elsewhere: Vec<&str> = listed().filter(|r| r.key == name).map(|r| r.when.as_str()).collect();
            if asked.contains(&name) || (self.lenient.get() && !elsewhere.is_empty()) {
                continue;
            }
            let (problem, help) = if elsewhere.is_empty() {
                let mut keys: Vec<&str> =
                    if self.lenient.get() { listed().map(|r| r.key).collect() } else { asked.clone() };
                // Several kinds may have the same key.
                let mut told = BTreeSet::new();
                keys.retain(|key| told.insert(*key));
                let help = suggest(name, &keys, "valid keys");
                (format!("unknown key `{name}`"), help)
            } else {
                let (with, keys) = (elsewhere.join(", or "), asked.join(", "));
                let help = format!("remove it, or use it with {with}; valid keys: {keys}");
                (format!("`{name}` cannot be combined with the rest of this table"), help)
            };
            self.reader.fault(SpannedError { place: *place, problem, help });
        }
    }
}
