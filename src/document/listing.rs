//! A document as lines, one per value, under the keys that `--set` takes.
//!
//! Documents with equal content have equal lines, whatever their layout: tables may
//! have any order and form, and numbers may be written with or without a decimal point.

use std::collections::BTreeMap;

use super::{Document, Node, Quantity, Table, Value};

impl Document {
    /// Returns every value under its key, sorted; tables and arrays of tables are split into their entries.
    #[must_use]
    pub fn listing(&self) -> BTreeMap<String, String> {
        let mut lines = BTreeMap::new();
        list_table(&self.root, "", &mut lines);
        lines
    }
}

fn list_table(table: &Table, above: &str, lines: &mut BTreeMap<String, String>) {
    for (name, _, node) in table {
        list(node, &below(above, name), lines);
    }
}

fn list(node: &Node, key: &str, lines: &mut BTreeMap<String, String>) {
    let is_table = |item: &Node| matches!(item.value, Value::Table(_));
    match &node.value {
        Value::Table(table) => list_table(table, key, lines),
        Value::Array(items) if !items.is_empty() && items.iter().all(is_table) => {
            for (i, item) in items.iter().enumerate() {
                list(item, &below(key, &i.to_string()), lines);
            }
        }
        value => {
            lines.insert(key.to_owned(), written(value));
        }
    }
}

fn below(above: &str, name: &str) -> String {
    if above.is_empty() { name.to_owned() } else { format!("{above}.{name}") }
}

fn written(value: &Value) -> String {
    let joined = |items: Vec<String>| items.join(", ");
    match value {
        Value::Text(text) | Value::Quantity(Quantity { text, .. }) => format!("{text:?}"),
        Value::Integer(number) => (*number as f64).to_string(),
        Value::Float(number) => number.to_string(),
        Value::Boolean(is) => is.to_string(),
        Value::Date => "date".to_owned(),
        Value::Array(items) => format!("[{}]", joined(items.iter().map(|item| written(&item.value)).collect())),
        Value::Table(table) => {
            let entry = |(name, _, node): &(String, _, Node)| format!("{name} = {}", written(&node.value));
            format!("{{ {} }}", joined(table.iter().map(entry).collect()))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::document::Override;

    fn lines(text: &str, overrides: &[&str]) -> Vec<String> {
        let overrides: Vec<Override> = overrides.iter().map(|over| over.parse().unwrap()).collect();
        let document = Document::parse(text, Path::new("a.toml"), &overrides).unwrap();
        document.listing().into_iter().map(|(key, value)| format!("{key} = {value}")).collect()
    }

    #[test]
    fn what_says_the_same_is_listed_alike() {
        let one = lines("[a]\nb = 1.0\nc = \"\"\"x\ny\"\"\"\n[[d]]\ne = [1, [2.5]]\n[[d]]\nf = true\n", &[]);
        assert_eq!(one, ["a.b = 1", "a.c = \"x\\ny\"", "d.0.e = [1, [2.5]]", "d.1.f = true"]);
        let other = "d = [{ e = [0, 0] }, { f = true }]\na = { c = \"x\\ny\", b = 7 }\n";
        assert_eq!(lines(other, &["d.0.e=[1.0, [2.5]]", "a.b=1"]), one);
        assert_eq!(lines("a = []\nb = [{ c = 1, d = {} }, 2]\n", &[]), ["a = []", "b = [{ c = 1, d = {  } }, 2]"]);
    }
}
