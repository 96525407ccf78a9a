//! A colour over a surface's (u, v).

use glam::{DVec2, DVec3, Vec3};

use crate::assets::{Files, Picture};
use crate::document::reader::TableReader;
use crate::document::values::{array, boolean, color, extents_2d};
use crate::document::{Node, Value};
use crate::model::{Row, row};

/// A colour over a surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// The same everywhere.
    Constant(DVec3),
    /// Two colours in turn.
    Checker {
        /// The two colours.
        colors: [DVec3; 2],
        /// Cells along u and v.
        repeat: DVec2,
    },
    /// A picture: index into [`Scene::pictures`](crate::scene::Scene::pictures).
    Picture {
        /// Which.
        picture: usize,
        /// How often it repeats along u and v.
        repeat: DVec2,
    },
    /// Another pattern, multiplied by vertex colors. Objects with it are meshes that have some.
    VertexColors(Box<Self>),
}

impl Pattern {
    /// Their names in `shaders/surface/pattern.wgsl`.
    pub const PARTS: [&'static str; 3] = ["constant", "checker", "image"];

    /// Returns `true` if it varies in a way that pixels average over what they see of it.
    #[must_use]
    pub fn is_averaged(&self) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::Checker { .. } | Self::Picture { .. } => true,
            Self::VertexColors(pattern) => pattern.is_averaged(),
        }
    }

    /// Does it give all colours the same part?
    #[must_use]
    pub fn is_gray(&self) -> bool {
        let gray = |color: &DVec3| *color == DVec3::splat(color.x);
        match self {
            Self::Constant(color) => gray(color),
            Self::Checker { colors, .. } => colors.iter().all(gray),
            Self::Picture { .. } | Self::VertexColors(_) => false,
        }
    }

    /// Returns `true` if it is multiplied by vertex colors.
    #[must_use]
    pub fn has_vertex_colors(&self) -> bool {
        matches!(self, Self::VertexColors(_))
    }

    /// Its mean over the surface, where vertex colors are white; `pictures` are the scene's.
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

    /// Each channel's largest value.
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

    /// Returns its name in WGSL, without vertex colors.
    #[must_use]
    pub fn part(&self) -> &'static str {
        Self::PARTS[match self {
            Self::Constant(_) => 0,
            Self::Checker { .. } => 1,
            Self::Picture { .. } => 2,
            Self::VertexColors(pattern) => return pattern.part(),
        }]
    }

    /// The members of `Material` that are its own.
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

/// The pattern of a key, or `default` without it.
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

/// A colour, or a table that says how it varies; `path` is the table's name in the reference.
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
    // A value that is wrong is one mistake, and no second one is made of it.
    let has_vertex_colors = table.optional("vertex_colors", boolean).unwrap_or(table.gives("vertex_colors"));
    let kinds = ["color", "checker", "image"];
    let kind = if has_vertex_colors { table.one_of(&kinds) } else { table.required_one_of(&kinds, CHOICES) };
    let pattern = match kind {
        Some(("color", node)) => reader.accept(color(node).map(Pattern::Constant)),
        Some(("checker", node)) => {
            let repeat = table.or("repeat", DVec2::splat(8.0), extents_2d);
            let colors = reader.accept(array("two colours", color)(node));
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
