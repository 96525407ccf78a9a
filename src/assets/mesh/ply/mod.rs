//! PLY: a header that describes the following data, in text or binary form.
//!
//! *Theory.* The header names elements, their numbers, and their properties, each a number or a list. A mesh consists of
//! vertices with `x`, `y` and `z`, perhaps `nx`, `ny` and `nz`, perhaps `s` and `t` or `u` and `v`, perhaps `red`, `green` and
//! `blue`; and of faces with a list of vertices, perhaps with a list of texture coordinates, or triangle strips, as a list of
//! vertices separated by −1. All other elements are read and counted, so that the user learns that they are not drawn.
//!
//! *Practice.* Text and binary files share the reading of elements and differ in the source of numbers. A count is trusted only if at least
//! the bytes that it requires follow.

mod header;
mod source;

use std::path::Path;

use glam::{DVec3, Vec2};

use super::bytes::usable;
use super::raw::{Corner, MOST_CORNERS, Raw, too_many};
use super::text::Diagnostics;
use super::{Format, Read, Reading};
use crate::document::{SceneError, lenient_text};
use header::{CORNERS, Element, Encoding, Header, Property};
use source::{Binary, NumberSource, Words, Wrong};

pub(super) const FORMAT: Format = Format { extensions: &["ply"], read: Read::Whole(read) };

fn read(bytes: &[u8], path: &Path, reading: Reading) -> Result<Raw, SceneError> {
    let header = header::read(bytes, path)?;
    let faces = header.elements.iter().filter(|element| element.name == "face").map(|element| element.count).sum();
    let check = |triangles: u64| reading.capacity.check(triangles).map_err(|flaw| flaw.of(path));
    check(faces)?;
    let mut mesh = Assembled::default();
    match header.encoding {
        Encoding::Ascii => {
            let whole = lenient_text(bytes, path)?;
            // Invalid bytes make the decoded text longer, so the length of the header is measured in the text.
            let front = lenient_text(&bytes[..header.length], path)?.len();
            let mut words = Words::of(&whole[front..], reading.stage);
            if let Err(Wrong { problem, help }) = mesh.elements(&header, &mut words) {
                let mut mistakes = Diagnostics::of(&whole, path);
                mistakes.add((words.last(), problem, help));
                return Err(mistakes.error());
            }
        }
        Encoding::Little | Encoding::Big => {
            let mut source = Binary::of(bytes, header.length, header.encoding == Encoding::Big, reading.stage);
            mesh.elements(&header, &mut source).map_err(|wrong| source.flaw(&wrong).of(path))?;
        }
    }
    check(mesh.sizes.len() as u64)?;
    mesh.raw(path, check)
}

/// The names of a color's components.
const COLOR: [&[&str]; 3] =
    [&["red", "r", "diffuse_red"], &["green", "g", "diffuse_green"], &["blue", "b", "diffuse_blue"]];

/// The data of the elements that matter.
#[derive(Default)]
struct Assembled {
    raw: Raw,
    /// The vertices of all faces, one face after the other, and the number of vertices of each face.
    indices: Vec<u32>,
    sizes: Vec<u32>,
    /// The texture coordinates of faces that have their own: one per vertex of the face, or none.
    corner_uvs: Vec<Vec2>,
    faces_uvs: Vec<bool>,
    has_face_colors: bool,
}

impl Assembled {
    fn elements(&mut self, header: &Header, source: &mut impl NumberSource) -> Result<(), Wrong> {
        for element in &header.elements {
            source.has(element)?;
            match element.name.as_str() {
                "vertex" => self.vertices(element, source)?,
                "face" => self.faces(element, header.vertices, source)?,
                "tristrips" => self.strips(element, header.vertices, source)?,
                _ => {
                    self.raw.leave_out(&format!("elements `{}`", element.name), element.count);
                    for _ in 0..element.count {
                        source.begin(element)?;
                        for property in &element.properties {
                            list(property, source, |_| Ok(()))?;
                        }
                    }
                }
            }
        }
        source.end()
    }

