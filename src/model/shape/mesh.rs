//! Triangle meshes from a file. A point is inside if the surface winds around it.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::{Contact, Kind, Primitive, Shape};
use crate::assets::{Mesh, MeshPart, MeshRequest, NodeName, Transform};
use crate::document::values::{Parsed, angle, fitting, whole};
use crate::document::{Node, Value, keys};
use crate::model::cross_section::{LocalPlane, Outline, mesh};
use crate::model::medium::Surroundings;

pub static KIND: Kind = Kind {
    name: "mesh",
    keys: keys! {
        file: "file" = "required", "OBJ, PLY, STL or glTF file";
        node: "name, or a whole number from 0" = "the whole scene of the file",
            "glTF only: node whose mesh is used, with its transform in the scene of the file";
        primitive: "whole number from 0" = "all", "glTF only: index of the primitive of that mesh; each primitive has its own material";
        crease: "number, 0 to 180" = "30",
            "angle in degrees below which adjoining faces are shaded smoothly, for files without normals; 0 shades every face flat";
    },
    read: |table, _, files| {
        let file = table.required_node("file", "\"teapot.obj\"");
        let angle = fitting(angle, "an angle from 0 to 180 degrees", |x| (0.0..=180.0).contains(&x));
        let crease = table.or("crease", MeshRequest::CREASE, angle);
        let node = table.optional("node", node_name);
        let primitive = table.optional("primitive", whole(0..=u32::MAX));
        let wanted = MeshRequest { crease, part: MeshPart { node, primitive } };
        let part = ["node", "primitive"].into_iter().find_map(|key| table.node(key));
        let (mesh, place) = files.mesh(table.reader, file?, part.unwrap_or(file?), &wanted)?;
        Some((Arc::new(Triangles(mesh)), place))
    },
};

pub static SOLID: Primitive = Primitive { name: "triangle", lists: None };

/// A triangle mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Triangles(pub Arc<Mesh>);

/// Reads the name or index of a node.
fn node_name(node: &Node) -> Parsed<NodeName> {
    match &node.value {
        Value::Text(name) => Ok(NodeName::Name(name.clone())),
        _ => whole(0..=u32::MAX)(node).map(NodeName::Number),
    }
}

impl Shape for Triangles {
    fn solid(&self, _: &Transform) -> &'static Primitive {
        &SOLID
    }

    fn mesh(&self) -> Option<&Arc<Mesh>> {
        Some(&self.0)
    }

    fn contains(&self, p: DVec3) -> bool {
        // Most points are outside, and the winding number is cheaper than the search for an opening.
        self.0.winding(p).abs() > 0.5 && self.0.opening().is_none()
    }

    fn near_surface(&self, p: DVec3, slack: f64) -> bool {
        if p.length() > self.0.radius() + slack {
            return false;
        }
        let corner = |i: u32| self.0.vertices[i as usize].position.as_dvec3() - p;
        self.0.triangles.iter().any(|triangle| {
            let [a, b, c] = triangle.map(corner);
            // For slivers only the box test is reliable.
            let (lo, hi) = (a.min(b).min(c), a.max(b).max(c));
            if lo.max_element() > slack || hi.min_element() < -slack {
                return false;
            }
            let normal = (b - a).cross(c - a).normalize_or_zero();
            // Above the triangle all three edges have the point on one side.
            let sides = [a.cross(b), b.cross(c), c.cross(a)].map(|side| side.dot(normal));
            a.dot(normal).abs() <= slack && sides.iter().all(|side| *side >= 0.0)
        })
    }

    fn refuses_interior(&self) -> Option<String> {
        self.0.opening().map(str::to_owned)
    }

    fn solids(&self) -> Vec<Arc<dyn Shape>> {
        self.0.solids().iter().map(|mesh| Arc::new(Self(Arc::clone(mesh))) as Arc<dyn Shape>).collect()
    }

    fn contacts(&self, _: DAffine3) -> Vec<Contact> {
        Vec::new()
    }

    fn reach(&self, map: DAffine3, center: DVec3) -> Option<f64> {
        Some(self.0.most(|p| map.transform_point3(p).distance(center)).max(0.0))
    }

    fn radius(&self) -> f64 {
        self.0.radius()
    }

    fn surroundings(&self, place: &Transform) -> Surroundings {
        // The center is the file's origin, not the origin of the stored mesh.
        Surroundings { center: place.0.transform_point3(-self.0.origin), ..Surroundings::default() }
    }

    fn cut(&self, plane: LocalPlane) -> Vec<Outline> {
        mesh::cut(&self.0, plane)
    }

    fn bounds(&self, map: DAffine3) -> (DVec3, DVec3) {
        let most = |axis: usize, sign: f64| sign * self.0.most(|p| sign * map.transform_point3(p)[axis]);
        let side = |sign: f64| DVec3::from_array([0, 1, 2].map(|axis| most(axis, sign)));
        (side(-1.0), side(1.0))
    }
}
