//! The conversion of a file's contents to a mesh: positions are rounded to 32 bits, and corners with equal values become one vertex.

use std::collections::hash_map::Entry;

use foldhash::{HashMap, HashMapExt};
use glam::{DVec3, Vec2, Vec3};

use super::raw::{Corner, Raw};
use super::{Mesh, Vertex, normals};
use crate::assets::format_error::FormatError;

impl Raw {
    /// Returns the mesh. Missing normals are generated: faces that meet at an angle below `crease` degrees share their normals.
    pub(super) fn mesh(&self, crease: f64) -> Result<Mesh, FormatError> {
        let origin = self.origin();
        let place = |corner: Corner| (self.positions[corner.position as usize] - origin).as_vec3();
        let made = normals::made(self, crease, origin);
        let mut index_of: HashMap<[u32; 11], u32> = HashMap::with_capacity(self.positions.len());
        let mut vertices = Vec::with_capacity(self.positions.len());
        let has_colors = self.colors.are_there();
        let mut colors = Vec::with_capacity(if has_colors { self.positions.len() } else { 0 });
        let mut vertex = |corner: Corner, made: Option<Vec3>| {
            let vertex = Vertex {
                position: place(corner),
                normal: self.given_normal(corner).or(made).unwrap_or(Vec3::Z),
                uv: self.uvs.get(corner.uv as usize).copied().unwrap_or(Vec2::ZERO),
            };
            let ([x, y, z], [nx, ny, nz]) = (vertex.position.to_array(), vertex.normal.to_array());
            let color = if has_colors { self.colors.get(corner.position) } else { Vec3::ONE };
            let uv = vertex.uv;
            let key = [x, y, z, nx, ny, nz, uv.x, uv.y, color.x, color.y, color.z].map(f32::to_bits);
            match index_of.entry(key) {
                Entry::Occupied(known) => *known.get(),
                Entry::Vacant(free) => {
                    vertices.push(vertex);
                    colors.extend(has_colors.then_some(color));
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
            return Err(FormatError(self.nothing()));
        }
        let color_flaw = self.colors.flaw().map(str::to_owned);
        Ok(Mesh { origin, left_out: self.left_out(), colors, color_flaw, ..Mesh::new(vertices, triangles) })
    }
}
