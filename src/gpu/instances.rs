//! Instances meshes that several objects share.
//!
//! *Practice.* Each mesh has a hierarchy in its object space, and the scene's hierarchy has one item for each instance. A traversal that
//! reaches an instance continues in the mesh's hierarchy, with the segment transformed to object space, and then returns.

use std::sync::Arc;

use glam::DAffine3;

use super::hierarchy::{Item, LEAF, Node, hierarchy};
use crate::assets::Mesh;
use crate::model::{Object, Row, row};

/// A mesh, and the hierarchy over its triangles.
#[derive(Debug)]
pub struct InstancedMesh {
    /// The mesh as it was read.
    pub mesh: Arc<Mesh>,
    /// The hierarchy's nodes.
    pub nodes: Vec<Node>,
    /// The triangles, in the order of the hierarchy's leaves.
    pub triangles: Vec<[u32; 3]>,
}

impl InstancedMesh {
    fn new(mesh: &Arc<Mesh>) -> Self {
        let item = |(i, corners): (usize, &[u32; 3])| {
            let [p, q, r] = corners.map(|corner| mesh.vertices[corner as usize].position);
            Item { primitive: i as u32, lo: p.min(q).min(r), hi: p.max(q).max(r) }
        };
        let items: Vec<Item> = mesh.triangles.iter().enumerate().map(item).collect();
        let (nodes, order) = hierarchy(&items, LEAF);
        let triangles = order.iter().map(|&i| mesh.triangles[i as usize]).collect();
        Self { mesh: Arc::clone(mesh), nodes, triangles }
    }
}

/// One instance of a mesh.
#[derive(Debug, Clone, Copy)]
pub struct Instance {
    /// The index of the scene's object.
    pub object: u32,
    /// The index of the mesh.
    mesh: usize,
    /// The map from the scene's space to object space.
    own: DAffine3,
    /// The node that follows the leaf with this instance.
    next: u32,
}

/// All instanced meshes, and their instances in the order of the leaves of the acceleration structure.
#[derive(Debug, Clone, Default)]
pub struct Instances {
    meshes: Vec<Arc<InstancedMesh>>,
    places: Vec<Instance>,
    /// The meshes of an earlier frame.
    before: Vec<Arc<InstancedMesh>>,
}

impl Instances {
    /// Creates an empty set, which reuses the hierarchies of an earlier frame's meshes.
    #[must_use]
    pub fn after(before: Vec<Arc<InstancedMesh>>) -> Self {
        Self { before, ..Self::default() }
    }

    /// Returns the meshes for the next frame to reuse.
    #[must_use]
    pub fn into_meshes(self) -> Vec<Arc<InstancedMesh>> {
        self.meshes
    }

    /// Returns `true` if there are no instances.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// Returns the instances.
    #[must_use]
    pub fn places(&self) -> &[Instance] {
        &self.places
    }

    /// Returns the meshes.
    pub fn meshes(&self) -> impl Iterator<Item = &InstancedMesh> {
        self.meshes.iter().map(|kept| &**kept)
    }

    /// Adds an instance of `mesh` for the object with this index.
    pub(super) fn add(&mut self, object: &Object, mesh: &Arc<Mesh>, index: u32) {
        let is_same = |kept: &&Arc<InstancedMesh>| Arc::ptr_eq(&kept.mesh, mesh);
        let known = self.meshes.iter().position(|kept| is_same(&kept));
        let which = known.unwrap_or_else(|| {
            let built = self.before.iter().find(is_same).cloned();
            self.meshes.push(built.unwrap_or_else(|| Arc::new(InstancedMesh::new(mesh))));
            self.meshes.len() - 1
        });
        let own = object.transform.0.inverse();
        self.places.push(Instance { object: index, mesh: which, own, next: 0 });
    }

    /// Sorts the instances into the order of an acceleration structure; `ordered` gives the old index of each, and the node after its leaf.
    pub(super) fn order(&mut self, ordered: impl Iterator<Item = (usize, u32)>) {
        self.places = ordered.map(|(from, next)| Instance { next, ..self.places[from] }).collect();
    }

    /// Returns the number of triangles of all instances.
    #[must_use]
    pub fn triangles(&self) -> u64 {
        self.places.iter().map(|place| self.meshes[place.mesh].triangles.len() as u64).sum()
    }

    /// Returns the number of nodes of all instances' meshes.
    #[must_use]
    pub fn nodes(&self) -> u64 {
        self.places.iter().map(|place| self.meshes[place.mesh].nodes.len() as u64).sum()
    }

    /// Returns the rows of `shaders/shape/instance.wgsl`. The meshes' nodes follow `nodes_before` others; `materials` has one entry per
    /// object.
    pub(super) fn rows(&self, nodes_before: u32, materials: &[u32]) -> Vec<Row> {
        let mut firsts = Vec::new();
        let (mut root, mut first) = (nodes_before, 0_u32);
        for kept in &self.meshes {
            firsts.push((root, first));
            root += kept.nodes.len() as u32;
            first += kept.triangles.len() as u32;
        }
        // Counts that exceed a word are rejected before they are used.
        let (mut primitives, mut places) = (0_u32, 0_u32);
        let row = |place: &Instance| -> Row {
            let (kept, (root, first)) = (&self.meshes[place.mesh], firsts[place.mesh]);
            let [x, y, z] = [0, 1, 2].map(|k| place.own.matrix3.row(k).extend(place.own.translation[k]));
            let own = row! {
                row_x: Vec4(x), row_y: Vec4(y), row_z: Vec4(z), root: Uint(root), first: Uint(first),
                next: Uint(place.next), object: Uint(place.object), primitives: Uint(primitives), places: Uint(places),
                material: Uint(materials[place.object as usize]),
            };
            primitives = primitives.wrapping_add(kept.triangles.len() as u32);
            places = places.wrapping_add(kept.nodes.len() as u32);
            own
        };
        self.places.iter().map(row).collect()
    }
}
