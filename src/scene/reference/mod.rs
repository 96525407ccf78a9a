//! The format as the user reads it: every key with its meaning, and a scene to begin with.
//!
//! One list serves the manual, and the help of mistakes: a key that stands in the wrong company is told what it goes
//! with. A test reads scenes of every kind and compares the keys that were asked for with this list.

mod keys;

use std::sync::LazyLock;

use crate::document::KeyReference;
use crate::model::{camera, falloff, law, material, medium, method, shape, source};

/// The scene that `bentray new` writes: a black hole before a chequered sphere, every line with a comment.
pub const TEMPLATE: &str = include_str!("template.toml");

/// Every key, table by table: a test holds it to what the reading of scenes asks for.
pub static REFERENCE: LazyLock<Vec<KeyReference>> = LazyLock::new(|| {
    let kinds = [kinds_of_laws(), kinds_of_scenes()].concat();
    let mut all = keys::fixed();
    for table in kinds.chunk_by(|a, b| a.table == b.table) {
        // The kinds of a table stand where the table does, or behind the table before it.
        let after = |row: &KeyReference| row.table == table[0].table || AFTER.contains(&(table[0].table, row.table));
        let at = all.iter().rposition(after).map_or(all.len(), |last| last + 1);
        let own = all.iter().position(|row| row.table == table[0].table);
        all.splice(own.unwrap_or(at)..own.unwrap_or(at), table.iter().cloned());
    }
    all
});

/// Tables that are read by their kinds alone, each with the one that it stands behind.
const AFTER: [(&str, &str); 4] = [
    ("law", "camera.stereo"),
    ("law.sources.falloff", "law.sources"),
    ("medium", "law.sources.falloff"),
    ("materials.NAME", "output"),
];

fn kinds_of_laws() -> Vec<KeyReference> {
    let law = "how light travels: straight, round a black hole, by sources of force, along a flow, or in a medium";
    let source = "what the source is centred on";
    let medium = "how n varies: a number stands for { kind = \"constant\", n }, and so do the names of common media: \
                  vacuum, air, ice, water, ethyl-alcohol, fused-quartz, acrylic, crown-glass, polyester-resin, \
                  flint-glass and diamond";
    let sources: Vec<&str> = source::SOURCES.map(|kind| kind.name).to_vec();
    [
        chooser("law", "kind", &law::names(), Some(law::names()[0]), law),
        law::reference(),
        chooser("law.sources", "kind", &sources, Some(sources[0]), source),
        source::reference(),
        falloff::reference(),
        chooser("medium", "kind", &medium::names(), None, medium),
        medium::reference(),
    ]
    .concat()
}

fn kinds_of_scenes() -> Vec<KeyReference> {
    let camera = "how a point of the picture becomes a ray: as through a window, parallel, by the angle from the middle, \
                  or by longitude and latitude";
    let method = "the integrator; auto measures which is fastest at the accuracy. Left out, it is exact where no light is \
                  bent, what suits the steps or the tolerance that are given, else auto";
    let methods = method::names();
    let names: Vec<&str> = std::iter::once("auto").chain(methods.iter().map(|(name, _)| name.as_str())).collect();
    [
        chooser("camera", "kind", &camera::names(), Some(camera::names()[0]), camera),
        camera::reference(),
        chooser("rays", "method", &names, Some("see there"), method),
        method::reference(),
        chooser("materials.NAME", "kind", &material::names(), Some(material::names()[0]), "how it answers light"),
        material::reference(),
        chooser("objects", "shape", &shape::names(), None, "what it is"),
        shape::reference(),
    ]
    .concat()
}

/// The row of the key that chooses a kind.
fn chooser(
    table: &'static str,
    key: &'static str,
    names: &[&str],
    default: Option<&'static str>,
    meaning: &'static str,
) -> Vec<KeyReference> {
    let (value, default) = (names.join(" | "), default.unwrap_or("required"));
    vec![KeyReference { table, key, when: String::new(), value, default, meaning }]
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
