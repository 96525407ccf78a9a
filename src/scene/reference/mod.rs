//! The reference of the scene format: every key with its meaning, and templates.
//!
//! One list serves the manual and the help of error messages, which report where a misplaced key is valid. A test reads scenes of every
//! kind and compares the keys that the readers request with this list.

mod keys;
mod templates;

pub use templates::{TEMPLATES, Template};

use std::sync::LazyLock;

use crate::document::KeyReference;
use crate::model::{absorption, camera, falloff, law, material, medium, method, point_source, shape, volume};

/// Every key by table; a test compares the list with the keys that the readers request.
pub static REFERENCE: LazyLock<Vec<KeyReference>> = LazyLock::new(|| {
    let kinds = [
        law::KINDS.reference(),
        point_source::reference(),
        falloff::reference(),
        medium::KINDS.reference(),
        absorption::reference(),
        camera::KINDS.reference(),
        method::reference(),
        material::KINDS.reference(),
        shape::KINDS.reference(),
        volume::reference(),
    ]
    .concat();
    let mut all = keys::fixed();
    add_copy(&mut all, "sky", "sky.other_side");
    add_copy(&mut all, "materials.NAME.diffuse", "materials.NAME.color");
    for table in kinds.chunk_by(|a, b| a.table == b.table) {
        // The kinds of a table follow its rows, or the rows of the table before it.
        let after = |row: &KeyReference| row.table == table[0].table || AFTER.contains(&(table[0].table, row.table));
        let at = all.iter().rposition(after).map_or(all.len(), |last| last + 1);
        let own = all.iter().position(|row| row.table == table[0].table);
        all.splice(own.unwrap_or(at)..own.unwrap_or(at), table.iter().cloned());
    }
    all
});

/// Adds the keys of a table with the format of another table, after that table.
fn add_copy(all: &mut Vec<KeyReference>, original: &'static str, copy: &'static str) {
    let own = all.iter().filter(|row| row.table == original && row.key != "other_side");
    let other: Vec<_> = own.map(|row| KeyReference { table: copy, ..row.clone() }).collect();
    let at = all.iter().rposition(|row| row.table == original).map_or(all.len(), |last| last + 1);
    all.splice(at..at, other);
}

/// The tables that are read by their kinds alone, each with the table that it follows.
const AFTER: [(&str, &str); 6] = [
    ("volumes", "objects"),
    ("law", "camera.stereo"),
    ("law.sources.falloff", "law.sources"),
    ("medium", "law.sources.falloff"),
    ("absorption", "medium"),
    ("materials.NAME", "output"),
];

/// Returns the reference as Markdown, with one section per table.
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
    let when = match key.when.as_str() {
        "" => String::new(),
        when => format!("With {when}: "),
    };
    let cells = [&*key.value, key.default, &format!("{when}{}", key.meaning)];
    let [value, default, meaning] = cells.map(|cell| cell.replace('|', "\\|"));
    format!("| `{}` | {value} | {default} | {meaning} |", key.key)
}

fn heading(table: &str) -> String {
    match table {
        "" => "### Top level".to_owned(),
        "objects" | "volumes" | "lights" | "law.sources" | "animation.tracks" => format!("### `[[{table}]]`"),
        _ => format!("### `[{table}]`"),
    }
}
