//! The reader of `[sky]`, the background; `sky = "transparent"` means no background.

use glam::{DMat3, DVec3};

use super::stars;
use crate::assets::{Files, Transform};
use crate::document::reader::TableReader;
use crate::document::values::{angles, color, not_negative, word};
use crate::document::{Node, Value};
use crate::model::Law;
use crate::scene::{Sky, Stars};

/// Reads the sky, which defaults to black, and the sky of the other side, if it has a separate one.
pub fn read(root: &TableReader, files: &mut Files, law: Option<&dyn Law>, paths: bool) -> Skies {
    let Some(node) = root.node("sky") else { return Skies::default() };
    if let Value::Text(_) = node.value {
        let sky = root.reader.accept(word(&[("transparent", ())])(node));
        return Skies { near: if sky.is_some() { Sky::Transparent } else { BLACK }, ..Skies::default() };
    }
    let Some(table) = root.reader.open("sky", node) else { return Skies::default() };
    let (near, stars) = one(&table, files);
    let beyond = table.subtable("other_side", "sky.other_side").map(|beyond| {
        if law.is_some_and(|law| law.facts().throat.is_none()) {
            let problem = "`other_side` requires a wormhole";
            table.fault(&["other_side"], problem, "remove it, or use law.kind = \"wormhole\" or law.throat");
        }
        if paths {
            let problem = "path tracing uses one sky for both sides";
            table.fault(&["other_side"], problem, "remove it, or use lighting = \"direct\"");
        }
        let sky = one(&beyond, files);
        beyond.finish();
        sky
    });
    table.finish();
    // Without a sky of its own the other side has the same stars.
    let (beyond, stars_beyond) = beyond.map_or((None, stars.clone()), |(sky, stars)| (Some(sky), stars));
    Skies { near, beyond, stars: [stars, stars_beyond] }
}

/// The skies of a scene.
pub struct Skies {
    pub near: Sky,
    /// The sky of the other side, if it has a separate one.
    pub beyond: Option<Sky>,
    /// The stars of both sides.
    pub stars: [Option<Stars>; 2],
}

impl Default for Skies {
    fn default() -> Self {
        Self { near: BLACK, beyond: None, stars: [None, None] }
    }
}

const BLACK: Sky = Sky::Color(DVec3::ZERO);

/// Reads a sky and its stars, which one rotation turns.
fn one(table: &TableReader, files: &mut Files) -> (Sky, Option<Stars>) {
    let rotate = table.or("rotate", DVec3::ZERO, angles);
    let rotation = Transform::new(DVec3::ONE, rotate, DVec3::ZERO).0.matrix3;
    (background(table, rotation, files), stars::read(table, rotation, files))
}

fn background(table: &TableReader, rotation: DMat3, files: &mut Files) -> Sky {
    let reader = table.reader;
    let sky = match table.one_of(&["color", "image", "faces"]) {
        Some(("color", node)) => reader.accept(color(node).map(Sky::Color)),
        Some((key, node)) => {
            let intensity = table.or("intensity", 1.0, not_negative);
            if key == "image" {
                let picture = files.picture(reader, node);
                picture.map(|picture| Sky::Equirectangular(picture, intensity, rotation))
            } else {
                faces(table, node, files).map(|faces| Sky::Faces(faces, intensity, rotation))
            }
        }
        None => None,
    };
    sky.unwrap_or(BLACK)
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
    // All images are loaded before the first error returns, so that every error is reported.
    let pictures = names.map(|name| files.picture(reader, name));
    let found: Vec<usize> = pictures.into_iter().flatten().collect();
    found.try_into().ok()
}
