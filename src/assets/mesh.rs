//! Meshes: OBJ files as triangles with positions, normals and texture coordinates.
//!
//! *Theory.* Four statements matter: `v`, `vt`, `vn` and `f`; all others (groups, materials, lines, points, smoothing)
//! are passed over. A face may be any simple polygon; concave ones are cut by ears in the plane of Newell's normal.
//!
//! *Practice.* Every statement is read with its line, so that each mistake has its place. A corner without a normal
//! takes the face's, so nothing is smoothed that the file does not smooth. Triangles without area are dropped.
//! Equal corners share a vertex.

use crate::document::{Mistake, SceneError};
use earcut::Earcut;
use glam::{DVec2, DVec3, Vec2, Vec3};
use std::collections::HashMap;
use std::path::Path;

/// Triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Corners, each used by at least one triangle, or by one that had no area.
    pub vertices: Vec<Vertex>,
    /// Indices into the vertices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// A corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// In the mesh's own space.
    pub position: Vec3,
    /// Unit vector.
    pub normal: Vec3,
    /// Texture coordinates; (0, 0) if the file has none.
    pub uv: Vec2,
}

/// A file with this many mistakes is read no further.
const ENOUGH: usize = 10;

/// What has been read of a file.
#[derive(Default)]
struct Loader {
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    vertices: Vec<Vertex>,
    index_of: HashMap<[u32; 8], u32>,
    triangles: Vec<[u32; 3]>,
    earcut: Earcut<f64>,
}

/// One corner of a face as the file gives it: indices of its position, texture coordinates and normal.
type Corner = (usize, Option<usize>, Option<usize>);

/// What is wrong with a word of a statement, and what would be right.
type Wrong<'a> = (&'a str, String, String);

impl Mesh {
    /// Reads an OBJ file.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let bytes = std::fs::read(path).map_err(|source| SceneError::Read { path: path.to_owned(), source })?;
        // Names and comments may be in any encoding; they do not matter here.
        Self::parse(&String::from_utf8_lossy(&bytes), path)
    }

    /// The middle of an edge at which the surface is open, if it is: closed surfaces have every edge twice, once in each
    /// direction. Corners are the same where their positions are.
    #[must_use]
    pub fn hole(&self) -> Option<[f32; 3]> {
        let corner = |i: u32| self.vertices[i as usize].position;
        let edges = || {
            let sides = |&[a, b, c]: &[u32; 3]| [(a, b), (b, c), (c, a)].map(|(a, b)| [corner(a), corner(b)]);
            self.triangles.iter().flat_map(sides)
        };
        // 0 and −0 are one place.
        let key = |ends: [Vec3; 2]| ends.map(|p| (p + Vec3::ZERO).to_array().map(f32::to_bits));
        let mut balance: HashMap<_, i32> = HashMap::new();
        for [a, b] in edges() {
            *balance.entry(key([a, b])).or_default() += 1;
            *balance.entry(key([b, a])).or_default() -= 1;
        }
        edges().find(|ends| balance[&key(*ends)] != 0).map(|[a, b]| ((a + b) / 2.0).to_array())
    }

    /// Reads the text of an OBJ file; `path` names it in mistakes.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        let mut loader = Loader::default();
        let mut mistakes = Vec::new();
        for statement in statements(text) {
            let words = statement.split(|c: char| c.is_whitespace() || c == '\\');
            let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
            if let Err((word, problem, help)) = loader.statement(&words) {
                // A word is a part of the text, so the distance of their addresses is its place there.
                let start = word.as_ptr() as usize - text.as_ptr() as usize;
                let (file, end) = (path.to_owned(), start + word.len());
                mistakes.push(Mistake::locate(file, text, start, end, problem, help));
            }
            if mistakes.len() == ENOUGH {
                break;
            }
        }
        if mistakes.is_empty() && loader.triangles.is_empty() {
            let problem = "the mesh has no triangles with an area".to_owned();
            let help = "faces are lines such as `f 1 2 3`".to_owned();
            mistakes.push(Mistake::locate(path.to_owned(), text, 0, 0, problem, help));
        }
        if !mistakes.is_empty() {
            return Err(SceneError::Mistakes(mistakes));
        }
        Ok(Self { vertices: loader.vertices, triangles: loader.triangles })
    }
}

/// Lines without their comments; a line that ends in a backslash goes on in the next.
fn statements(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let mut end = 0;
        loop {
            let line_end = rest[end..].find('\n').map_or(rest.len(), |i| end + i + 1);
            let line = rest[end..line_end].split('#').next().unwrap_or("");
            let continued = line.trim_end().ends_with('\\');
            end = line_end;
            if !continued || end == rest.len() {
                break;
            }
        }
        let (statement, after) = rest.split_at(end);
        rest = after;
        Some(statement.split('#').next().unwrap_or(""))
    })
}

