//! A scene's objects as the shaders see them: one list for each kind of shape, and a structure over those that are many.

use glam::{DVec3, DVec4};

use super::hierarchy::Item;
use super::structure::Built;
use crate::program::{Extent, Regions, Structure, constant, shape_kind};
use crate::scene::{Mesh, Object, Scene, Shape, Vertex};

/// A shape other than a mesh, in its place.
#[derive(Debug, Clone, Copy)]
pub struct PlacedShape {
    /// Its centre.
    pub center: DVec3,
    /// For spheres the radius, for disks the hole's, in own units.
    pub radius: f64,
    /// Rows of the affine map from the scene's space to the shape's own.
    pub rows: [DVec4; 3],
    /// Its place in the list of materials: the scene's own, and behind them one for each object that light goes through.
    pub material: u32,
    /// Its bit in the set of regions, where rays go on from it.
    pub bit: Option<u32>,
    /// Index into the scene's objects.
    pub object: u32,
}

/// A kind of shape in the upper bits of a primitive.
fn kind_code(kind: &str) -> u32 {
    constant(&format!("shape/{kind}"), &kind.to_uppercase()) as u32
}

/// Everything that can be hit.
#[derive(Debug, Clone, Default)]
pub struct Geometry {
    /// By kind of shape (`sphere`, `ellipsoid`, `box`, `cylinder`, `plane`, `disk`).
    pub placed: std::collections::BTreeMap<&'static str, Vec<PlacedShape>>,
    /// What segments search.
    pub structure: Built,
    /// Three vertices and the object.
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

impl Geometry {
    /// Places every object of the scene and builds its structure.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::after(None, scene)
    }

    /// As [`Self::new`], with an earlier structure if that was built over the same boxes.
    #[must_use]
    pub fn after(before: Option<Built>, scene: &Scene) -> Self {
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
        let structure = Structure::of(scene);
        geometry.build(&structure, before);
        geometry
    }

    /// How far a search of its structure may go.
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.structure.extent()
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
        found.map_or(constant("segment/ray", "NOTHING") as u32, |(kind, at)| kind_code(kind) | at as u32)
    }

    fn add_placed(&mut self, object: &Object, index: u32) {
        let map = object.transform.0;
        let inverse = map.inverse();
        let m = inverse.matrix3.transpose();
        let t = inverse.translation;
        self.placed.entry(shape_kind(&object.shape, &object.transform)).or_default().push(PlacedShape {
            center: map.translation,
            radius: match object.shape {
                Shape::Disk { hole } => hole,
                _ => object.transform.uniform_scale().unwrap_or(0.0),
            },
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

    /// Builds the structure, and brings what stands in it into its order.
    fn build(&mut self, structure: &Structure, before: Option<Built>) {
        let built = Built::new(self.items(structure), structure.search, before);
        for (kind, shapes) in self.placed.iter_mut().filter(|(kind, _)| structure.holds(kind)) {
            let old = shapes.clone();
            for (shape, from) in shapes.iter_mut().zip(built.moved(kind_code(kind))) {
                *shape = old[from];
            }
        }
        self.triangles = built.moved(kind_code("triangle")).map(|from| self.triangles[from]).collect();
        self.structure = built;
    }

    /// What stands in the scene's structure.
    fn items(&self, structure: &Structure) -> Vec<Item> {
        let mut items = Vec::new();
        for (kind, shapes) in self.placed.iter().filter(|(kind, _)| structure.holds(kind)) {
            let code = kind_code(kind);
            for (i, shape) in shapes.iter().enumerate().filter(|(_, shape)| shape.bit.is_none()) {
                let (lo, hi) = self.boxes[shape.object as usize];
                items.push(Item { primitive: code | i as u32, lo: lo.as_vec3(), hi: hi.as_vec3() });
            }
        }
        let code = kind_code("triangle");
        items.extend(self.triangles.iter().enumerate().map(|(i, [a, b, c, _])| {
            let [p, q, r] = [a, b, c].map(|&corner| self.vertices[corner as usize].position);
            Item { primitive: code | i as u32, lo: p.min(q).min(r), hi: p.max(q).max(r) }
        }));
        items
    }
}
