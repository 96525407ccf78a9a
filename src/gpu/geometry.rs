//! Stores the objects of a scene for the shaders: one list for each kind of shape, and an acceleration structure over large lists.

use std::sync::Arc;

use glam::{DVec3, Vec3};

use super::hierarchy::{Item, LEAF, Node};
use super::instances::{InstancedMesh, Instances};
use super::structure::AccelStructure;
use crate::assets::{Mesh, Vertex};
use crate::model::Object;
use crate::model::shape::{Placed, Primitive, SOLIDS};
use crate::program::{Analysis, Extent, Structure, constant, solid_code};
use crate::scene::Scene;

/// A shape other than a mesh, with its position.
#[derive(Debug, Clone, Copy)]
pub struct PlacedShape {
    /// The position and size.
    pub placed: Placed,
    /// The index of its material: the materials of the scene are followed by one for each object that transmits light.
    pub material: u32,
    /// Its bit in the set of regions, if rays continue from it.
    pub bit: Option<u32>,
    /// The index of the scene's object.
    pub object: u32,
    /// `true` if it moves.
    pub moves: bool,
}

/// Returns the code of a solid, which is stored in the upper bits of a primitive.
fn code(name: &str) -> u32 {
    SOLIDS.into_iter().find(|solid| solid.name == name).map_or(0, solid_code)
}

/// Returns the code of an instance, which is stored in the upper bits of an item.
fn instance() -> u32 {
    constant("shape/instance", "INSTANCE") as u32
}

/// Returns the name of the only solid without a list: the triangle, of which meshes consist.
fn triangle() -> &'static str {
    SOLIDS.into_iter().find(|solid| solid.lists.is_none()).map_or("", |solid| solid.name)
}

/// The parts of a frame's geometry that the next frame may reuse.
#[derive(Debug, Clone, Default)]
pub struct PreviousGeometry {
    /// The acceleration structure.
    pub structure: Option<AccelStructure>,
    /// The instanced meshes.
    pub meshes: Vec<Arc<InstancedMesh>>,
}

/// All objects that a ray can hit.
#[derive(Debug, Clone, Default)]
pub struct Geometry {
    /// The shapes, by the names of their solids.
    pub placed: std::collections::BTreeMap<&'static str, Vec<PlacedShape>>,
    /// The acceleration structure that segments search.
    pub structure: AccelStructure,
    /// The instances of meshes.
    pub instances: Instances,
    /// The three vertices and the object of each triangle; the object is 0 for instanced meshes.
    pub triangles: Vec<[u32; 4]>,
    /// The vertices of all meshes: in the scene's space, or in object space for instanced meshes.
    pub vertices: Vec<Vertex>,
    /// The index of each object's material.
    pub materials: Vec<u32>,
    /// The analysis of the scene.
    pub analysis: Analysis,
    /// The box of each object: lower and upper corner.
    pub boxes: Vec<(DVec3, DVec3)>,
}

