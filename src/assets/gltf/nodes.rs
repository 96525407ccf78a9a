//! The placement of nodes: the trees of the scene that a file shows.

use std::collections::HashMap;

use glam::{DAffine3, DMat4, DQuat, DVec3};
use gltf_json::{Index, Node};
use serde::Deserialize;

use super::Gltf;
use crate::assets::format_error::FormatError;
use crate::document::SceneError;
use crate::document::values::suggest;

/// The identification of a node.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum NodeName {
    /// The node's name.
    Name(String),
    /// The node's index in the file, from 0.
    Number(u32),
}

/// A node of the scene.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a> {
    /// The index in the file.
    pub number: u32,
    /// The node.
    pub node: &'a Node,
    /// The map from the node's space to the scene.
    pub world: DAffine3,
}

impl Gltf {
    /// Returns the nodes of the file's default scene, in the order of the trees, each once.
    ///
    /// # Errors
    ///
    /// Returns an error if an index is invalid, the nodes do not form trees, or the position of a node is not finite.
    pub fn nodes(&self) -> Result<Vec<Placed<'_>>, SceneError> {
        self.placed().map_err(|flaw| flaw.of(&self.path))
    }

    fn placed(&self) -> Result<Vec<Placed<'_>>, FormatError> {
        let scene = match self.root.scene {
            Some(scene) => Some(self.get(scene, "scenes", "scene")?),
            None => self.root.scenes.first(),
        };
        let roots = scene.map_or_else(|| self.parentless(), |scene| scene.nodes.clone());
        let mut waiting: Vec<_> = roots.into_iter().rev().map(|node| (node, DAffine3::IDENTITY)).collect();
        let mut met = vec![false; self.root.nodes.len()];
        let mut placed = Vec::new();
        while let Some((index, parent)) = waiting.pop() {
            let node = self.get(index, "nodes", "a scene or node")?;
            let number = index.value();
            if std::mem::replace(&mut met[number], true) {
                return Err(FormatError(format!("nodes[{number}] is used twice, but nodes must form a tree")));
            }
            let world = parent * self.maps.get(number).map_or(DAffine3::IDENTITY, Map::affine);
            if !world.is_finite() {
                return Err(FormatError(format!("the position of nodes[{number}] is not finite")));
            }
            placed.push(Placed { number: number as u32, node, world });
            let children = node.children.iter().flatten().rev();
            waiting.extend(children.map(|child| (*child, world)));
        }
        Ok(placed)
    }

    /// Returns the nodes with a mesh.
    pub(in crate::assets) fn with_mesh(&self) -> Result<&WithMesh, FormatError> {
        let found = self.with_mesh.get_or_init(|| Ok(WithMesh::of(&self.placed()?)));
        found.as_ref().map_err(Clone::clone)
    }

    /// Returns the nodes without a parent.
    fn parentless(&self) -> Vec<Index<Node>> {
        let mut has_parent = vec![false; self.root.nodes.len()];
        for child in self.root.nodes.iter().flat_map(|node| node.children.iter().flatten()) {
            if let Some(has) = has_parent.get_mut(child.value()) {
                *has = true;
            }
        }
        let free = has_parent.iter().zip(0..).filter(|(has, _)| !**has);
        free.map(|(_, number)| Index::new(number)).collect()
    }
}

/// Returns the identification of each of these nodes in a scene file, given
/// all nodes of the scene: its name if that is unique, or else its index.
#[must_use]
pub fn names(nodes: &[Placed]) -> Vec<NodeName> {
    let mut uses: HashMap<&str, u32> = HashMap::new();
    for name in nodes.iter().filter_map(|placed| placed.node.name.as_deref()) {
        *uses.entry(name).or_default() += 1;
    }
    let is_only = |name: &&String| !name.is_empty() && uses.get(name.as_str()) == Some(&1);
    let name = |placed: &Placed| match placed.node.name.as_ref().filter(is_only) {
        Some(name) => NodeName::Name(name.clone()),
        None => NodeName::Number(placed.number),
    };
    nodes.iter().map(name).collect()
}

/// The nodes with a mesh, which can be looked up one by one.
#[derive(Debug)]
pub(in crate::assets) struct WithMesh {
    /// The index of each node in the file, and the map from its space to the scene.
    pub all: Vec<(u32, DAffine3)>,
    /// The indices into that list of the nodes with each name.
    named: HashMap<String, Vec<usize>>,
    numbered: HashMap<u32, usize>,
}

impl WithMesh {
    fn of(nodes: &[Placed]) -> Self {
        let (mut all, mut named, mut numbered) = (Vec::new(), HashMap::<String, Vec<usize>>::new(), HashMap::new());
        for placed in nodes.iter().filter(|placed| placed.node.mesh.is_some()) {
            if let Some(name) = &placed.node.name {
                named.entry(name.clone()).or_default().push(all.len());
            }
            numbered.insert(placed.number, all.len());
            all.push((placed.number, placed.world));
        }
        Self { all, named, numbered }
    }

    /// Returns the only node with this name or index.
    pub fn chosen(&self, name: &NodeName) -> Result<(u32, DAffine3), FormatError> {
        /// The largest number of names in a message.
        const TOLD: usize = 20;
        match name {
            NodeName::Number(number) => match self.numbered.get(number) {
                Some(at) => Ok(self.all[*at]),
                None => Err(FormatError(format!("the scene of the file has no node {number} with a mesh"))),
            },
            NodeName::Name(name) => match self.named.get(name).map_or(&[][..], Vec::as_slice) {
                [at] => Ok(self.all[*at]),
                [] => {
                    let mut names: Vec<&str> = self.named.keys().map(String::as_str).collect();
                    names.sort_unstable();
                    names.truncate(TOLD);
                    Err(FormatError(format!(
                        "the file has no node `{name}` with a mesh; {}",
                        suggest(name, &names, "nodes")
                    )))
                }
                several => {
                    let numbers: Vec<String> =
                        several.iter().take(TOLD).map(|at| self.all[*at].0.to_string()).collect();
                    Err(FormatError(format!(
                        "several nodes have this name; use one of the numbers {}",
                        numbers.join(", ")
                    )))
                }
            },
        }
    }
}

/// The maps of all nodes, as in the JSON.
#[derive(Debug, Deserialize)]
pub(super) struct Maps {
    #[serde(default)]
    pub nodes: Vec<Map>,
}

/// The map from a node's space to its parent's, in 64 bits: `gltf-json` rounds
/// it to 32 bits, which moves a position on a map of a country by meters.
#[derive(Debug, Deserialize)]
pub(super) struct Map {
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

impl Map {
    fn affine(&self) -> DAffine3 {
        if let Some(matrix) = &self.matrix {
            return DAffine3::from_mat4(DMat4::from_cols_array(matrix));
        }
        let rotation = self.rotation.map_or(DQuat::IDENTITY, DQuat::from_array);
        let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
        let scale = self.scale.map_or(DVec3::ONE, DVec3::from_array);
        let translation = self.translation.map_or(DVec3::ZERO, DVec3::from_array);
        DAffine3::from_scale_rotation_translation(scale, rotation, translation)
    }
}
