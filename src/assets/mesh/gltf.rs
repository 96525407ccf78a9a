//! The meshes of glTF: primitives of nodes, each at its position in the file's scene.
//!
//! *Theory.* A primitive consists of triangles, a strip or a fan; points and lines are counted and not drawn. Its texture coordinates
//! are the ones that its material's color uses, transformed by `KHR_texture_transform`, with v counted from below as everywhere in bentray.
//!
//! *Practice.* [`Gltf`] reads and checks the bytes. The mesh of one node stays in object space, so nodes with the same
//! mesh share it. Meshes of all nodes together, and meshes that a node mirrors, are transformed in 64 bits.
//!
//! *Length.* Over 300 lines, because primitives of triangles, strips and fans are read by the same few closures.

mod colors;

use std::collections::BTreeMap;
use std::ops::{Range, RangeInclusive};
use std::path::PathBuf;

use glam::{DAffine3, DVec3, Mat2, Vec2, Vec3};
use gltf_json::accessor::Type;
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::texture::Info;
use gltf_json::validation::Checked::{Invalid, Valid};
use gltf_json::{Accessor, Index};

use super::bytes::usable;
use super::raw::{Corner, Raw};
use super::{Capacity, Format, Mesh, MeshPart, MeshSource, Parts, Read};
use crate::assets::format_error::FormatError;
use crate::assets::gltf::{Elements, Gltf, NodeName};
use crate::document::SceneError;

pub(super) const FORMAT: Format =
    Format { extensions: &["gltf", "glb"], read: Read::Parts(|bytes, path| Ok(Box::new(Gltf::open(bytes, path)?))) };

/// The largest number of vertices and of triangle corners of a mesh; nodes may repeat meshes, and meshes may repeat numbers.
const MOST: u64 = 1 << 26;

impl Parts for Gltf {
    fn find(&self, part: &MeshPart) -> Result<(MeshSource, DAffine3), SceneError> {
        self.source(part).map_err(|flaw| flaw.of(self.path()))
    }

    fn read(&self, source: &MeshSource, capacity: &Capacity) -> Result<Raw, SceneError> {
        self.raw(source, capacity).map_err(|flaw| flaw.of(self.path()))
    }

    fn others(&self) -> Vec<PathBuf> {
        Self::others(self).collect()
    }
}

impl Gltf {
    /// Returns the source of a part of the file, and the map from its space to the file's scene.
    ///
    /// # Errors
    ///
    /// Returns an error if the file has no such part, or several nodes have its name.
    pub fn find(&self, part: &MeshPart) -> Result<(MeshSource, DAffine3), SceneError> {
        Parts::find(self, part)
    }

    /// Reads the triangles of a source; if the file has no normals, they are generated with the angle `crease`.
    ///
    /// # Errors
    ///
    /// Returns an error if the file has no such part, its data are invalid, or it has no triangles.
    pub fn read(&self, source: &MeshSource, crease: f64) -> Result<Mesh, SceneError> {
        Parts::read(self, source, &Capacity::default())?.mesh(crease).map_err(|flaw| flaw.of(self.path()))
    }

    fn source(&self, part: &MeshPart) -> Result<(MeshSource, DAffine3), FormatError> {
        let Some(name) = &part.node else { return Ok((MeshSource::Placed(part.clone()), DAffine3::IDENTITY)) };
        let (number, world) = self.with_mesh()?.chosen(name)?;
        let (mesh, _) = self.mesh_of(number)?;
        self.numbers(number, part.primitive)?;
        if may_be_mapped(world) {
            return Ok((MeshSource::Own { mesh, primitive: part.primitive }, world));
        }
        let node = Some(NodeName::Number(number));
        Ok((MeshSource::Placed(MeshPart { node, primitive: part.primitive }), DAffine3::IDENTITY))
    }

