//! Edges: which corners are in one position, and which triangles share an edge.

use foldhash::{HashMap, HashMapExt};
use glam::Vec3;

use super::Mesh;

/// For each position the number of the first that is equal.
pub(super) fn welded(positions: impl ExactSizeIterator<Item = Vec3>) -> Vec<u32> {
    let mut first: HashMap<[u32; 3], u32> = HashMap::with_capacity(positions.len());
    let same = positions.enumerate().map(|(i, position)| {
        // 0 and −0 are equal.
        let key = (position + Vec3::ZERO).to_array().map(f32::to_bits);
        *first.entry(key).or_insert(i as u32)
    });
    same.collect()
}

/// A side of a triangle. The vertex with the lower number, where its edge is listed, is one end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// The other end.
    pub end: u32,
    /// Three times the number of its triangle, plus the number of the corner at which it starts: 0, 1 or 2.
    pub corner: u32,
    /// Whether the triangle passes it from the lower to the higher vertex.
    pub along: bool,
}

impl Side {
    /// The triangle's number.
    pub fn triangle(&self) -> usize {
        self.corner as usize / 3
    }
}

/// The sides of triangles, grouped by the edge that they lie on.
pub(super) struct Edges {
    sides: Vec<Side>,
    /// For each vertex where its sides end.
    ends: Vec<u32>,
}

impl Edges {
    /// Groups the sides of triangles, each a number with its three vertices, which are below `vertices`.
    pub fn of(triangles: &(impl Iterator<Item = (u32, [u32; 3])> + Clone), vertices: usize) -> Self {
        let sides = || {
            triangles.clone().flat_map(|(i, [a, b, c])| {
                let sides = [[a, b], [b, c], [c, a]].into_iter().zip(3 * i..);
                sides.filter(|([a, b], _)| a != b).map(|([a, b], corner)| (a.min(b), a.max(b), corner, a < b))
            })
        };
        let mut ends = vec![0_u32; vertices + 1];
        sides().for_each(|(start, ..)| ends[start as usize + 1] += 1);
        (1..ends.len()).for_each(|i| ends[i] += ends[i - 1]);
        let mut all = vec![Side { end: 0, corner: 0, along: false }; ends[vertices] as usize];
        for (start, end, corner, along) in sides() {
            let next = &mut ends[start as usize];
            all[*next as usize] = Side { end, corner, along };
            *next += 1;
        }
        ends.pop();
        let mut first = 0;
        for end in &ends {
            all[first..*end as usize].sort_unstable_by_key(|side| (side.end, side.corner));
            first = *end as usize;
        }
        Self { sides: all, ends }
    }

    /// The vertex with the lower number of each edge, and the sides there.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &[Side])> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts.zip(&self.ends).enumerate().flat_map(|(vertex, (start, end))| {
            let own = &self.sides[start as usize..*end as usize];
            own.chunk_by(|a, b| a.end == b.end).map(move |sides| (vertex as u32, sides))
        })
    }
}

/// How many of the sides at an edge run along it, and how many against it.
pub(super) fn directions(sides: &[Side]) -> [usize; 2] {
    let along = sides.iter().filter(|side| side.along).count();
    [along, sides.len() - along]
}

impl Mesh {
    /// The middle of the first edge at which the surface is open or changes its winding, if there is one: closed surfaces that
    /// are wound consistently have every edge as often in one direction as in the other. Corners are the same if their positions are.
    #[must_use]
    pub fn hole(&self) -> Option<[f32; 3]> {
        let same = welded(self.vertices.iter().map(|vertex| vertex.position));
        let triangles = self.triangles.iter().map(|corners| corners.map(|corner| same[corner as usize]));
        let edges = Edges::of(&(0..).zip(triangles), same.len());
        let open = edges.iter().filter(|(_, sides)| directions(sides)[0] != directions(sides)[1]);
        open.flat_map(|(_, sides)| sides).map(|side| side.corner).min().map(|corner| self.middle(corner))
    }

    /// The middle of the side of a triangle that starts at a corner, in the file's space.
    pub(super) fn middle(&self, corner: u32) -> [f32; 3] {
        let triangle = self.triangles[corner as usize / 3];
        let [a, b] = [corner, corner + 1].map(|k| {
            let next = if corner / 3 == k / 3 { k % 3 } else { 0 };
            self.vertices[triangle[next as usize] as usize].position
        });
        (self.origin.as_vec3() + (a + b) / 2.0).to_array()
    }
}
