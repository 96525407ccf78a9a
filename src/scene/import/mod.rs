//! The import of glTF files: nodes become objects, and materials, cameras and lights their closest equivalents.
//!
//! *Theory.* Metallic and rough surfaces become mirrors, lobes around the mirror direction, or matte surfaces with a highlight. An
//! intensity in candela or lux, divided by π, is the radiance of a white surface that faces the light.
//!
//! *Practice.* The scene references the file, and selects nodes and primitives in it: triangles are not copied, and a mesh that several
//! nodes reference is read once. [`Imported::left_out`] lists each kind of unsupported feature once.

mod lights;
mod surfaces;
mod text;
mod views;

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::Path;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::SceneError;
use crate::assets::json::mesh::{Mode, Semantic};
use crate::assets::json::validation::Checked::Valid;
use crate::assets::json::{Root, mesh::Primitive};
use crate::assets::{Gltf, MeshPart, MeshRequest, MeshSource, NodeName, Placed, names};
use crate::model::shape::{Shape, Triangles, round_up};
use surfaces::Surfaces;
use text::{Left, number, quoted, relative, vector};

/// A scene converted from a file.
#[derive(Debug)]
pub struct Imported {
    /// The text of the scene file.
    pub text: String,
    /// The names and bytes of embedded images, to be written next to the scene.
    pub pictures: Vec<(String, Vec<u8>)>,
    /// The features that were skipped or added.
    pub left_out: Vec<String>,
}

/// The bounding box of visible geometry and cameras.
struct Extent {
    lo: DVec3,
    hi: DVec3,
}

impl Extent {
    fn center(&self) -> DVec3 {
        0.5 * (self.lo + self.hi)
    }

    fn radius(&self) -> f64 {
        (0.5 * (self.hi - self.lo).length()).max(1e-3)
    }
}

/// Converts a file to a scene; `scene` is the path where it will be written.
///
/// # Errors
///
/// Returns an error if the data of the file are invalid, or its scene has no triangles.
pub fn import(file: &Gltf, scene: &Path) -> Result<Imported, SceneError> {
    let folder = scene.parent().unwrap_or(Path::new(""));
    let stem = scene.file_stem().map_or_else(|| "scene".into(), |stem| stem.to_string_lossy());
    let mut left = Left::default();
    let nodes = file.nodes()?;
    of_the_file(&file.root, &mut left);
    let mut surfaces = Surfaces::new(file, folder, &stem);
    let (objects, extent) = objects(file, &nodes, &relative(file.path(), folder), &mut surfaces, &mut left)?;
    let Some(extent) = extent else {
        let problem = "the scene of the file has no triangles".to_owned();
        return Err(SceneError::Mesh { path: file.path().to_owned(), problem });
    };
    let (camera, eyes) = views::cameras(file, &nodes, &extent, &mut left);
    let (lights, emitters) = lights::lights(file, &nodes, &extent, eyes[0], surfaces.shines(), &mut left);
    let center = extent.center();
    let reach = eyes.iter().chain(&emitters).map(|place| place.distance(center)).fold(extent.radius(), f64::max);
    let bound = format!(
        "[rays]\nbounding_sphere = {{ center = {}, radius = {} }}\n",
        vector(center),
        number(round_up(1.05 * reach))
    );
    let head = format!("# From {}, by `bentray import`.\n", relative(file.path(), folder));
    let (materials, pictures) = surfaces.finish();
    let tables = [&head, &camera, &bound, &materials, &objects, &lights].map(|table| table.trim_end());
    let text = tables.join("\n\n").trim_end().to_owned() + "\n";
    Ok(Imported { text, pictures, left_out: left.said() })
}

/// Records features of the file that do not belong to nodes.
fn of_the_file(root: &Root, left: &mut Left) {
    const READ: [&str; 7] = [
        "KHR_lights_punctual",
        "KHR_materials_emissive_strength",
        "KHR_materials_unlit",
        "KHR_materials_transmission",
        "KHR_materials_ior",
        "KHR_materials_volume",
        "KHR_mesh_quantization",
    ];
    if !root.animations.is_empty() {
        left.out("animations", "");
    }
    if root.scenes.len() > 1 {
        left.out("scenes other than the default scene", "");
    }
    for name in root.extensions_used.iter().filter(|name| !READ.contains(&name.as_str()) && !name.contains("_texture_"))
    {
        left.out(&format!("the extension {name}"), "");
    }
}

/// Returns the objects and their extent; fails if there are none.
fn objects(
    file: &Gltf,
    nodes: &[Placed],
    name: &str,
    surfaces: &mut Surfaces,
    left: &mut Left,
) -> Result<(String, Option<Extent>), SceneError> {
    let mut text = String::new();
    let mut extent: Option<Extent> = None;
    let mut read: HashMap<MeshSource, Triangles> = HashMap::new();
    for (placed, node) in nodes.iter().zip(names(nodes)) {
        let Some(mesh) = placed.node.mesh.and_then(|index| file.root.get(index)) else { continue };
        let called = match &node {
            NodeName::Name(name) => name.clone(),
            NodeName::Number(number) => placed.node.name.clone().unwrap_or_else(|| format!("node {number}")),
        };
        if placed.node.skin.is_some() {
            left.out("skins; meshes keep their original shape", &called);
        }
        for (i, primitive) in mesh.primitives.iter().enumerate() {
            if !is_drawn(primitive) {
                left.out("points and lines", &called);
                continue;
            }
            of_the_primitive(primitive, &called, left);
            let chosen = (mesh.primitives.len() > 1).then_some(i as u32);
            let part = MeshPart { node: Some(node.clone()), primitive: chosen };
            let (source, place) = file.find(&part)?;
            let triangles = match read.entry(source) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(free) => {
                    let mesh = file.read(free.key(), MeshRequest::CREASE)?;
                    free.insert(Triangles(Arc::new(mesh)))
                }
            };
            let (lo, hi) = triangles.bounds(place * DAffine3::from_translation(triangles.0.origin));
            let extent = extent.get_or_insert(Extent { lo, hi });
            (extent.lo, extent.hi) = (extent.lo.min(lo), extent.hi.max(hi));
            let key = match &node {
                NodeName::Name(name) => quoted(name),
                NodeName::Number(number) => number.to_string(),
            };
            let primitive_key = chosen.map(|chosen| format!("primitive = {chosen}\n")).unwrap_or_default();
            let is_closed = || triangles.refuses_interior().is_none();
            let material = primitive.material.map(|index| index.value());
            let has_vertex_colors = triangles.0.lacks_colors().is_none();
            if !has_vertex_colors && primitive.attributes.contains_key(&Valid(Semantic::Colors(0))) {
                left.out("vertex colors that cannot be used", &called);
            }
            let substance = surfaces.substance(material, has_vertex_colors, is_closed, left);
            text.extend([format!(
                "[[objects]]\nshape = \"mesh\"\nfile = {}\nnode = {key}\n{primitive_key}{substance}\n\n",
                quoted(name)
            )]);
        }
    }
    Ok((text, extent))
}

fn is_drawn(primitive: &Primitive) -> bool {
    matches!(primitive.mode, Valid(Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan))
}

fn of_the_primitive(primitive: &Primitive, called: &str, left: &mut Left) {
    if primitive.targets.as_ref().is_some_and(|targets| !targets.is_empty()) {
        left.out("morph targets", called);
    }
}