    fn raw(&self, source: &MeshSource, capacity: &Capacity) -> Result<Raw, FormatError> {
        let shown = match source {
            MeshSource::Own { mesh, primitive } => {
                let count = self.root.meshes.get(*mesh).map_or(0, |mesh| mesh.primitives.len());
                let numbers = primitive.map_or(0..count, |number| number as usize..number as usize + 1);
                vec![(*mesh, numbers, DAffine3::IDENTITY)]
            }
            MeshSource::Placed(part) => {
                let all = self.with_mesh()?;
                let nodes = match &part.node {
                    None => all.all.clone(),
                    Some(name) => vec![all.chosen(name)?],
                };
                let shown = nodes
                    .into_iter()
                    .map(|(number, world)| Ok((self.mesh_of(number)?.0, self.numbers(number, part.primitive)?, world)));
                shown.collect::<Result<_, FormatError>>()?
            }
        };
        let mut primitives = Vec::new();
        for (mesh, numbers, world) in shown {
            for number in numbers {
                let of = format!("meshes[{mesh}].primitives[{number}]");
                primitives.push((&self.root.meshes[mesh].primitives[number], world, of));
            }
        }
        capacity.check(self.count_triangles(&primitives)?)?;
        let mut raw = Raw::default();
        for (primitive, world, of) in primitives {
            self.primitive(&mut raw, primitive, world, &of)?;
        }
        if raw.is_empty() { Err(FormatError(raw.nothing())) } else { Ok(raw) }
    }

    /// Returns the mesh of a node that has one, with its index in the file.
    fn mesh_of(&self, node: u32) -> Result<(usize, &gltf_json::Mesh), FormatError> {
        let index = self.root.nodes[node as usize].mesh;
        let (at, mesh) = index.map_or((0, None), |index| (index.value(), self.root.get(index)));
        mesh.map(|mesh| (at, mesh))
            .ok_or_else(|| FormatError(format!("nodes[{node}] refers to meshes[{at}], which does not exist")))
    }

    /// Returns the indices of the requested primitives of a node's mesh.
    fn numbers(&self, node: u32, primitive: Option<u32>) -> Result<Range<usize>, FormatError> {
        let count = self.mesh_of(node)?.1.primitives.len();
        match primitive {
            None => Ok(0..count),
            Some(number) if (number as usize) < count => Ok(number as usize..number as usize + 1),
            Some(number) => {
                Err(FormatError(format!("nodes[{node}] has no primitive {number}; it has {count}, counted from 0")))
            }
        }
    }

    /// Counts the triangles of the primitives before any are read, and fails if they are too many.
    fn count_triangles(&self, primitives: &[(&Primitive, DAffine3, String)]) -> Result<u64, FormatError> {
        let mut known: BTreeMap<usize, u64> = BTreeMap::new();
        let mut count = |index: Index<Accessor>, of: Type, name: &str| {
            if let Some(count) = known.get(&index.value()) {
                return Ok(*count);
            }
            let count = self.elements(index, &[of], name)?.count as u64;
            known.insert(index.value(), count);
            Ok(count)
        };
        let (mut vertices, mut corners, mut triangles) = (0_u64, 0_u64, 0_u64);
        for (primitive, _, of) in primitives {
            let Some(positions) = primitive.attributes.get(&Valid(Semantic::Positions)) else { continue };
            let own = count(*positions, Type::Vec3, &format!("{of}.attributes.POSITION"))?;
            vertices = vertices.saturating_add(own);
            let indices = primitive.indices.map(|index| count(index, Type::Scalar, &format!("{of}.indices")));
            let own = indices.transpose()?.unwrap_or(own);
            corners = corners.saturating_add(own);
            triangles = triangles.saturating_add(triangles_of(mode(primitive, of)?, own));
        }
        for (all, what) in [(vertices, "vertices"), (corners, "triangle corners")] {
            if all > MOST {
                let problem = "counting each instance, and the limit is";
                return Err(FormatError(format!(
                    "the file has {all} {what}, {problem} {MOST}; use one object per node, as `bentray import` does, \
                     or several files"
                )));
            }
        }
        Ok(triangles)
    }

