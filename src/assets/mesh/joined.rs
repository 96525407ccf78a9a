//! What was read, as a mesh: positions are rounded to 32 bits, and corners that are equal in everything are one vertex.

use std::collections::hash_map::Entry;

use foldhash::{HashMap, HashMapExt};
use glam::{DVec3, Vec2, Vec3};

use super::raw::{Corner, Raw};
use super::{Mesh, Vertex, normals};
use crate::assets::flaw::Flaw;

impl Raw {
    /// The mesh, with normals made where there are none: faces that meet at an angle below `crease` degrees share theirs.
    pub(super) fn mesh(&self, crease: f64) -> Result<Mesh, Flaw> {
        let origin = self.origin();
        let place = |corner: Corner| (self.positions[corner.position as usize] - origin).as_vec3();
        let made = normals::made(self, crease, origin);
        let mut index_of: HashMap<[u32; 8], u32> = HashMap::with_capacity(self.positions.len());
        let mut vertices = Vec::with_capacity(self.positions.len());
        let mut vertex = |corner: Corner, made: Option<Vec3>| {
            let vertex = Vertex {
                position: place(corner),
                normal: self.given_normal(corner).or(made).unwrap_or(Vec3::Z),
                uv: self.uvs.get(corner.uv as usize).copied().unwrap_or(Vec2::ZERO),
            };
            let ([x, y, z], [nx, ny, nz]) = (vertex.position.to_array(), vertex.normal.to_array());
            let key = [x, y, z, nx, ny, nz, vertex.uv.x, vertex.uv.y].map(f32::to_bits);
            match index_of.entry(key) {
                Entry::Occupied(known) => *known.get(),
                Entry::Vacant(free) => {
                    vertices.push(vertex);
                    *free.insert(vertices.len() as u32 - 1)
                }
            }
        };
        let has_area = |corners: &[Corner; 3]| {
            let [a, b, c] = corners.map(|corner| place(corner).as_dvec3());
            (b - a).cross(c - a) != DVec3::ZERO
        };
        let rounded = self.triangles().iter().enumerate().filter(|(_, triangle)| has_area(&triangle.corners));
        let triangles = rounded.map(|(i, triangle)| {
            let [a, b, c] = triangle.corners;
            let made = made.get(i).map_or([None; 3], |made| made.map(Some));
            [vertex(a, made[0]), vertex(b, made[1]), vertex(c, made[2])]
        });
        let triangles: Vec<[u32; 3]> = triangles.collect();
        if triangles.is_empty() {
            return Err(Flaw(self.nothing()));
        }
        Ok(Mesh { origin, left_out: self.left_out(), ..Mesh::new(vertices, triangles) })
    }
}
