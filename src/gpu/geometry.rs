//! A scene's objects as the shaders see them: one list for each kind of shape, and a hierarchy over all triangles.

use glam::{DVec3, DVec4, Vec3};
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::triangle::Triangle;

use crate::program::{Regions, constant, shape_kind};
use crate::scene::{Mesh, Object, Scene, Shape, Vertex};

/// A shape other than a mesh, in its place.
#[derive(Debug, Clone, Copy)]
pub struct PlacedShape {
    /// Its centre.
    pub center: DVec3,
    /// For spheres: the radius.
    pub radius: f64,
    /// For disks: the hole's radius, in own units.
    pub hole: f64,
    /// Rows of the affine map from the scene's space to the shape's own.
    pub rows: [DVec4; 3],
    /// Its place in the list of materials: the scene's own, and behind them one for each object that light goes through.
    pub material: u32,
    /// Its bit in the set of regions, where rays go on from it.
    pub bit: Option<u32>,
    /// Index into the scene's objects.
    pub object: u32,
}

/// A node of the hierarchy, in depth-first order.
#[derive(Debug, Clone, Copy)]
pub struct Node {
    /// The box's lower corner.
    pub lo: Vec3,
    /// The box's upper corner.
    pub hi: Vec3,
    /// The node after this one's subtree.
    pub skip: u32,
    /// 0 inside the tree; in a leaf the number of triangles in the upper eight bits, the first of them in the others.
    pub leaf: u32,
}

/// Everything that can be hit.
#[derive(Debug, Clone, Default)]
pub struct Geometry {
    /// By kind of shape (`sphere`, `ellipsoid`, `box`, `cylinder`, `plane`, `disk`).
    pub placed: std::collections::BTreeMap<&'static str, Vec<PlacedShape>>,
    /// The hierarchy's nodes.
    pub nodes: Vec<Node>,
    /// Three vertices and the object, in the order of the hierarchy's leaves.
    pub triangles: Vec<[u32; 4]>,
    /// Of all meshes, in the scene's space.
    pub vertices: Vec<Vertex>,
    /// Each object's place in the list of materials.
    pub materials: Vec<u32>,
    /// Which objects have an inside.
    pub regions: Regions,
    /// Each object's box: lower and upper corner.
    pub boxes: Vec<(DVec3, DVec3)>,
}

/// Triangles in one leaf, at most.
const LEAF: u32 = 4;

