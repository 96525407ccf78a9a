//! Colors over the (u, v) coordinates of a surface.

use glam::{DVec2, DVec3, Vec3};

use crate::assets::{Files, Picture};
use crate::document::reader::TableReader;
use crate::document::values::{array, boolean, color, extents_2d};
use crate::document::{Node, Value};
use crate::model::{Row, row};

/// A color over a surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// One color everywhere.
    Constant(DVec3),
    /// A checkerboard of two colors.
    Checker {
        /// The two colors.
        colors: [DVec3; 2],
        /// The number of cells along u and v.
        repeat: DVec2,
    },
    /// An image texture.
    Picture {
        /// The index into [`Scene::pictures`](crate::scene::Scene::pictures).
        picture: usize,
        /// The number of repetitions along u and v.
        repeat: DVec2,
    },
    /// Another pattern multiplied by vertex colors; only for meshes that have vertex colors.
    VertexColors(Box<Self>),
}

impl Pattern {
    /// The names of the patterns in `shaders/surface/pattern.wgsl`.
    pub const PARTS: [&'static str; 3] = ["constant", "checker", "image"];

    /// Returns `true` if the pattern varies, so that it must be averaged over a pixel footprint.
    #[must_use]
    pub fn is_averaged(&self) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::Checker { .. } | Self::Picture { .. } => true,
            Self::VertexColors(pattern) => pattern.is_averaged(),
        }
    }

    /// Returns `true` if all colors have equal channel ratios.
    #[must_use]
    pub fn is_gray(&self) -> bool {
        let gray = |color: &DVec3| *color == DVec3::splat(color.x);
        match self {
            Self::Constant(color) => gray(color),
            Self::Checker { colors, .. } => colors.iter().all(gray),
            Self::Picture { .. } | Self::VertexColors(_) => false,
        }
    }

    /// Returns `true` if the pattern is multiplied by vertex colors.
    #[must_use]
    pub fn has_vertex_colors(&self) -> bool {
        matches!(self, Self::VertexColors(_))
    }

    /// Returns the mean over the surface, with white vertex colors; `pictures` are the scene's images.
    #[must_use]
    pub fn mean(&self, pictures: &[Picture]) -> DVec3 {
        match self {
            Self::Constant(color) => *color,
            Self::Checker { colors: [first, second], .. } => 0.5 * (*first + *second),
            Self::Picture { picture, .. } => {
                let pixels = pictures.get(*picture).map_or(&[][..], |picture| &picture.pixels);
                let sum: DVec3 = pixels.iter().map(|pixel| Vec3::from(*pixel).as_dvec3()).sum();
                sum / pixels.len().max(1) as f64
            }
            Self::VertexColors(pattern) => pattern.mean(pictures),
        }
    }

    /// Returns the maximum of each channel.
    #[must_use]
    pub fn largest(&self, pictures: &[Picture]) -> DVec3 {
        match self {
            Self::Constant(color) => *color,
            Self::Checker { colors: [first, second], .. } => first.max(*second),
            Self::Picture { picture, .. } => {
                let pixels = pictures.get(*picture).map_or(&[][..], |picture| &picture.pixels);
                pixels.iter().fold(DVec3::ZERO, |most, pixel| most.max(Vec3::from(*pixel).as_dvec3()))
            }
            // Vertex colors are at most 1.
            Self::VertexColors(pattern) => pattern.largest(pictures),
        }
    }

    /// Returns the name of the pattern in WGSL, without vertex colors.
    #[must_use]
    pub fn part(&self) -> &'static str {
        Self::PARTS[match self {
            Self::Constant(_) => 0,
            Self::Checker { .. } => 1,
            Self::Picture { .. } => 2,
            Self::VertexColors(pattern) => return pattern.part(),
        }]
    }

    /// Returns the members of `Material` that only this pattern has.
    #[must_use]
    pub fn values(&self) -> Row {
        match self {
            Self::Constant(color) => row! { color: Vec3(*color) },
            Self::Checker { colors: [first, second], repeat } => {
                row! { color: Vec3(*first), second_color: Vec3(*second), repeat: Vec2(*repeat) }
            }
            Self::Picture { picture, repeat } => row! { image: Uint(*picture as u32), repeat: Vec2(*repeat) },
            Self::VertexColors(pattern) => pattern.values(),
        }
    }
}

/// Reads the pattern of a key; returns `default` if the key is missing.
pub(super) fn read(
    table: &TableReader,
    key: &'static str,
    default: Option<DVec3>,
    files: &mut Files,
) -> Option<Pattern> {
    match (table.node(key), default) {
        (Some(node), _) => {
            let path = if key == "color" { "materials.NAME.color" } else { "materials.NAME.diffuse" };
            given(table, path, node, files)
        }
        (None, Some(color)) => Some(Pattern::Constant(color)),
        (None, None) => {
            table.required_node(key, "[1, 1, 1]");
            None
        }
    }
}

/// Reads a color, or a table that varies it over the surface; `path` is the table's name in the reference.
fn given(table: &TableReader, path: &'static str, node: &Node, files: &mut Files) -> Option<Pattern> {
    const CHOICES: &str =
        "[red, green, blue], { checker = [[..], [..]] }, { image = \"file\" } or { vertex_colors = true }";
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
    // After an invalid value, no second error follows from the missing one.
    let has_vertex_colors = table.optional("vertex_colors", boolean).unwrap_or(table.gives("vertex_colors"));
    let kinds = ["color", "checker", "image"];
    let kind = if has_vertex_colors { table.one_of(&kinds) } else { table.required_one_of(&kinds, CHOICES) };
    let pattern = match kind {
        Some(("color", node)) => reader.accept(color(node).map(Pattern::Constant)),
        Some(("checker", node)) => {
            let repeat = table.or("repeat", DVec2::splat(8.0), extents_2d);
            let colors = reader.accept(array("two colors", color)(node));
            colors.map(|colors| Pattern::Checker { colors, repeat })
        }
        Some((_, node)) => {
            let repeat = table.or("repeat", DVec2::ONE, extents_2d);
            files.picture(reader, node).map(|picture| Pattern::Picture { picture, repeat })
        }
        None => has_vertex_colors.then_some(Pattern::Constant(DVec3::ONE)),
    };
    table.finish();
    if has_vertex_colors { pattern.map(|pattern| Pattern::VertexColors(Box::new(pattern))) } else { pattern }
}