    fn vertices(&mut self, element: &Element, source: &mut impl NumberSource) -> Result<(), Wrong> {
        let place = |names: &[&str]| element.properties.iter().position(|p| names.contains(&p.name.as_str()));
        let places = [
            place(&["x"]),
            place(&["y"]),
            place(&["z"]),
            place(&["nx"]),
            place(&["ny"]),
            place(&["nz"]),
            place(&["s", "u", "texture_u", "texture_s"]),
            place(&["t", "v", "texture_v", "texture_t"]),
            place(COLOR[0]),
            place(COLOR[1]),
            place(COLOR[2]),
        ];
        let has = |range: std::ops::Range<usize>| places[range].iter().all(Option::is_some);
        let (normals, uvs, colors) = (has(3..6), has(6..8), has(8..11));
        let white = [8, 9, 10].map(|slot| places[slot].map_or(1.0, |i| header::white(element.properties[i].kind)));
        for _ in 0..element.count {
            source.begin(element)?;
            let mut values = [0.0; 11];
            for (i, property) in element.properties.iter().enumerate() {
                let slot = places.iter().position(|place| *place == Some(i));
                list(property, source, |value| {
                    let Some(slot) = slot else { return Ok(()) };
                    values[slot] = value;
                    // Invalid normals are generated again, and colors may not be used.
                    let may_be_odd = (3..6).contains(&slot) || slot >= 8;
                    if usable(values[slot]) || may_be_odd { Ok(()) } else { Err(no_number(value)) }
                })?;
            }
            self.raw.positions.push(DVec3::from_slice(&values));
            if normals {
                self.raw.normals.push(DVec3::from_slice(&values[3..]).as_vec3());
            }
            if uvs {
                self.raw.uvs.push(Vec2::new(values[6] as f32, values[7] as f32));
            }
            if colors {
                let color = [0, 1, 2].map(|k| values[8 + k] / white[k]);
                self.raw.colors.set_srgb(self.raw.positions.len() - 1, color);
            }
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element, vertices: u64, source: &mut impl NumberSource) -> Result<(), Wrong> {
        let has = |names: &&[&str]| element.properties.iter().any(|p| names.contains(&p.name.as_str()));
        self.has_face_colors = COLOR.iter().all(has);
        for _ in 0..element.count {
            source.begin(element)?;
            let (before, mut own) = (self.indices.len(), Vec::new());
            for property in &element.properties {
                match property.name.as_str() {
                    name if CORNERS.contains(&name) && property.length.is_some() => {
                        list(property, source, |value| {
                            self.indices.push(vertex(value, vertices)?);
                            Ok(())
                        })?;
                    }
                    "texcoord" if property.length.is_some() => list(property, source, |value| {
                        own.push(value as f32);
                        if usable(value as f32) { Ok(()) } else { Err(no_number(value)) }
                    })?,
                    _ => list(property, source, |_| Ok(()))?,
                }
            }
            let size = self.indices.len() - before;
            if size > MOST_CORNERS {
                let (problem, help) = too_many(size);
                return Err(Wrong { problem, help });
            }
            self.sizes.push(size as u32);
            let has_own = !own.is_empty() && own.len() == 2 * size;
            self.faces_uvs.push(has_own);
            if has_own {
                self.corner_uvs.extend(own.chunks_exact(2).map(|uv| Vec2::new(uv[0], uv[1])));
            }
        }
        Ok(())
    }

    /// Reads triangle strips: each index after the first two of a strip makes
    /// a triangle with the two before it; every second one is reversed.
    fn strips(&mut self, element: &Element, vertices: u64, source: &mut impl NumberSource) -> Result<(), Wrong> {
        // The separator of two strips; if indices are unsigned, it is the largest number.
        let ends = |value: f64| [-1.0, f64::from(u32::MAX)].contains(&value);
        for _ in 0..element.count {
            source.begin(element)?;
            for property in &element.properties {
                if !CORNERS.contains(&property.name.as_str()) || property.length.is_none() {
                    list(property, source, |_| Ok(()))?;
                    continue;
                }
                let (mut before, mut count) = ([0; 2], 0);
                list(property, source, |value| {
                    if ends(value) {
                        count = 0;
                        return Ok(());
                    }
                    let (index, [a, b]) = (vertex(value, vertices)?, before);
                    if count >= 2 {
                        self.indices.extend(if count % 2 == 0 { [a, b, index] } else { [b, a, index] });
                        self.sizes.push(3);
                        self.faces_uvs.push(false);
                    }
                    (before, count) = ([b, index], count + 1);
                    Ok(())
                })?;
            }
        }
        Ok(())
    }

    fn raw(self, path: &Path, check: impl Fn(u64) -> Result<(), SceneError>) -> Result<Raw, SceneError> {
        let Self { mut raw, indices, sizes, corner_uvs, faces_uvs, has_face_colors } = self;
        if has_face_colors && !raw.colors.are_there() {
            raw.colors.reject("the file has colors for faces, not for vertices".to_owned());
        }
        let (has_normals, has_uvs) = (!raw.normals.is_empty(), !raw.uvs.is_empty());
        // The texture coordinates of faces follow the coordinates of vertices.
        let mut next_uv = raw.uvs.len() as u32;
        raw.uvs.extend(corner_uvs);
        let (mut rest, mut corners) = (&indices[..], Vec::new());
        for (size, own) in sizes.iter().zip(faces_uvs) {
            let (face, after) = rest.split_at(*size as usize);
            rest = after;
            corners.clear();
            corners.extend(face.iter().zip(0..).map(|(&i, k)| {
                let uv = if own { Some(next_uv + k) } else { has_uvs.then_some(i) };
                Corner::new(i, uv, has_normals.then_some(i))
            }));
            next_uv += if own { *size } else { 0 };
            if corners.len() > 2 {
                raw.face(&corners);
                check(raw.triangles().len() as u64)?;
            }
        }
        if raw.is_empty() {
            return Err(SceneError::Mesh { path: path.to_owned(), problem: raw.nothing() });
        }
        Ok(raw)
    }
}

/// Returns the vertex with this index.
fn vertex(index: f64, vertices: u64) -> Result<u32, Wrong> {
    if index < 0.0 || index >= vertices as f64 || index.fract() != 0.0 {
        let problem = format!("vertex `{index}` does not exist");
        return Err(Wrong { problem, help: format!("the file has {vertices} vertices, counted from 0") });
    }
    Ok(index as u32)
}

fn no_number(value: f64) -> Wrong {
    Wrong {
        problem: format!("expected a number, found `{value}`"),
        help: "numbers must be finite, up to 1e30 in magnitude".to_owned(),
    }
}

/// Reads a property: a number, or all items of a list.
fn list(
    property: &Property,
    source: &mut impl NumberSource,
    mut take: impl FnMut(f64) -> Result<(), Wrong>,
) -> Result<(), Wrong> {
    let count = match property.length {
        None => 1,
        Some(length) => source.length(length, property)?,
    };
    for _ in 0..count {
        take(source.number(property.kind)?)?;
    }
    Ok(())
}
