//! PLY: a header that says what follows, in words or in bytes.
//!
//! *Theory.* The header names elements, how many of each there are, and their properties, each a number or a list. What a mesh is made
//! of are vertices with `x`, `y` and `z`, perhaps `nx`, `ny` and `nz`, perhaps `s` and `t` or `u` and `v`, and faces with a list
//! of vertices, perhaps one of texture coordinates. All else is read and passed over.
//!
//! *Practice.* Words and bytes have one way of reading elements and two sources of numbers. A count is believed only where as many bytes
//! follow as it needs at least.

mod header;
mod source;

use std::path::Path;

use glam::{Vec2, Vec3};

use super::bytes::usable;
use super::raw::{Corner, MOST_CORNERS, Raw, too_many};
use super::text::Mistakes;
use super::{Format, Read};
use crate::document::SceneError;
use crate::progress::Stage;
use header::{Element, Encoding, Header, Property};
use source::{Binary, Source, Words, Wrong};

pub(super) const FORMAT: Format = Format { extensions: &["ply"], read: Read::Whole(read) };

fn read(bytes: &[u8], path: &Path, stage: &Stage) -> Result<Raw, SceneError> {
    let header = header::read(bytes, path)?;
    let mut mesh = Assembled::default();
    match header.encoding {
        Encoding::Ascii => {
            let whole = String::from_utf8_lossy(bytes);
            // Bytes that are no text make the text longer, so its front is measured in it.
            let front = String::from_utf8_lossy(&bytes[..header.length]).len();
            let mut words = Words::of(&whole[front..], stage);
            if let Err(Wrong { problem, help }) = mesh.elements(&header, &mut words) {
                let mut mistakes = Mistakes::of(&whole, path);
                mistakes.add((words.last(), problem, help));
                return Err(mistakes.error());
            }
        }
        Encoding::Little | Encoding::Big => {
            let mut source = Binary::of(bytes, header.length, header.encoding == Encoding::Big, stage);
            mesh.elements(&header, &mut source).map_err(|wrong| source.flaw(&wrong).of(path))?;
        }
    }
    mesh.raw(path)
}

/// What was read of the elements that matter.
#[derive(Default)]
struct Assembled {
    raw: Raw,
    /// The vertices of all faces, one face after the other, and how many each has.
    indices: Vec<u32>,
    sizes: Vec<u32>,
    /// The texture coordinates of faces that have their own, as many as vertices, or none.
    corner_uvs: Vec<Vec2>,
    faces_uvs: Vec<bool>,
}

impl Assembled {
    fn elements(&mut self, header: &Header, source: &mut impl Source) -> Result<(), Wrong> {
        for element in &header.elements {
            source.has(element)?;
            match element.name.as_str() {
                "vertex" => self.vertices(element, source)?,
                "face" => self.faces(element, header.vertices, source)?,
                _ => {
                    for _ in 0..element.count {
                        source.begin(element)?;
                        for property in &element.properties {
                            list(property, source, |_| Ok(()))?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn vertices(&mut self, element: &Element, source: &mut impl Source) -> Result<(), Wrong> {
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
        ];
        let has = |range: std::ops::Range<usize>| places[range].iter().all(Option::is_some);
        let (normals, uvs) = (has(3..6), has(6..8));
        for _ in 0..element.count {
            source.begin(element)?;
            let mut values = [0.0_f32; 8];
            for (i, property) in element.properties.iter().enumerate() {
                let slot = places.iter().position(|place| *place == Some(i));
                list(property, source, |value| {
                    let Some(slot) = slot else { return Ok(()) };
                    values[slot] = value as f32;
                    // Normals that are no numbers are made anew.
                    if usable(values[slot]) || (3..6).contains(&slot) { Ok(()) } else { Err(no_number(value)) }
                })?;
            }
            let [point, normal] = [0, 3].map(|i| Vec3::from_slice(&values[i..]));
            self.raw.positions.push(point);
            if normals {
                self.raw.normals.push(normal);
            }
            if uvs {
                self.raw.uvs.push(Vec2::from_slice(&values[6..]));
            }
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element, vertices: u64, source: &mut impl Source) -> Result<(), Wrong> {
        for _ in 0..element.count {
            source.begin(element)?;
            let (before, mut own) = (self.indices.len(), Vec::new());
            for property in &element.properties {
                match property.name.as_str() {
                    "vertex_indices" | "vertex_index" if property.length.is_some() => {
                        list(property, source, |value| {
                            if value < 0.0 || value >= vertices as f64 || value.fract() != 0.0 {
                                let problem = format!("there is no vertex `{value}`");
                                return Err(Wrong { problem, help: format!("{vertices} vertices, counted from 0") });
                            }
                            self.indices.push(value as u32);
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

    fn raw(self, path: &Path) -> Result<Raw, SceneError> {
        let Self { mut raw, indices, sizes, corner_uvs, faces_uvs } = self;
        let (has_normals, has_uvs) = (!raw.normals.is_empty(), !raw.uvs.is_empty());
        // The texture coordinates of faces stand behind those of vertices.
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
            }
        }
        if raw.is_empty() {
            let problem = "the mesh has no triangles with an area: its faces are lists of `vertex_indices`".to_owned();
            return Err(SceneError::Mesh { path: path.to_owned(), problem });
        }
        Ok(raw)
    }
}

fn no_number(value: f64) -> Wrong {
    Wrong { problem: format!("expected a number, found `{value}`"), help: "numbers are finite, to 1e30".to_owned() }
}

/// Reads a property: a number, or all of a list.
fn list(
    property: &Property,
    source: &mut impl Source,
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