    fn primitive(&self, raw: &mut Raw, primitive: &Primitive, world: DAffine3, of: &str) -> Result<(), FormatError> {
        let mode = mode(primitive, of)?;
        let left_out = match mode {
            Mode::Points => Some("point primitives"),
            Mode::Lines | Mode::LineLoop | Mode::LineStrip => Some("line primitives"),
            Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan => None,
        };
        if let Some(kind) = left_out {
            raw.leave_out(kind, 1);
            return Ok(());
        }
        let given = |semantic| primitive.attributes.get(&Valid(semantic)).copied();
        let named = |attribute: &str| format!("{of}.attributes.{attribute}");
        let positions = given(Semantic::Positions).ok_or_else(|| FormatError(format!("{of} has no POSITION")))?;
        let positions = self.elements(positions, &[Type::Vec3], &named("POSITION"))?;
        let count = positions.count;
        let base = raw.positions.len();
        for i in 0..count {
            let position = world.transform_point3(Vec3::from(positions.numbers(i)).as_dvec3());
            if !position.to_array().into_iter().all(usable) {
                return Err(FormatError(format!(
                    "{of}: vertex {i} is at {position}; numbers must be finite, up to 1e30 in magnitude"
                )));
            }
            raw.positions.push(position);
        }
        let normals = given(Semantic::Normals).map(|index| self.elements(index, &[Type::Vec3], &named("NORMAL")));
        let normals = same_count(normals.transpose()?, count, &named("NORMAL"))?;
        let first_normal = raw.normals.len() as u32;
        if let Some(normals) = &normals {
            let turn = covectors(world);
            let placed = |i| turn(Vec3::from(normals.numbers(i)).as_dvec3()).as_vec3();
            raw.normals.extend((0..count).map(placed));
        }
        let (set, transform) = self.texture(primitive);
        let uvs = given(Semantic::TexCoords(set)).map(|index| self.elements(index, &[Type::Vec2], &named("TEXCOORD")));
        let uvs = same_count(uvs.transpose()?, count, &named("TEXCOORD"))?;
        let first_uv = raw.uvs.len() as u32;
        for i in 0..uvs.as_ref().map_or(0, |uvs| uvs.count) {
            let uv = transform(uvs.as_ref().map_or(Vec2::ZERO, |uvs| Vec2::from(uvs.numbers(i))));
            raw.uvs.push(if uv.to_array().into_iter().all(usable) { uv } else { Vec2::ZERO });
        }
        if let Some(index) = given(Semantic::Colors(0)) {
            self.colors(raw, index, base, &named("COLOR_0")).unwrap_or_else(|flaw| raw.colors.reject(flaw.0));
        }
        let corner = |i: u32| {
            Corner::new(
                base as u32 + i,
                uvs.is_some().then_some(first_uv + i),
                normals.is_some().then_some(first_normal + i),
            )
        };
        let is_mirrored = world.matrix3.determinant() < 0.0;
        self.triangles(primitive, mode, count, of, |[a, b, c]| {
            let [b, c] = if is_mirrored { [c, b] } else { [b, c] };
            raw.face(&[a, b, c].map(corner));
        })
    }

    /// Passes the triangles of a primitive with this number of vertices to `take`.
    fn triangles(
        &self,
        primitive: &Primitive,
        mode: Mode,
        vertices: usize,
        of: &str,
        mut take: impl FnMut([u32; 3]),
    ) -> Result<(), FormatError> {
        let indices = primitive.indices.map(|index| self.elements(index, &[Type::Scalar], &format!("{of}.indices")));
        let indices = indices.transpose()?;
        let count = indices.as_ref().map_or(vertices, |indices| indices.count);
        let at = |i: usize| match &indices {
            None => Ok(i as u32),
            Some(indices) => match indices.index(i) {
                index if (index as usize) < vertices => Ok(index),
                index => Err(FormatError(format!(
                    "{of}: index {i} is {index}, and there are {vertices} vertices, counted from 0"
                ))),
            },
        };
        for i in 0..triangles_of(mode, count as u64) as usize {
            let corners = match mode {
                Mode::TriangleStrip => [i, i + 1 + i % 2, i + 2 - i % 2],
                Mode::TriangleFan => [i + 1, i + 2, 0],
                _ => [3 * i, 3 * i + 1, 3 * i + 2],
            };
            take([at(corners[0])?, at(corners[1])?, at(corners[2])?]);
        }
        Ok(())
    }

