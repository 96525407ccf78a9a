//! Meshes that are kept once, and the places in which objects show them.
//!
//! *Practice.* Each mesh has a hierarchy of its own, in its own space, and the scene's holds one item for each place. A walk that
//! comes to a place goes on in the mesh's hierarchy, with the segment mapped to its space, and comes back at its end.

use std::sync::Arc;

use glam::DAffine3;

use super::hierarchy::{Item, LEAF, Node, hierarchy};
use crate::assets::Mesh;
use crate::model::{Object, Row, row};

/// A mesh, and the hierarchy over its triangles.
#[derive(Debug)]
pub struct KeptMesh {
    /// As it was read.
    pub mesh: Arc<Mesh>,
    /// The hierarchy's nodes.
    pub nodes: Vec<Node>,
    /// The triangles in the order of its leaves.
    pub triangles: Vec<[u32; 3]>,
}

impl KeptMesh {
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

/// One place of a mesh.
#[derive(Debug, Clone, Copy)]
pub struct Instance {
    /// Index into the scene's objects.
    pub object: u32,
    /// Which of the meshes.
    mesh: usize,
    /// From the scene's space to the mesh's own.
    own: DAffine3,
    /// The node behind the leaf that holds it.
    next: u32,
}

/// All meshes that are kept once, and their places in the order of the structure's leaves.
#[derive(Debug, Clone, Default)]
pub struct Instances {
    meshes: Vec<Arc<KeptMesh>>,
    places: Vec<Instance>,
    /// Those of an earlier frame.
    before: Vec<Arc<KeptMesh>>,
}

impl Instances {
    /// None yet. What was built for an earlier frame's meshes is gone on with.
    #[must_use]
    pub fn after(before: Vec<Arc<KeptMesh>>) -> Self {
        Self { before, ..Self::default() }
    }

    /// What the next frame may go on with.
    #[must_use]
    pub fn into_meshes(self) -> Vec<Arc<KeptMesh>> {
        self.meshes
    }

    /// Are there none?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The places.
    #[must_use]
    pub fn places(&self) -> &[Instance] {
        &self.places
    }

    /// The meshes.
    pub fn meshes(&self) -> impl Iterator<Item = &KeptMesh> {
        self.meshes.iter().map(|kept| &**kept)
    }

    /// One more place, of the object with this index.
    pub(super) fn add(&mut self, object: &Object, mesh: &Arc<Mesh>, index: u32) {
        let is_same = |kept: &&Arc<KeptMesh>| Arc::ptr_eq(&kept.mesh, mesh);
        let known = self.meshes.iter().position(|kept| is_same(&kept));
        let which = known.unwrap_or_else(|| {
            let built = self.before.iter().find(is_same).cloned();
            self.meshes.push(built.unwrap_or_else(|| Arc::new(KeptMesh::new(mesh))));
            self.meshes.len() - 1
        });
        let own = object.transform.0.inverse();
        self.places.push(Instance { object: index, mesh: which, own, next: 0 });
    }

    /// Brings the places into the order in which a structure holds them: each with its place before, and the node behind its leaf.
    pub(super) fn order(&mut self, ordered: impl Iterator<Item = (usize, u32)>) {
        self.places = ordered.map(|(from, next)| Instance { next, ..self.places[from] }).collect();
    }

    /// The triangles of all places.
    #[must_use]
    pub fn triangles(&self) -> u64 {
        self.places.iter().map(|place| self.meshes[place.mesh].triangles.len() as u64).sum()
    }

    /// The nodes of all places' meshes.
    #[must_use]
    pub fn nodes(&self) -> u64 {
        self.places.iter().map(|place| self.meshes[place.mesh].nodes.len() as u64).sum()
    }

    /// The rows of `shaders/shape/instance.wgsl`, with `nodes_before` nodes before the meshes' own, and the material of each object.
    pub(super) fn rows(&self, nodes_before: u32, materials: &[u32]) -> Vec<Row> {
        let mut firsts = Vec::new();
        let (mut root, mut first) = (nodes_before, 0_u32);
        for kept in &self.meshes {
            firsts.push((root, first));
            root += kept.nodes.len() as u32;
            first += kept.triangles.len() as u32;
        }
        // More than a word holds are refused before they are used.
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
