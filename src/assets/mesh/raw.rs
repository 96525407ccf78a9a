//! The raw mesh of a file: faces by their corners, triangulated, without generated normals.
//!
//! *Theory.* A face may be any simple polygon; concave faces are triangulated by ear clipping in the plane of Newell's normal.
//!
//! Positions are stored in 64 bits, as in the file: a map of a country has coordinates of millions, and details of
//! millimeters. They are rounded to 32 bits when a mesh is made of them, around a local origin if the file's origin is far away.
//!
//! *Practice.* A triangle stores the face that it was cut from: it has the face's normal, and its corner angles add up to the face's.

use std::collections::BTreeMap;

use earcut::Earcut;
use glam::{DVec2, DVec3, Vec2, Vec3};

use super::colors::Colors;

/// Faces, cut to triangles.
#[derive(Default)]
pub(in crate::assets) struct Raw {
    pub(super) positions: Vec<DVec3>,
    pub(super) uvs: Vec<Vec2>,
    pub(super) normals: Vec<Vec3>,
    pub(super) colors: Colors,
    /// The elements of the file that are not drawn, with the number of each kind.
    left_out: BTreeMap<String, u64>,
    triangles: Vec<Triangle>,
    /// The unit normals of the faces from which triangles were cut.
    faces: Vec<DVec3>,
    earcut: Earcut<f64>,
}

impl std::fmt::Debug for Raw {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} triangles", self.triangles.len())
    }
}

/// A triangle, with the index of its face.
#[derive(Clone, Copy)]
pub(super) struct Triangle {
    pub corners: [Corner; 3],
    pub face: u32,
}

/// A corner of a face: indices into the file's positions, texture coordinates and normals.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub position: u32,
    pub uv: u32,
    normal: u32,
}

/// The largest number of corners of a face; triangulation may take as many steps as there are pairs of corners.
pub(super) const MOST_CORNERS: usize = 10_000;

/// Returns the problem of a face with this number of corners, and the remedy.
pub(super) fn too_many(corners: usize) -> (String, String) {
    (format!("a face has {corners} corners"), format!("at most {MOST_CORNERS} are supported: use smaller faces"))
}

/// The index for values that the file does not have.
const NONE: u32 = u32::MAX;

impl Corner {
    /// Creates a corner; the indices must be valid.
    pub fn new(position: u32, uv: Option<u32>, normal: Option<u32>) -> Self {
        Self { position, uv: uv.unwrap_or(NONE), normal: normal.unwrap_or(NONE) }
    }
}

impl Raw {
    /// Returns `true` if there are no triangles.
    pub(super) fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    pub(super) fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Returns the unit normal of a triangle's face.
    pub(super) fn face_normal(&self, triangle: &Triangle) -> DVec3 {
        self.faces[triangle.face as usize]
    }

    /// Returns the normal of a corner in the file, if it has one.
    pub(super) fn given_normal(&self, corner: Corner) -> Option<Vec3> {
        self.normals.get(corner.normal as usize)?.try_normalize()
    }

    /// Counts elements of the file that are not drawn, such as `lines`.
    pub(super) fn leave_out(&mut self, kind: &str, count: u64) {
        if count > 0 {
            *self.left_out.entry(kind.to_owned()).or_default() += count;
        }
    }

    /// Returns the elements of the file that are not drawn, each kind with its number.
    pub(super) fn left_out(&self) -> Vec<String> {
        self.left_out.iter().map(|(kind, count)| format!("{kind} ({count})")).collect()
    }

    /// Returns the error message for a file that has nothing to draw.
    pub(super) fn nothing(&self) -> String {
        let has = match &self.left_out()[..] {
            [] => String::new(),
            kinds => format!("; it has {}", kinds.join(", ")),
        };
        format!("the mesh has no triangles with an area{has}")
    }

    /// Returns the origin around which positions are rounded to 32 bits: the file's origin along each axis on which it is nearer
    /// than the mesh is large, and the middle of the triangles along the others.
    pub(super) fn origin(&self) -> DVec3 {
        let corners = self.triangles.iter().flat_map(|triangle| triangle.corners);
        let points = corners.map(|corner| self.positions[corner.position as usize]);
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (lo, hi) = points.fold(nothing, |(lo, hi), x| (lo.min(x), hi.max(x)));
        let size = (hi - lo).max_element();
        let is_far = lo.max(-hi).cmpge(DVec3::splat(size));
        // The origin is a 32-bit number, so 32-bit positions stay exact: two numbers within a factor of two have an exact difference.
        DVec3::select(is_far, lo.midpoint(hi).as_vec3().as_dvec3(), DVec3::ZERO)
    }

    /// Adds a face of three or more corners. A face without area is dropped.
    pub(super) fn face(&mut self, corners: &[Corner]) {
        let point = |corner: &Corner| self.positions[corner.position as usize];
        let face = self.faces.len() as u32;
        if let [a, b, c] = corners {
            let (p, q, r) = (point(a), point(b), point(c));
            if let Some(normal) = (q - p).cross(r - p).try_normalize() {
                self.faces.push(normal);
                self.triangles.push(Triangle { corners: [*a, *b, *c], face });
            }
            return;
        }
        let points: Vec<DVec3> = corners.iter().map(point).collect();
        let Some(normal) = newell(&points) else {
            return;
        };
        self.faces.push(normal);
        for cut in self.cut(&points, normal) {
            let [a, b, c] = cut.map(|i| points[i]);
            if (b - a).cross(c - a) != DVec3::ZERO {
                self.triangles.push(Triangle { corners: cut.map(|i| corners[i]), face });
            }
        }
    }

    /// Triangulates a polygon, and returns the triangles as indices of its points, counter-clockwise around `normal`.
    fn cut(&mut self, points: &[DVec3], normal: DVec3) -> Vec<[usize; 3]> {
        // A projection along the axis nearest the normal keeps the polygon simple, and its sense of rotation.
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
}

/// Returns a polygon's unit normal, from the areas of its projections on the three planes; `None` if it has no area.
fn newell(points: &[DVec3]) -> Option<DVec3> {
    let origin = points[0];
    let next = points.iter().cycle().skip(1);
    let crosses = points.iter().zip(next).map(|(a, b)| (*a - origin).cross(*b - origin));
    crosses.sum::<DVec3>().try_normalize()
}
