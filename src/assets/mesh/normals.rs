//! Generation of missing normals: smooth across edges at which faces meet at a small angle, and sharp elsewhere.
//!
//! *Theory.* At a vertex, faces with a common edge whose normals differ by less than the crease angle belong to one group, and so
//! do all faces joined by a chain of such edges. A group's normal is the sum of its faces' normals, each weighted by the face's angle at
//! the vertex (Thürmer and Wüthrich 1998), so the triangulation of a face makes no difference.
//!
//! *Practice.* The sums are in 64 bits. Vertices with equal positions are merged, so files that repeat them for every face are
//! smooth too. At each vertex the edges are sorted, so the whole takes n log n steps for any file.

use glam::{DVec3, Vec3};

use super::edges::welded;
use super::raw::{Raw, Triangle};

/// The number of faces at one edge that are compared with each other; surfaces have two.
const AT_AN_EDGE: usize = 8;

/// Returns the normals of each triangle's corners; empty if the file has them all. Positions are compared after rounding around `origin`.
pub(super) fn made(raw: &Raw, crease: f64, origin: DVec3) -> Vec<[Vec3; 3]> {
    let lacks = |triangle: &Triangle| triangle.corners.iter().any(|corner| raw.given_normal(*corner).is_none());
    if !raw.triangles().iter().any(lacks) {
        return Vec::new();
    }
    let own = raw.triangles().iter().map(|triangle| [raw.face_normal(triangle).as_vec3(); 3]);
    let mut normals: Vec<[Vec3; 3]> = own.collect();
    if crease > 0.0 {
        Smoother::new(raw, crease, origin).smooth(&mut normals);
    }
    normals
}

struct Smoother<'a> {
    raw: &'a Raw,
    /// The cosine of the crease angle.
    least: f64,
    /// For each position the index of the first equal position.
    same: Vec<u32>,
}

/// A corner of a triangle: the indices of the triangle and of the corner.
type At = (u32, u8);

impl<'a> Smoother<'a> {
    fn new(raw: &'a Raw, crease: f64, origin: DVec3) -> Self {
        let same = welded(raw.positions.iter().map(|position| (*position - origin).as_vec3()));
        Self { raw, least: crease.to_radians().cos(), same }
    }

    fn vertex(&self, (triangle, corner): At) -> u32 {
        self.same[self.raw.triangles()[triangle as usize].corners[usize::from(corner % 3)].position as usize]
    }

    fn smooth(&self, normals: &mut [[Vec3; 3]]) {
        let all = || (0..normals.len() as u32).flat_map(|triangle| [0, 1, 2].map(|corner| (triangle, corner)));
        // The corners at each vertex, one vertex after the other.
        let mut ends = vec![0_u32; self.same.len() + 1];
        all().for_each(|at| ends[self.vertex(at) as usize + 1] += 1);
        (1..ends.len()).for_each(|i| ends[i] += ends[i - 1]);
        let mut corners: Vec<At> = vec![(0, 0); 3 * normals.len()];
        for at in all() {
            let next = &mut ends[self.vertex(at) as usize];
            corners[*next as usize] = at;
            *next += 1;
        }
        let mut start = 0;
        let mut groups = Groups::default();
        for end in ends {
            self.at_vertex(&corners[start..end as usize], &mut groups, normals);
            start = end as usize;
        }
    }

    /// Computes the normals of all corners at one vertex.
    fn at_vertex(&self, corners: &[At], groups: &mut Groups, normals: &mut [[Vec3; 3]]) {
        if corners.is_empty() {
            return;
        }
        let face = |at: At| self.raw.face_normal(&self.raw.triangles()[at.0 as usize]);
        groups.begin(corners.len());
        let mut edges = std::mem::take(&mut groups.edges);
        let sides = |i: usize| [1, 2].map(|side| (self.vertex((corners[i].0, corners[i].1 + side)), i as u32));
        edges.extend((0..corners.len()).flat_map(sides));
        edges.sort_unstable();
        for (place, (end, i)) in edges.iter().enumerate() {
            let others = edges[place + 1..].iter().take(AT_AN_EDGE).take_while(|(other, _)| other == end);
            for (_, j) in others {
                if face(corners[*i as usize]).dot(face(corners[*j as usize])) > self.least {
                    groups.join(*i, *j);
                }
            }
        }
        edges.clear();
        groups.edges = edges;
        for (i, at) in corners.iter().enumerate() {
            let group = groups.of(i as u32) as usize;
            groups.sums[group] += self.angle(*at) * face(*at);
        }
        for (i, at) in corners.iter().enumerate() {
            let group = groups.of(i as u32) as usize;
            if let Some(normal) = groups.sums[group].try_normalize() {
                normals[at.0 as usize][usize::from(at.1)] = normal.as_vec3();
            }
        }
    }

    /// Returns the angle of a triangle at a corner.
    fn angle(&self, (triangle, corner): At) -> f64 {
        let corners = self.raw.triangles()[triangle as usize].corners;
        let point = |i: u8| self.raw.positions[corners[usize::from(i % 3)].position as usize];
        let (a, b) = (point(corner + 1) - point(corner), point(corner + 2) - point(corner));
        a.cross(b).length().atan2(a.dot(b))
    }
}

/// Sets of the corners at a vertex, with the sum of each set's normals.
#[derive(Default)]
struct Groups {
    parents: Vec<u32>,
    sums: Vec<DVec3>,
    /// The edges at the vertex: the index of the other end, and of the corner.
    edges: Vec<(u32, u32)>,
}

impl Groups {
    fn begin(&mut self, count: usize) {
        self.parents.clear();
        self.parents.extend(0..count as u32);
        self.sums.clear();
        self.sums.resize(count, DVec3::ZERO);
    }

    fn of(&mut self, mut i: u32) -> u32 {
        while self.parents[i as usize] != i {
            let parent = self.parents[i as usize];
            self.parents[i as usize] = self.parents[parent as usize];
            i = parent;
        }
        i
    }

    fn join(&mut self, i: u32, j: u32) {
        let (i, j) = (self.of(i), self.of(j));
        self.parents[i.max(j) as usize] = i.min(j);
    }
}
