//! The meshes of glTF: primitives of nodes, each in its place in the file's scene.
//!
//! *Theory.* A primitive is of triangles, a strip or a fan. Its texture coordinates are those that its material's colour uses, moved as
//! `KHR_texture_transform` says, with v counted from below as everywhere here.
//!
//! *Practice.* The bytes and their checks are [`Gltf`]'s. Positions are placed in 64 bits.

use std::collections::BTreeMap;
use std::path::PathBuf;

use glam::{DAffine3, DVec3, Mat2, Vec2, Vec3};
use gltf_json::accessor::Type;
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::texture::Info;
use gltf_json::validation::Checked::{Invalid, Valid};
use gltf_json::{Accessor, Index};

use super::bytes::usable;
use super::raw::{Corner, Raw};
use super::{Format, Mesh, Part, Parts, Read, Wanted};
use crate::assets::flaw::Flaw;
use crate::assets::gltf::{Elements, Gltf, NodeName, Placed};
use crate::document::SceneError;
use crate::document::values::suggest;

pub(super) const FORMAT: Format =
    Format { extensions: &["gltf", "glb"], read: Read::Parts(|bytes, path| Ok(Box::new(Gltf::open(bytes, path)?))) };

/// Vertices that a mesh may have, and corners of triangles: nodes may show the same mesh again and again, and meshes the same numbers.
const MOST: u64 = 1 << 26;

impl Parts for Gltf {
    fn part(&self, part: &Part) -> Result<Raw, SceneError> {
        self.raw(part).map_err(|flaw| flaw.of(self.path()))
    }

    fn others(&self) -> Vec<PathBuf> {
        Self::others(self).collect()
    }
}

impl Gltf {
    /// A part of the file.
    pub fn mesh(&self, wanted: &Wanted) -> Result<Mesh, SceneError> {
        Ok(self.part(&wanted.part)?.mesh(wanted.crease))
    }

    fn raw(&self, part: &Part) -> Result<Raw, Flaw> {
        let all = self.placed()?;
        let with_mesh: Vec<&Placed> = all.iter().filter(|placed| placed.node.mesh.is_some()).collect();
        let chosen = match &part.node {
            None => with_mesh,
            Some(name) => vec![chosen(&with_mesh, name)?],
        };
        let mut primitives = Vec::new();
        for placed in chosen {
            let Some(index) = placed.node.mesh else { continue };
            let of = format!("nodes[{}]", placed.number);
            let mesh = self.root.get(index);
            let mesh = mesh.ok_or_else(|| Flaw(format!("{of}: there is no meshes[{}]", index.value())))?;
            let count = mesh.primitives.len();
            let numbers = match part.primitive {
                None => 0..count,
                Some(number) if (number as usize) < count => number as usize..number as usize + 1,
                Some(number) => {
                    return Err(Flaw(format!("{of} has no primitive {number}; it has {count}, counted from 0")));
                }
            };
            for number in numbers {
                let of = format!("meshes[{}].primitives[{number}]", index.value());
                primitives.push((&mesh.primitives[number], placed.world, of));
            }
        }
        self.are_not_too_many(&primitives)?;
        let mut raw = Raw::default();
        for (primitive, world, of) in primitives {
            self.primitive(&mut raw, primitive, world, &of)?;
        }
        if raw.is_empty() { Err(Flaw("the mesh has no triangles with an area".to_owned())) } else { Ok(raw) }
    }

    /// Counts what they are made of before any of it is read.
    fn are_not_too_many(&self, primitives: &[(&Primitive, DAffine3, String)]) -> Result<(), Flaw> {
        let mut known: BTreeMap<usize, u64> = BTreeMap::new();
        let mut count = |index: Index<Accessor>, of: Type, name: &str| {
            if let Some(count) = known.get(&index.value()) {
                return Ok(*count);
            }
            let count = self.elements(index, &[of], name)?.count as u64;
            known.insert(index.value(), count);
            Ok(count)
        };
        let (mut vertices, mut corners) = (0_u64, 0_u64);
        for (primitive, _, of) in primitives {
            let Some(positions) = primitive.attributes.get(&Valid(Semantic::Positions)) else { continue };
            let own = count(*positions, Type::Vec3, &format!("{of}.attributes.POSITION"))?;
            vertices = vertices.saturating_add(own);
            let indices = primitive.indices.map(|index| count(index, Type::Scalar, &format!("{of}.indices")));
            corners = corners.saturating_add(indices.transpose()?.unwrap_or(own));
        }
        for (all, what) in [(vertices, "vertices"), (corners, "corners of triangles")] {
            if all > MOST {
                let problem = "as often as its nodes and meshes show them, and at most";
                return Err(Flaw(format!(
                    "it is of {all} {what}, {problem} {MOST} are read: make it of several files"
                )));
            }
        }
        Ok(())
    }