impl Loader {
    fn statement<'a>(&mut self, words: &[&'a str]) -> Result<(), Wrong<'a>> {
        match words {
            // A wrong line still takes its number, so that the faces below it mean what they meant.
            ["v", ..] => {
                let position = numbers(words);
                self.positions.push(position.as_ref().map_or(Vec3::ZERO, |p| Vec3::from_array(*p)));
                position?;
            }
            ["vn", ..] => {
                let normal = numbers(words);
                self.normals.push(normal.as_ref().map_or(Vec3::ZERO, |n| Vec3::from_array(*n)));
                normal?;
            }
            // A texture may have one coordinate only.
            ["vt", _] => {
                let u = numbers::<1>(words);
                self.uvs.push(u.as_ref().map_or(Vec2::ZERO, |u| Vec2::new(u[0], 0.0)));
                u?;
            }
            ["vt", ..] => {
                let uv = numbers(words);
                self.uvs.push(uv.as_ref().map_or(Vec2::ZERO, |uv| Vec2::from_array(*uv)));
                uv?;
            }
            ["f", corners @ ..] => {
                let corners = corners.iter().map(|word| self.corner(word));
                let corners = corners.collect::<Result<Vec<Corner>, _>>()?;
                // Some programs write points and lines as faces.
                if corners.len() > 2 {
                    self.face(&corners);
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// `position/texture/normal`, the last two optional; from 1, or back from the last given so far.
    fn corner<'a>(&self, word: &'a str) -> Result<Corner, Wrong<'a>> {
        let index = |text: &str, count: usize, what: &str| -> Result<Option<usize>, Wrong<'a>> {
            if text.is_empty() {
                return Ok(None);
            }
            let index = match text.parse::<i64>() {
                Ok(i) if i < 0 => count.checked_sub(i.unsigned_abs() as usize),
                Ok(i) => usize::try_from(i - 1).ok(),
                Err(_) => None,
            };
            match index.filter(|i| *i < count) {
                Some(index) => Ok(Some(index)),
                None => Err((
                    word,
                    format!("there is no {what} `{text}`"),
                    format!("{count} stand above this line, counted from 1"),
                )),
            }
        };
        let mut parts = word.split('/');
        let mut next = || parts.next().unwrap_or("");
        let position = index(next(), self.positions.len(), "vertex")?;
        let uv = index(next(), self.uvs.len(), "texture coordinate")?;
        let normal = index(next(), self.normals.len(), "normal")?;
        let missing = || (word, "a corner needs a vertex".to_owned(), String::new());
        Ok((position.ok_or_else(missing)?, uv, normal))
    }

    fn face(&mut self, corners: &[Corner]) {
        let points = corners.iter().map(|c| self.positions[c.0].as_dvec3());
        let points: Vec<DVec3> = points.collect();
        let Some(normal) = newell(&points) else {
            return;
        };
        let indices = corners.iter().map(|c| self.vertex(*c, normal.as_vec3()));
        let indices: Vec<u32> = indices.collect();
        for [a, b, c] in self.cut(&points, normal) {
            if (points[b] - points[a]).cross(points[c] - points[a]) != DVec3::ZERO {
                self.triangles.push([indices[a], indices[b], indices[c]]);
            }
        }
    }

    /// The triangles of a polygon as indices of its points, counter-clockwise about `normal`.
    fn cut(&mut self, points: &[DVec3], normal: DVec3) -> Vec<[usize; 3]> {
        if points.len() == 3 {
            return vec![[0, 1, 2]];
        }
        // Seen along the axis nearest the normal: that keeps the polygon simple and its sense of rotation.
        let axis = normal.abs().max_position();
        let (mut right, mut up) = ((axis + 1) % 3, (axis + 2) % 3);
        if normal[axis] < 0.0 {
            (right, up) = (up, right);
        }
        let flat = points.iter().map(|p| DVec2::new(p[right], p[up]));
        let flat: Vec<DVec2> = flat.collect();
        let mut cut: Vec<usize> = Vec::new();
        self.earcut.earcut(flat.iter().map(DVec2::to_array), &[], &mut cut);
        let turned = |t: &[usize]| {
            let [a, b, c] = [t[0], t[1], t[2]];
            if (flat[b] - flat[a]).perp_dot(flat[c] - flat[a]) < 0.0 { [a, c, b] } else { [a, b, c] }
        };
        cut.chunks_exact(3).map(turned).collect()
    }

    /// The index of a vertex such as this, perhaps one that is already there.
    fn vertex(&mut self, (position, uv, normal): Corner, face_normal: Vec3) -> u32 {
        let normal = normal.and_then(|i| self.normals[i].try_normalize());
        let vertex = Vertex {
            position: self.positions[position],
            normal: normal.unwrap_or(face_normal),
            uv: uv.map_or(Vec2::ZERO, |i| self.uvs[i]),
        };
        let [x, y, z] = vertex.position.to_array();
        let [nx, ny, nz] = vertex.normal.to_array();
        let key = [x, y, z, nx, ny, nz, vertex.uv.x, vertex.uv.y].map(f32::to_bits);
        *self.index_of.entry(key).or_insert_with(|| {
            self.vertices.push(vertex);
            self.vertices.len() as u32 - 1
        })
    }
}

/// `N` numbers after a keyword; more are passed over (weights, vertex colours).
fn numbers<'a, const N: usize>(words: &[&'a str]) -> Result<[f32; N], Wrong<'a>> {
    let mut values = [0.0; N];
    for (i, value) in values.iter_mut().enumerate() {
        let Some(word) = words.get(i + 1) else {
            let problem = format!("`{}` needs {N} numbers, found {i}", words[0]);
            return Err((words[0], problem, String::new()));
        };
        match word.parse::<f32>() {
            // Beyond 1e30 squares of lengths overflow.
            Ok(number) if number.abs() <= 1e30 => *value = number,
            _ => {
                let problem = format!("expected a number, found `{word}`");
                return Err((word, problem, "numbers are finite, to 1e30".to_owned()));
            }
        }
    }
    Ok(values)
}

/// A polygon's unit normal, from the areas of its shadows on the three planes; none if it has no area.
fn newell(points: &[DVec3]) -> Option<DVec3> {
    let origin = points[0];
    let next = points.iter().cycle().skip(1);
    let crosses = points.iter().zip(next).map(|(a, b)| (*a - origin).cross(*b - origin));
    crosses.sum::<DVec3>().try_normalize()
}