impl Geometry {
    /// Places every object of the scene and builds the hierarchy over its triangles.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut geometry = Self { regions: Regions::of(scene), ..Self::default() };
        let clear = scene.materials.len();
        let material = |i: usize| scene.objects[i].material().or(geometry.regions.bit(i).map(|bit| clear + bit));
        geometry.materials = (0..scene.objects.len()).map(|i| material(i).unwrap_or(0) as u32).collect();
        for (i, object) in scene.objects.iter().enumerate() {
            match &object.shape {
                Shape::Mesh(mesh) => geometry.add_mesh(object, mesh, i as u32),
                _ => geometry.add_placed(object, i as u32),
            }
            geometry.boxes.push(object.bounds());
        }
        for shapes in geometry.placed.values_mut() {
            shapes.sort_by_key(|shape| shape.bit.is_some());
        }
        geometry.build_hierarchy();
        geometry
    }

    /// The box of everything.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.boxes.iter().fold(nothing, |all, one| (all.0.min(one.0), all.1.max(one.1)))
    }

    /// No part of any object is nearer to `x` than this.
    #[must_use]
    pub fn clearance(&self, x: DVec3) -> f64 {
        let distance = |(lo, hi): &(DVec3, DVec3)| (x.clamp(*lo, *hi) - x).length();
        self.boxes.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    /// The primitive that an object is to the shaders; meshes are many.
    #[must_use]
    pub fn primitive(&self, object: usize) -> u32 {
        let place = |shapes: &Vec<PlacedShape>| shapes.iter().position(|shape| shape.object as usize == object);
        let found = self.placed.iter().find_map(|(kind, shapes)| Some((kind, place(shapes)?)));
        found.map_or(constant("ray", "NOTHING") as u32, |(kind, at)| {
            constant(&format!("shape/{kind}"), &kind.to_uppercase()) as u32 | at as u32
        })
    }

    fn add_placed(&mut self, object: &Object, index: u32) {
        let map = object.transform.0;
        let inverse = map.inverse();
        let m = inverse.matrix3.transpose();
        let t = inverse.translation;
        self.placed.entry(shape_kind(&object.shape, &object.transform)).or_default().push(PlacedShape {
            center: map.translation,
            radius: object.transform.uniform_scale().unwrap_or(0.0),
            hole: if let Shape::Disk { hole } = object.shape { hole } else { 0.0 },
            rows: [m.x_axis.extend(t.x), m.y_axis.extend(t.y), m.z_axis.extend(t.z)],
            material: self.materials[index as usize],
            object: index,
            bit: self.regions.bit(index as usize).map(|bit| bit as u32),
        });
    }

    fn add_mesh(&mut self, object: &Object, mesh: &Mesh, index: u32) {
        let map = object.transform.0;
        let normals = map.matrix3.inverse().transpose();
        let first = self.vertices.len() as u32;
        for vertex in &mesh.vertices {
            let position = map.transform_point3(vertex.position.as_dvec3());
            self.vertices.push(Vertex {
                position: position.as_vec3(),
                normal: (normals * vertex.normal.as_dvec3()).normalize_or_zero().as_vec3(),
                uv: vertex.uv,
            });
        }
        self.triangles.extend(mesh.triangles.iter().map(|[a, b, c]| [first + a, first + b, first + c, index]));
    }

    fn build_hierarchy(&mut self) {
        if self.triangles.is_empty() {
            return;
        }
        let corner = |i: u32| self.vertices[i as usize].position.into();
        let triangles: Vec<Triangle> = self
            .triangles
            .iter()
            .map(|[a, b, c, _]| Triangle { v0: corner(*a), v1: corner(*b), v2: corner(*c) })
            .collect();
        let params = BvhBuildParams { max_prims_per_leaf: LEAF, pre_split: false, ..BvhBuildParams::medium_build() };
        let bvh = build_bvh2_from_tris(&triangles, params, &mut std::time::Duration::default());
        let mut ordered = Vec::with_capacity(self.triangles.len());
        flatten(&bvh, 0, &self.triangles, &mut self.nodes, &mut ordered);
        self.triangles = ordered;
    }
}

/// Depth first, so that the next node to visit is the next in the list where the box is met, and `skip` where it is missed.
fn flatten(bvh: &Bvh2, at: usize, triangles: &[[u32; 4]], nodes: &mut Vec<Node>, ordered: &mut Vec<[u32; 4]>) {
    // An explicit stack: a degenerate mesh makes a tree too deep for recursion. `None` closes the node whose subtree ended.
    let mut open = vec![Ok(at)];
    while let Some(next) = open.pop() {
        let at = match next {
            Ok(at) => at,
            Err(node) => {
                let skip = nodes.len() as u32;
                let node: &mut Node = &mut nodes[node];
                node.skip = skip;
                continue;
            }
        };
        let node = &bvh.nodes[at];
        let (lo, hi) = (node.aabb.min.into(), node.aabb.max.into());
        let mut leaf = 0;
        open.push(Err(nodes.len()));
        if node.prim_count > 0 {
            leaf = (node.prim_count << 24) | ordered.len() as u32;
            let first = node.first_index as usize;
            let own = &bvh.primitive_indices[first..first + node.prim_count as usize];
            ordered.extend(own.iter().map(|&i| triangles[i as usize]));
        } else {
            open.extend([Ok(node.first_index as usize + 1), Ok(node.first_index as usize)]);
        }
        nodes.push(Node { lo, hi, skip: 0, leaf });
    }
}