    /// Returns the index of the texture coordinates that the color of a primitive's material uses, and their transformation.
    fn texture(&self, primitive: &Primitive) -> (u32, impl Fn(Vec2) -> Vec2 + use<>) {
        let material = primitive.material.and_then(|index| self.root.get(index));
        let info: Option<&Info> = material.and_then(|material| {
            material.pbr_metallic_roughness.base_color_texture.as_ref().or(material.emissive_texture.as_ref())
        });
        let moved = info.and_then(|info| info.extensions.as_ref()?.texture_transform.as_ref());
        let set = moved.and_then(|moved| moved.tex_coord).or(info.map(|info| info.tex_coord)).unwrap_or(0);
        let (offset, turn, scale) = moved.map_or((Vec2::ZERO, 0.0, Vec2::ONE), |moved| {
            (Vec2::from(moved.offset.0), moved.rotation.0, Vec2::from(moved.scale.0))
        });
        // With v counted from below, positive angles turn the other way.
        let turn = Mat2::from_angle(-turn);
        (set, move |uv| {
            let uv = offset + turn * (scale * uv);
            Vec2::new(uv.x, 1.0 - uv.y)
        })
    }
}

/// Checks that an attribute has as many elements as there are vertices.
fn same_count<'a>(elements: Option<Elements<'a>>, count: usize, of: &str) -> Result<Option<Elements<'a>>, FormatError> {
    match elements {
        Some(elements) if elements.count != count => {
            Err(FormatError(format!("{of} has {} elements, and there are {count} vertices", elements.count)))
        }
        elements => Ok(elements),
    }
}

/// Returns the number of triangles that this many corners make.
fn triangles_of(mode: Mode, corners: u64) -> u64 {
    match mode {
        Mode::Triangles => corners / 3,
        Mode::TriangleStrip | Mode::TriangleFan => corners.saturating_sub(2),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => 0,
    }
}

/// Returns the mode of a primitive, which defines how its vertices form triangles.
fn mode(primitive: &Primitive, of: &str) -> Result<Mode, FormatError> {
    match &primitive.mode {
        Valid(mode) => Ok(*mode),
        Invalid => Err(FormatError(format!("{of} has an invalid `mode`"))),
    }
}

/// Returns the transformation of normals under this map of points; they stay perpendicular to the surface and on its side.
fn covectors(map: DAffine3) -> impl Fn(DVec3) -> DVec3 {
    let [x, y, z] = [map.matrix3.x_axis, map.matrix3.y_axis, map.matrix3.z_axis];
    let side = map.matrix3.determinant().signum();
    move |n| side * (n.x * y.cross(z) + n.y * z.cross(x) + n.z * x.cross(y))
}

/// Returns `true` if a mesh may be stored in object space and instanced through this map: the map neither mirrors nor flattens it,
/// and 32 bits suffice for its positions.
fn may_be_mapped(world: DAffine3) -> bool {
    const LENGTHS: RangeInclusive<f64> = 1e-6..=1e6;
    let [x, y, z] = [world.matrix3.x_axis, world.matrix3.y_axis, world.matrix3.z_axis];
    let lengths = [x, y, z].map(DVec3::length);
    let volume = world.matrix3.determinant();
    lengths.iter().all(|length| LENGTHS.contains(length))
        && volume > 1e-3 * lengths.iter().product::<f64>()
        && world.translation.abs().max_element() <= 1e20
}
