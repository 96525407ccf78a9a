//! Walking the tree: tables are asked for their keys; faults are collected, and so are keys nobody asked for.
//!
//! A [`TableReader`] asks, and [`TableReader::finish`] refuses the keys that nobody asked for. So the keys of a
//! table are those its reading asks for, and nothing else lists them but the reference, which tells the user when a
//! key would have been asked for, and is tested against the asking.
//!
//! *Length.* Over 300 lines, because it is one type, with a method for each way to ask for a key.

use super::error::{ENOUGH, Mistake};
use super::values::{Read, suggest};
use super::{Document, Fault, KeyReference, Node, Place, TOP, Table, Value};
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

/// Collects what is wrong while a document is read.
pub struct Reader<'a> {
    document: &'a Document,
    reference: &'a [KeyReference],
    mistakes: RefCell<Vec<Mistake>>,
    asked: RefCell<BTreeSet<(&'static str, &'static str)>>,
}

impl<'a> Reader<'a> {
    /// Begins with the faults of the document's overrides; `reference` says what goes with what.
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

    /// The top level.
    pub fn root(&self) -> TableReader<'_, 'a> {
        self.table("", &self.document.root, TOP)
    }

    /// Records a fault.
    pub fn fault(&self, fault: Fault) {
        if self.mistakes.borrow().len() < ENOUGH {
            self.mistake(self.document.locate(fault));
        }
    }

    /// The folder of the scene file: names of files are relative to it.
    pub fn folder(&self) -> &Path {
        self.document.path().parent().unwrap_or(Path::new(""))
    }

    /// The line of a place, from 1.
    pub fn line(&self, place: Place) -> usize {
        self.document.locate(Fault { place, problem: String::new(), help: String::new() }).line
    }

    /// Records what is wrong with a part of a string, in bytes of its text.
    pub fn fault_inside(&self, node: &Node, part: Range<usize>, problem: String, help: String) {
        self.fault(Fault { place: self.document.inside(node, part), problem, help });
    }

    /// Records a mistake of another file.
    pub fn mistake(&self, mistake: Mistake) {
        self.mistakes.borrow_mut().push(mistake);
    }

    /// What was recorded.
    pub fn into_mistakes(self) -> Vec<Mistake> {
        self.mistakes.into_inner()
    }

    /// Every key that was asked for, with its table.
    #[cfg(test)]
    pub fn asked(&self) -> BTreeSet<(&'static str, &'static str)> {
        self.asked.borrow().clone()
    }

    /// Records the fault, if it is one.
    pub fn accept<T>(&self, read: Read<T>) -> Option<T> {
        read.map_err(|fault| self.fault(fault)).ok()
    }

    /// To read a node that must be a table; `path` is the table's name in the reference.
    pub fn open(&self, path: &'static str, node: &'a Node) -> Option<TableReader<'_, 'a>> {
        if let Value::Table(table) = &node.value {
            return Some(self.table(path, table, node.place));
        }
        self.fault(node.expected("a table"));
        None
    }

    fn table(&self, path: &'static str, table: &'a Table, place: Place) -> TableReader<'_, 'a> {
        TableReader { reader: self, path, table, place, asked: RefCell::default(), lenient: Cell::new(false) }
    }
}

/// One table being read.
pub struct TableReader<'r, 'a> {
    /// Who collects.
    pub reader: &'r Reader<'a>,
    path: &'static str,
    table: &'a Table,
    /// Its header or braces.
    pub place: Place,
    asked: RefCell<Vec<&'static str>>,
    lenient: Cell<bool>,
}

impl<'r, 'a> TableReader<'r, 'a> {
    /// Does the table have the key? Asking does not make it one that is read.
    pub fn gives(&self, key: &str) -> bool {
        self.table.iter().any(|(name, _, _)| name == key)
    }

    /// The node of a key, if the table has it.
    pub fn node(&self, key: &'static str) -> Option<&'a Node> {
        let mut asked = self.asked.borrow_mut();
        if !asked.contains(&key) {
            asked.push(key);
        }
        self.reader.asked.borrow_mut().insert((self.path, key));
        let mut entries = self.table.iter();
        entries.find_map(|(name, _, node)| (name == key).then_some(node))
    }

    /// The value of a key; none if it is missing or wrong.
    pub fn optional<T>(&self, key: &'static str, read: impl Fn(&'a Node) -> Read<T>) -> Option<T> {
        self.accept(key, read(self.node(key)?))
    }

    /// Records the fault of a key's value, if it is one; where it does not say what would be right, the reference does.
    fn accept<T>(&self, key: &str, read: Read<T>) -> Option<T> {
        let explained = |fault: Fault| {
            if fault.help.is_empty() { Fault { help: self.meaning(key), ..fault } } else { fault }
        };
        self.reader.accept(read.map_err(explained))
    }

    /// What the reference says of a key; nothing where that is something else with each of many kinds.
    fn meaning(&self, key: &str) -> String {
        const TOLD: usize = 3;
        let rows = self.reader.reference.iter().filter(|row| row.table == self.path && row.key == key);
        let mut told: Vec<(String, &str)> = Vec::new();
        for row in rows {
            let said = format!("{}: {}", row.value, row.meaning);
            if told.iter().all(|(other, _)| *other != said) {
                told.push((said, &row.when));
            }
        }
        match &told[..] {
            [(said, _)] => format!("{key} is {said}"),
            several if several.len() <= TOLD => {
                let each = several.iter().map(|(said, when)| match *when {
                    "" => format!("{key} is {said}"),
                    when => format!("with {when} {key} is {said}"),
                });
                each.collect::<Vec<_>>().join("; ")
            }
            _ => String::new(),
        }
    }