impl Geometry {
    /// Places every object of the scene and builds the acceleration structure.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::after(PreviousGeometry::default(), scene)
    }

    /// Creates the geometry like [`Self::new`], but reuses an earlier structure over the same boxes and the hierarchies of the same meshes.
    #[must_use]
    pub fn after(before: PreviousGeometry, scene: &Scene) -> Self {
        let instances = Instances::after(before.meshes);
        let mut geometry = Self { analysis: Analysis::of(scene), instances, ..Self::default() };
        let structure = geometry.analysis.structure.clone();
        let regions = &geometry.analysis.regions;
        let clear = scene.materials.len();
        let material = |i: usize| scene.objects[i].material().or(regions.bit(i).map(|bit| clear + bit));
        geometry.materials = (0..scene.objects.len()).map(|i| material(i).unwrap_or(0) as u32).collect();
        for (i, object) in scene.objects.iter().enumerate() {
            match object.shape.mesh() {
                Some(mesh) if structure.once => geometry.instances.add(object, mesh, i as u32),
                Some(mesh) => geometry.add_mesh(object, mesh, i as u32),
                None => geometry.add_placed(object, i as u32),
            }
            geometry.boxes.push(scene.swept(object));
        }
        for shapes in geometry.placed.values_mut() {
            // Lists begin with shapes on which rays end, then those with two sides; moving shapes are at the end.
            shapes.sort_by_key(|shape| (shape.moves, shape.bit.is_some()));
        }
        geometry.build(&structure, before.structure);
        geometry
    }

    /// Returns the parts that the next frame may reuse.
    #[must_use]
    pub fn into_before(self) -> PreviousGeometry {
        PreviousGeometry { structure: Some(self.structure), meshes: self.instances.into_meshes() }
    }

    /// Returns the number of nodes and items that a search may visit; for instanced meshes, all nodes in every instance.
    #[must_use]
    pub fn extent(&self) -> Extent {
        let own = self.structure.extent();
        Extent { places: own.places + self.instances.nodes(), items: own.items + self.instances.triangles() }
    }

    /// Returns the nodes of the structure, followed by the nodes of each instanced mesh, whose items are triangles.
    pub fn nodes(&self) -> impl Iterator<Item = Node> {
        let (mut nodes, mut items) = (self.structure.nodes.len() as u32, 0);
        let meshes = self.instances.meshes().flat_map(move |kept| {
            let before = (nodes, items);
            nodes += kept.nodes.len() as u32;
            items += kept.triangles.len() as u32;
            kept.nodes.iter().map(move |node| node.behind(before.0, before.1))
        });
        self.structure.nodes.iter().copied().chain(meshes)
    }

    /// Returns the box of all objects.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.boxes.iter().fold(nothing, |all, one| (all.0.min(one.0), all.1.max(one.1)))
    }

    /// Returns a lower bound of the distance from `x` to any object.
    #[must_use]
    pub fn clearance(&self, x: DVec3) -> f64 {
        let distance = |(lo, hi): &(DVec3, DVec3)| (x.clamp(*lo, *hi) - x).length();
        self.boxes.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    /// Returns the linear colors of [`Self::vertices`]; white if a mesh has none.
    pub fn vertex_colors<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = Vec3> + 'a {
        let kept = self.instances.meshes().map(|kept| &*kept.mesh);
        let placed = scene.objects.iter().filter_map(|object| object.shape.mesh()).map(|mesh| &**mesh);
        let once = self.analysis.structure.once;
        kept.filter(move |_| once).chain(placed.filter(move |_| !once)).flat_map(Mesh::colors_or_white)
    }

    /// Returns the primitive of an object in the shaders; a mesh has no single primitive.
    #[must_use]
    pub fn primitive(&self, object: usize) -> u32 {
        let place = |shapes: &Vec<PlacedShape>| shapes.iter().position(|shape| shape.object as usize == object);
        let found = self.placed.iter().find_map(|(kind, shapes)| Some((kind, place(shapes)?)));
        found.map_or(constant("segment/ray", "NOTHING") as u32, |(kind, at)| code(kind) | at as u32)
    }

    fn add_placed(&mut self, object: &Object, index: u32) {
        self.placed.entry(object.solid().name).or_default().push(PlacedShape {
            placed: Placed::new(&*object.shape, &object.transform),
            material: self.materials[index as usize],
            object: index,
            bit: self.analysis.regions.bit(index as usize).map(|bit| bit as u32),
            moves: object.travel.is_some(),
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

    /// Builds the acceleration structure, and sorts its contents into the order of its leaves.
    fn build(&mut self, structure: &Structure, before: Option<AccelStructure>) {
        let leaf = if structure.once { 1 } else { LEAF };
        let built = AccelStructure::new(self.items(structure), structure.search, leaf, before);
        for (kind, shapes) in self.placed.iter_mut().filter(|(kind, _)| holds(structure, kind)) {
            let old = shapes.clone();
            for (shape, from) in shapes.iter_mut().zip(built.moved(code(kind))) {
                *shape = old[from];
            }
        }
        if structure.once {
            self.instances.order(built.moved(instance()).zip(built.behind(instance())));
            self.keep_meshes();
        } else {
            self.triangles = built.moved(code(triangle())).map(|from| self.triangles[from]).collect();
        }
        self.structure = built;
    }

    /// Appends the vertices and triangles of instanced meshes.
    fn keep_meshes(&mut self) {
        for kept in self.instances.meshes() {
            let first = self.vertices.len() as u32;
            self.vertices.extend(&kept.mesh.vertices);
            self.triangles.extend(kept.triangles.iter().map(|[a, b, c]| [first + a, first + b, first + c, 0]));
        }
    }

    /// Returns the items of the scene's acceleration structure.
    fn items(&self, structure: &Structure) -> Vec<Item> {
        let mut items = Vec::new();
        for (kind, shapes) in self.placed.iter().filter(|(kind, _)| holds(structure, kind)) {
            let code = code(kind);
            for (i, shape) in shapes.iter().enumerate().filter(|(_, shape)| shape.bit.is_none() && !shape.moves) {
                let (lo, hi) = self.boxes[shape.object as usize];
                items.push(Item { primitive: code | i as u32, lo: lo.as_vec3(), hi: hi.as_vec3() });
            }
        }
        items.extend(self.instances.places().iter().enumerate().map(|(i, place)| {
            let (lo, hi) = self.boxes[place.object as usize];
            Item { primitive: instance() | i as u32, lo: lo.as_vec3(), hi: hi.as_vec3() }
        }));
        let code = code(triangle());
        items.extend(self.triangles.iter().enumerate().map(|(i, [a, b, c, _])| {
            let [p, q, r] = [a, b, c].map(|&corner| self.vertices[corner as usize].position);
            Item { primitive: code | i as u32, lo: p.min(q).min(r), hi: p.max(q).max(r) }
        }));
        items
    }
}

fn holds(structure: &Structure, name: &str) -> bool {
    structure.solids.iter().any(|solid: &&Primitive| solid.name == name)
}
