//! What a file says of a mesh: faces by their corners, cut to triangles, as yet without the normals that it lacks.
//!
//! *Theory.* A face may be any simple polygon; concave ones are cut by ears in the plane of Newell's normal.
//!
//! Positions are kept in 64 bits, as the file gives them: a map of a country has coordinates of millions, and details of
//! millimeters. They are rounded to 32 bits once a mesh is made of them, about an origin of its own where the file's is far away.
//!
//! *Practice.* A triangle remembers the face that it was cut from: the face's normal is its own, and its corners' angles add up to the
//! face's.

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
    /// Elements of the file that are not drawn, and how many there are of each kind.
    left_out: BTreeMap<String, u64>,
    triangles: Vec<Triangle>,
    /// The unit normals of the faces that triangles were cut from.
    faces: Vec<DVec3>,
    earcut: Earcut<f64>,
}

impl std::fmt::Debug for Raw {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} triangles", self.triangles.len())
    }
}

/// A triangle, and the face that it is of.
#[derive(Clone, Copy)]
pub(super) struct Triangle {
    pub corners: [Corner; 3],
    pub face: u32,
}

/// A corner of a face: indices of what the file gives.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub position: u32,
    pub uv: u32,
    normal: u32,
}

/// Corners that a face may have: cutting it may take as many steps as pairs of them.
pub(super) const MOST_CORNERS: usize = 10_000;

/// What is wrong with a face of so many corners, and what would be right.
pub(super) fn too_many(corners: usize) -> (String, String) {
    (format!("a face of {corners} corners"), format!("at most {MOST_CORNERS} are cut to triangles: use smaller faces"))
}

/// In place of an index: the file gives none.
const NONE: u32 = u32::MAX;

impl Corner {
    /// The indices must be those of what there is.
    pub fn new(position: u32, uv: Option<u32>, normal: Option<u32>) -> Self {
        Self { position, uv: uv.unwrap_or(NONE), normal: normal.unwrap_or(NONE) }
    }
}

impl Raw {
    /// Is there nothing to see?
    pub(super) fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    pub(super) fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// The unit normal of the face that a triangle is of.
    pub(super) fn face_normal(&self, triangle: &Triangle) -> DVec3 {
        self.faces[triangle.face as usize]
    }

    /// The normal that the file gives a corner.
    pub(super) fn given_normal(&self, corner: Corner) -> Option<Vec3> {
        self.normals.get(corner.normal as usize)?.try_normalize()
    }

    /// Counts elements of the file that are not drawn, such as `lines`.
    pub(super) fn leave_out(&mut self, kind: &str, count: u64) {
        if count > 0 {
            *self.left_out.entry(kind.to_owned()).or_default() += count;
        }
    }

    /// The elements of the file that are not drawn, each kind with its number.
    pub(super) fn left_out(&self) -> Vec<String> {
        self.left_out.iter().map(|(kind, count)| format!("{kind} ({count})")).collect()
    }

    /// What is wrong with a file that has nothing to draw.
    pub(super) fn nothing(&self) -> String {
        let has = match &self.left_out()[..] {
            [] => String::new(),
            kinds => format!(": it has {}", kinds.join(", ")),
        };
        format!("the mesh has no triangles with an area{has}")
    }

    /// Returns the origin about which positions are rounded to 32 bits: the file's own along each axis on which it is nearer
    /// than the mesh is large, and the middle of the triangles along the others.
    pub(super) fn origin(&self) -> DVec3 {
        let corners = self.triangles.iter().flat_map(|triangle| triangle.corners);
        let points = corners.map(|corner| self.positions[corner.position as usize]);
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (lo, hi) = points.fold(nothing, |(lo, hi), x| (lo.min(x), hi.max(x)));
        let size = (hi - lo).max_element();
        let is_far = lo.max(-hi).cmpge(DVec3::splat(size));
        // A number of 32 bits, so that positions of 32 bits stay exact: two numbers within a factor of two have an exact difference.
        DVec3::select(is_far, lo.midpoint(hi).as_vec3().as_dvec3(), DVec3::ZERO)
    }

    /// Adds a face of three corners or more. One without area is dropped.
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

    /// The triangles of a polygon as indices of its points, counter-clockwise about `normal`.
    fn cut(&mut self, points: &[DVec3], normal: DVec3) -> Vec<[usize; 3]> {
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
}

/// A polygon's unit normal, from the areas of its shadows on the three planes; none if it has no area.
fn newell(points: &[DVec3]) -> Option<DVec3> {
    let origin = points[0];
    let next = points.iter().cycle().skip(1);
    let crosses = points.iter().zip(next).map(|(a, b)| (*a - origin).cross(*b - origin));
    crosses.sum::<DVec3>().try_normalize()
}