    /// The value of a key; `default` if it is missing or wrong.
    pub fn or<T>(&self, key: &'static str, default: T, read: impl Fn(&'a Node) -> Read<T>) -> T {
        self.optional(key, read).unwrap_or(default)
    }

    /// The value of a key that must be there; `example` shows how it is written.
    pub fn required<T>(&self, key: &'static str, example: &str, read: impl Fn(&'a Node) -> Read<T>) -> Option<T> {
        self.accept(key, read(self.required_node(key, example)?))
    }

    /// The node of a key that must be there.
    pub fn required_node(&self, key: &'static str, example: &str) -> Option<&'a Node> {
        let node = self.node(key);
        if node.is_none() {
            let help = format!("for example {key} = {example}");
            self.fault(&[], format!("missing key `{key}`"), help);
        }
        node
    }

    /// The value of a key on which the other keys depend: if it is wrong, keys that go with any value are let be.
    pub fn decide<T>(&self, key: &'static str, default: T, read: impl Fn(&'a Node) -> Read<T>) -> Option<T> {
        let Some(node) = self.node(key) else {
            return Some(default);
        };
        let value = self.accept(key, read(node));
        self.lenient.set(self.lenient.get() || value.is_none());
        value
    }

    /// As [`Self::decide`], for a key that must be there.
    pub fn decide_required<T>(
        &self,
        key: &'static str,
        example: &str,
        read: impl Fn(&'a Node) -> Read<T>,
    ) -> Option<T> {
        let value = self.required(key, example, read);
        self.lenient.set(self.lenient.get() || value.is_none());
        value
    }

    /// The table that is a key's value.
    pub fn subtable(&self, key: &'static str, path: &'static str) -> Option<TableReader<'r, 'a>> {
        self.reader.open(path, self.node(key)?)
    }

    /// The tables of a key's array, with their nodes; none if it is missing.
    pub fn subtables(&self, key: &'static str, path: &'static str) -> Vec<TableReader<'r, 'a>> {
        let Some(node) = self.node(key) else {
            return Vec::new();
        };
        let Value::Array(items) = &node.value else {
            let fault = node.expected(&format!("tables, each headed [[{path}]]"));
            self.reader.fault(fault);
            return Vec::new();
        };
        let tables = items.iter().filter_map(|item| self.reader.open(path, item));
        tables.collect()
    }

    /// All keys and values, for a table whose keys are free names.
    pub fn entries(&self) -> impl Iterator<Item = (&'a str, &'a Node)> {
        self.table.iter().map(|(name, _, node)| (name.as_str(), node))
    }

    /// Records a mistake at the value of a key of a table in this one, else as [`TableReader::fault`].
    pub fn fault_within(&self, table: &str, key: &str, problem: String, help: String) {
        let inner = self.table.iter().find(|(name, _, _)| name == table).map(|(_, _, node)| &node.value);
        let node = match inner {
            Some(Value::Table(inner)) => inner.iter().find(|(name, _, _)| name == key).map(|(_, _, node)| node),
            _ => None,
        };
        match node {
            Some(node) => self.reader.fault(Fault { place: node.place, problem, help }),
            None => self.fault(&[table], problem, help),
        }
    }

    /// Records a mistake at the value of the first of these keys that the table has, else at the table.
    pub fn fault(&self, keys: &[&str], problem: impl Into<String>, help: impl Into<String>) {
        let place = |key: &&str| {
            let mut entries = self.table.iter();
            entries.find_map(|(name, _, node)| (name == key).then_some(node.place))
        };
        self.reader.fault(Fault {
            place: keys.iter().find_map(place).unwrap_or(self.place),
            problem: problem.into(),
            help: help.into(),
        });
    }

    /// The value of the one key of several that the table has; having two is a mistake.
    pub fn one_of(&self, keys: &[&'static str]) -> Option<(&'static str, &'a Node)> {
        let given = keys.iter().filter_map(|key| Some((*key, self.node(key)?)));
        let given: Vec<_> = given.collect();
        if let [(first, _), (second, node), ..] = given[..] {
            let problem = format!("`{second}` and `{first}` exclude each other");
            self.reader.fault(node.fault(problem, ""));
            self.lenient.set(true);
        }
        given.first().copied()
    }

    /// As [`Self::one_of`], for a table that must have one; `what` it then is.
    pub fn required_one_of(&self, keys: &[&'static str], what: &str) -> Option<(&'static str, &'a Node)> {
        let given = self.one_of(keys);
        if given.is_none() {
            self.fault(&[], format!("expected {what}"), "");
            self.lenient.set(true);
        }
        given
    }

    /// Records every key that was not asked for.
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
                // Several kinds may have one.
                let mut told = BTreeSet::new();
                keys.retain(|key| told.insert(*key));
                let help = suggest(name, &keys, "keys here");
                (format!("unknown key `{name}`"), help)
            } else {
                let (with, keys) = (elsewhere.join(", or "), asked.join(", "));
                let help = format!("leave it out, or use it with {with}; keys here: {keys}");
                (format!("`{name}` does not go with the rest of this table"), help)
            };
            self.reader.fault(Fault { place: *place, problem, help });
        }
    }
}
