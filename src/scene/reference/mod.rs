//! The format as the user reads it: every key with its meaning, and a scene to begin with.
//!
//! One list serves the manual, and the help of mistakes: a key that stands in the wrong company is told what it goes
//! with. A test reads scenes of every kind and compares the keys that were asked for with this list.

mod keys;
mod templates;

pub use templates::{TEMPLATES, Template};

use std::sync::LazyLock;

use crate::document::KeyReference;
use crate::model::{camera, falloff, filter, law, material, medium, method, shape, source};

/// Every key, table by table: a test holds it to what the reading of scenes asks for.
pub static REFERENCE: LazyLock<Vec<KeyReference>> = LazyLock::new(|| {
    let kinds = [
        law::KINDS.reference(),
        source::reference(),
        falloff::reference(),
        medium::KINDS.reference(),
        filter::reference(),
        camera::KINDS.reference(),
        method::reference(),
        material::KINDS.reference(),
        shape::KINDS.reference(),
    ]
    .concat();
    let mut all = keys::fixed();
    add_copy(&mut all, "sky", "sky.other_side");
    add_copy(&mut all, "materials.NAME.diffuse", "materials.NAME.color");
    for table in kinds.chunk_by(|a, b| a.table == b.table) {
        // The kinds of a table stand where the table does, or behind the table before it.
        let after = |row: &KeyReference| row.table == table[0].table || AFTER.contains(&(table[0].table, row.table));
        let at = all.iter().rposition(after).map_or(all.len(), |last| last + 1);
        let own = all.iter().position(|row| row.table == table[0].table);
        all.splice(own.unwrap_or(at)..own.unwrap_or(at), table.iter().cloned());
    }
    all
});

/// Adds the keys of a table that is read as another is, behind that.
fn add_copy(all: &mut Vec<KeyReference>, original: &'static str, copy: &'static str) {
    let own = all.iter().filter(|row| row.table == original && row.key != "other_side");
    let other: Vec<_> = own.map(|row| KeyReference { table: copy, ..row.clone() }).collect();
    let at = all.iter().rposition(|row| row.table == original).map_or(all.len(), |last| last + 1);
    all.splice(at..at, other);
}

/// Tables that are read by their kinds alone, each with the one that it stands behind.
const AFTER: [(&str, &str); 5] = [
    ("law", "camera.stereo"),
    ("law.sources.falloff", "law.sources"),
    ("medium", "law.sources.falloff"),
    ("absorption", "medium"),
    ("materials.NAME", "output"),
];

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
        "objects" | "lights" | "law.sources" | "animation.tracks" => format!("### `[[{table}]]`"),
        _ => format!("### `[{table}]`"),
    }
}
