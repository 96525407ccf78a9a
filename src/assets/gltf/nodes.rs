//! Nodes in their places: the trees of the scene that a file shows.

use glam::{DAffine3, DMat4, DQuat, DVec3, Vec3};
use gltf_json::{Index, Node};

use super::Gltf;
use crate::assets::flaw::Flaw;
use crate::document::SceneError;

/// What a node is called.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NodeName {
    /// By its name.
    Name(String),
    /// By its place in the file, counted from 0.
    Number(u32),
}

/// A node of the scene.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a> {
    /// Its place in the file.
    pub number: u32,
    /// What it is.
    pub node: &'a Node,
    /// The map from its space to the scene's.
    pub world: DAffine3,
}

impl Gltf {
    /// The nodes of the scene that the file shows by itself, in the order of the trees: each once.
    pub fn nodes(&self) -> Result<Vec<Placed<'_>>, SceneError> {
        self.placed().map_err(|flaw| flaw.of(&self.path))
    }

    pub(in crate::assets) fn placed(&self) -> Result<Vec<Placed<'_>>, Flaw> {
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
                return Err(Flaw(format!("nodes[{number}] has two places: nodes are trees")));
            }
            let world = parent * own(node);
            if !world.is_finite() {
                return Err(Flaw(format!("nodes[{number}] has no finite place")));
            }
            placed.push(Placed { number: number as u32, node, world });
            let children = node.children.iter().flatten().rev();
            waiting.extend(children.map(|child| (*child, world)));
        }
        Ok(placed)
    }

    /// The nodes that are no node's children.
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

impl Placed<'_> {
    /// What a scene's file calls it, if all of these are the scene's: its name, where no other has it.
    #[must_use]
    pub fn name(&self, all: &[Placed]) -> NodeName {
        let own = self.node.name.as_ref().filter(|name| !name.is_empty());
        let is_only = |name: &&String| all.iter().filter(|other| other.node.name.as_ref() == Some(*name)).count() == 1;
        own.filter(is_only).map_or(NodeName::Number(self.number), |name| NodeName::Name(name.clone()))
    }
}

/// The map from a node's space to its parent's.
fn own(node: &Node) -> DAffine3 {
    if let Some(matrix) = &node.matrix {
        return DAffine3::from_mat4(DMat4::from_cols_array(&matrix.map(f64::from)));
    }
    let vector = |value: Option<[f32; 3]>, usual: DVec3| value.map_or(usual, |value| Vec3::from(value).as_dvec3());
    let rotation = node.rotation.map_or(DQuat::IDENTITY, |rotation| DQuat::from_array(rotation.0.map(f64::from)));
    let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    let (scale, translation) = (vector(node.scale, DVec3::ONE), vector(node.translation, DVec3::ZERO));
    DAffine3::from_scale_rotation_translation(scale, rotation, translation)
}
