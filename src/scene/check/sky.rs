//! `[sky]`: what the distance looks like.

use glam::DVec3;

use crate::assets::Files;
use crate::document::reader::TableReader;
use crate::document::values::{color, not_negative};
use crate::document::{Node, Value};
use crate::scene::Sky;

/// Black unless the scene says otherwise.
pub fn read(root: &TableReader, files: &mut Files) -> Sky {
    let black = Sky::Color(DVec3::ZERO);
    let Some(table) = root.subtable("sky", "sky") else {
        return black;
    };
    let reader = table.reader;
    let sky = match table.one_of(&["color", "image", "faces"]) {
        Some(("color", node)) => reader.accept(color(node).map(Sky::Color)),
        Some((key, node)) => {
            let intensity = table.or("intensity", 1.0, not_negative);
            if key == "image" {
                let picture = files.picture(reader, node);
                picture.map(|picture| Sky::Equirectangular(picture, intensity))
            } else {
                faces(&table, node, files).map(|faces| Sky::Faces(faces, intensity))
            }
        }
        None => None,
    };
    table.finish();
    sky.unwrap_or(black)
}

fn faces(table: &TableReader, node: &Node, files: &mut Files) -> Option<[usize; 6]> {
    let reader = table.reader;
    let names: [&Node; 6] = match &node.value {
        Value::Array(items) => items.iter().collect::<Vec<_>>().try_into().ok(),
        _ => None,
    }
    .or_else(|| {
        reader.fault(node.expected("six files, [+x, -x, +y, -y, +z, -z]"));
        None
    })?;
    // All are loaded before any is missed.
    let pictures = names.map(|name| files.picture(reader, name));
    let found: Vec<usize> = pictures.into_iter().flatten().collect();
    found.try_into().ok()
}
