//! `[materials.NAME]` and `[sky]`: what surfaces and the distance look like.

use super::files::Files;
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{array, color, extents_2d, not_negative, number_where, positive, word};
use crate::scene::document::{Node, Value};
use crate::scene::{Material, MaterialKind, Pattern, Sky};
use glam::{DVec2, DVec3};

#[derive(Clone, Copy)]
enum Kind {
    Phong,
    Emissive,
    Mirror,
}

/// The names of all materials, and those that can be used, both in the order of the file.
pub fn read<'a>(root: &TableReader<'_, 'a>, files: &mut Files) -> (Vec<&'a str>, Vec<Material>) {
    let Some(table) = root.subtable("materials", "materials") else {
        return (Vec::new(), Vec::new());
    };
    let names = table.entries().map(|(name, _)| name).collect();
    let materials = table.entries().filter_map(|(name, node)| {
        let table = table.reader.open("materials.NAME", node)?;
        material(name, table, files)
    });
    (names, materials.collect())
}

fn material(name: &str, table: TableReader, files: &mut Files) -> Option<Material> {
    let kinds = word(&[("phong", Kind::Phong), ("emissive", Kind::Emissive), ("mirror", Kind::Mirror)], &[]);
    let kind = table.decide("kind", Kind::Phong, kinds);
    let named = |color, kind| Material { name: name.to_owned(), color, kind };
    let material = match kind {
        Some(Kind::Phong) => {
            let fraction = number_where("a number from 0 to 1", |x| (0.0..=1.0).contains(&x));
            let kind = MaterialKind::Phong {
                ambient: table.or("ambient", 0.1, fraction),
                specular: table.or("specular", DVec3::ZERO, color),
                shininess: table.or("shininess", 32.0, positive),
                emission: table.or("emission", DVec3::ZERO, color),
            };
            let diffuse = match table.node("diffuse") {
                Some(node) => pattern(&table, "materials.NAME.diffuse", node, files),
                None => Some(Pattern::Constant(DVec3::splat(0.8))),
            };
            diffuse.map(|color| named(color, kind))
        }
        Some(Kind::Emissive) => table
            .required_node("color", "[1, 1, 1]")
            .and_then(|node| pattern(&table, "materials.NAME.color", node, files))
            .map(|color| named(color, MaterialKind::Emissive)),
        Some(Kind::Mirror) => {
            let color = match table.node("color") {
                Some(node) => pattern(&table, "materials.NAME.color", node, files),
                None => Some(Pattern::Constant(DVec3::ONE)),
            };
            color.map(|color| named(color, MaterialKind::Mirror))
        }
        None => None,
    };
    table.finish();
    material
}

/// A colour, or a table that says how it varies; `path` is the table's name in the reference.
fn pattern(table: &TableReader, path: &'static str, node: &Node, files: &mut Files) -> Option<Pattern> {
    const CHOICES: &str = "[red, green, blue], { checker = [[..], [..]] } or { image = \"file\" }";
    let reader = table.reader;
    match node.value {
        Value::Array(_) => return reader.accept(color(node).map(Pattern::Constant)),
        Value::Table(_) => {}
        _ => {
            reader.fault(node.expected(CHOICES));
            return None;
        }
    }
    let table = reader.open(path, node)?;
    let pattern = match table.required_one_of(&["checker", "image"], CHOICES) {
        Some(("checker", node)) => {
            let repeat = table.or("repeat", DVec2::splat(8.0), extents_2d);
            let colors = reader.accept(array("two colours", color)(node));
            colors.map(|colors| Pattern::Checker { colors, repeat })
        }
        Some((_, node)) => {
            let repeat = table.or("repeat", DVec2::ONE, extents_2d);
            let picture = files.picture(reader, node);
            picture.map(|picture| Pattern::Picture { picture, repeat })
        }
        None => None,
    };
    table.finish();
    pattern
}

/// Black unless the scene says otherwise.
pub fn sky(root: &TableReader, files: &mut Files) -> Sky {
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