    fn primitive(&self, raw: &mut Raw, primitive: &Primitive, world: DAffine3, of: &str) -> Result<(), Flaw> {
        let mode = drawn(primitive, of)?;
        let given = |semantic| primitive.attributes.get(&Valid(semantic)).copied();
        let named = |attribute: &str| format!("{of}.attributes.{attribute}");
        let positions = given(Semantic::Positions).ok_or_else(|| Flaw(format!("{of} has no POSITION")))?;
        let positions = self.elements(positions, &[Type::Vec3], &named("POSITION"))?;
        let count = positions.count;
        let base = raw.positions.len();
        for i in 0..count {
            let position = world.transform_point3(Vec3::from(positions.numbers(i)).as_dvec3()).as_vec3();
            if !position.to_array().into_iter().all(usable) {
                return Err(Flaw(format!("{of}: vertex {i} is at {position}; numbers are finite, to 1e30")));
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

    /// The triangles of a primitive of so many vertices.
    fn triangles(
        &self,
        primitive: &Primitive,
        mode: Mode,
        vertices: usize,
        of: &str,
        mut take: impl FnMut([u32; 3]),
    ) -> Result<(), Flaw> {
        let indices = primitive.indices.map(|index| self.elements(index, &[Type::Scalar], &format!("{of}.indices")));
        let indices = indices.transpose()?;
        let count = indices.as_ref().map_or(vertices, |indices| indices.count);
        let at = |i: usize| match &indices {
            None => Ok(i as u32),
            Some(indices) => match indices.index(i) {
                index if (index as usize) < vertices => Ok(index),
                index => {
                    Err(Flaw(format!("{of}: index {i} is {index}, and there are {vertices} vertices, counted from 0")))
                }
            },
        };
        let triangles = if mode == Mode::Triangles { count / 3 } else { count.saturating_sub(2) };
        for i in 0..triangles {
            let corners = match mode {
                Mode::TriangleStrip => [i, i + 1 + i % 2, i + 2 - i % 2],
                Mode::TriangleFan => [i + 1, i + 2, 0],
                _ => [3 * i, 3 * i + 1, 3 * i + 2],
            };
            take([at(corners[0])?, at(corners[1])?, at(corners[2])?]);
        }
        Ok(())
    }

    /// Which texture coordinates the colour of a primitive's material uses, and what becomes of them.
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
        // Counted from above, positive angles turn the other way.
        let turn = Mat2::from_angle(-turn);
        (set, move |uv| {
            let uv = offset + turn * (scale * uv);
            Vec2::new(uv.x, 1.0 - uv.y)
        })
    }
}

/// All attributes have as many elements as there are vertices.
fn same_count<'a>(elements: Option<Elements<'a>>, count: usize, of: &str) -> Result<Option<Elements<'a>>, Flaw> {
    match elements {
        Some(elements) if elements.count != count => {
            Err(Flaw(format!("{of} has {} elements, and there are {count} vertices", elements.count)))
        }
        elements => Ok(elements),
    }
}

/// What a primitive is made of, if that has an area.
fn drawn(primitive: &Primitive, of: &str) -> Result<Mode, Flaw> {
    match &primitive.mode {
        Valid(mode @ (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan)) => Ok(*mode),
        Valid(mode) => Err(Flaw(format!("{of} is of {mode:?}; triangles, strips and fans are drawn"))),
        Invalid => Err(Flaw(format!("{of} has a `mode` that there is not"))),
    }
}

/// How normals turn where points are mapped so: they stay across the surface, and on its side.
fn covectors(map: DAffine3) -> impl Fn(DVec3) -> DVec3 {
    let [x, y, z] = [map.matrix3.x_axis, map.matrix3.y_axis, map.matrix3.z_axis];
    let side = map.matrix3.determinant().signum();
    move |n| side * (n.x * y.cross(z) + n.y * z.cross(x) + n.z * x.cross(y))
}

/// The one node of this name.
fn chosen<'a, 'b>(all: &[&'b Placed<'a>], name: &NodeName) -> Result<&'b Placed<'a>, Flaw> {
    /// Names that are told.
    const TOLD: usize = 20;
    let is_meant = |placed: &&&Placed| match name {
        NodeName::Name(name) => placed.node.name.as_ref() == Some(name),
        NodeName::Number(number) => placed.number == *number,
    };
    let found: Vec<&Placed> = all.iter().filter(is_meant).copied().collect();
    match (&found[..], name) {
        ([one], _) => Ok(one),
        ([], NodeName::Name(name)) => {
            let names: Vec<&str> = all.iter().filter_map(|placed| placed.node.name.as_deref()).take(TOLD).collect();
            Err(Flaw(format!("there is no node `{name}` with a mesh; {}", suggest(name, &names, "nodes"))))
        }
        ([], NodeName::Number(number)) => {
            Err(Flaw(format!("there is no node {number} with a mesh in the file's scene")))
        }
        (several, _) => {
            let numbers: Vec<String> = several.iter().take(TOLD).map(|placed| placed.number.to_string()).collect();
            Err(Flaw(format!("several nodes have this name; choose by number: {}", numbers.join(", "))))
        }
    }
}
