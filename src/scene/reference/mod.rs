//! The format as the user reads it: every key with its meaning, and a scene to begin with.
//!
//! One list serves the manual, and the help of mistakes: a key that stands in the wrong company is told what it goes
//! with. A test reads scenes of every kind and compares the keys that were asked for with this list.

mod keys;

pub use keys::REFERENCE;

/// The scene that `bentray new` writes: a black hole before a chequered sphere, every line with a comment.
pub const TEMPLATE: &str = include_str!("template.toml");

/// What there is to know of a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KeyReference {
    /// The table it stands in, such as `rays.bound`; empty for the top level, NAME for a name of the user's.
    pub table: &'static str,
    /// The key.
    pub key: &'static str,
    /// What it goes with; empty if it always may stand.
    pub when: &'static str,
    /// What values it takes; words stand in quotes in the file.
    pub value: &'static str,
    /// What holds without it, or `required`.
    pub default: &'static str,
    /// What it means, with its unit.
    pub meaning: &'static str,
}

/// The reference as Markdown, a section for each table.
#[must_use]
pub fn reference_markdown() -> String {
    let sections = REFERENCE.chunk_by(|a, b| a.table == b.table);
    let sections = sections.map(|keys| {
        let rows = keys.iter().map(row);
        let rows = rows.collect::<Vec<String>>().join("\n");
        format!("{}\n\n{HEAD}\n{rows}\n", heading(keys[0].table))
    });
    sections.collect::<Vec<String>>().join("\n")
}

const HEAD: &str = "| key | value | default | meaning |\n|---|---|---|---|";

fn row(key: &KeyReference) -> String {
    let when = match key.when {
        "" => String::new(),
        when => format!("With {when}: "),
    };
    let cells = [key.value, key.default, &format!("{when}{}", key.meaning)];
    let [value, default, meaning] = cells.map(|cell| cell.replace('|', "\\|"));
    format!("| `{}` | {value} | {default} | {meaning} |", key.key)
}

fn heading(table: &str) -> String {
    match table {
        "" => "### Top level".to_owned(),
        "objects" | "lights" | "law.sources" | "animation.tracks" => format!("### `[[{table}]]`"),
        _ => format!("### `[{table}]`"),
    }
}
