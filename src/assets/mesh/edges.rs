//! Edges: corners at equal positions, and triangles that share an edge.

use foldhash::{HashMap, HashMapExt};
use glam::Vec3;

use super::Mesh;

/// Returns for each position the index of the first equal position.
pub(super) fn welded(positions: impl ExactSizeIterator<Item = Vec3>) -> Vec<u32> {
    let mut first: HashMap<[u32; 3], u32> = HashMap::with_capacity(positions.len());
    let same = positions.enumerate().map(|(i, position)| {
        // 0 and −0 are equal.
        let key = (position + Vec3::ZERO).to_array().map(f32::to_bits);
        *first.entry(key).or_insert(i as u32)
    });
    same.collect()
}

/// A side of a triangle. It is stored at the vertex with the lower index.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// The vertex with the higher index.
    pub end: u32,
    /// Three times the index of its triangle, plus the index of the corner at which it starts: 0, 1 or 2.
    pub corner: u32,
    /// Whether the triangle traverses it from the lower to the higher index.
    pub along: bool,
}

impl Side {
    /// Returns the index of the triangle.
    pub fn triangle(&self) -> usize {
        self.corner as usize / 3
    }
}

/// The sides of triangles, grouped by edge.
pub(super) struct Edges {
    sides: Vec<Side>,
    /// The end of each vertex's sides.
    ends: Vec<u32>,
}

impl Edges {
    /// Groups the sides of triangles. Each triangle is an index with its three vertices, which are below `vertices`.
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

    /// Returns for each edge the vertex with the lower index, and the sides at that edge.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &[Side])> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts.zip(&self.ends).enumerate().flat_map(|(vertex, (start, end))| {
            let own = &self.sides[start as usize..*end as usize];
            own.chunk_by(|a, b| a.end == b.end).map(move |sides| (vertex as u32, sides))
        })
    }
}

/// Counts the sides at an edge that run along it, and the sides that run against it.
pub(super) fn directions(sides: &[Side]) -> [usize; 2] {
    let along = sides.iter().filter(|side| side.along).count();
    [along, sides.len() - along]
}

impl Mesh {
    /// Returns the middle of the first edge at which the surface is open or changes its winding, if there is one. Closed surfaces with
    /// consistent winding traverse every edge equally often in both directions. Corners are identified by their positions.
    #[must_use]
    pub fn hole(&self) -> Option<[f32; 3]> {
        let same = welded(self.vertices.iter().map(|vertex| vertex.position));
        let triangles = self.triangles.iter().map(|corners| corners.map(|corner| same[corner as usize]));
        let edges = Edges::of(&(0..).zip(triangles), same.len());
        let open = edges.iter().filter(|(_, sides)| directions(sides)[0] != directions(sides)[1]);
        open.flat_map(|(_, sides)| sides).map(|side| side.corner).min().map(|corner| self.middle(corner))
    }

    /// Returns the middle of the side of a triangle that starts at a corner, in the file's space.
    pub(super) fn middle(&self, corner: u32) -> [f32; 3] {
        let triangle = self.triangles[corner as usize / 3];
        let [a, b] = [corner, corner + 1].map(|k| {
            let next = if corner / 3 == k / 3 { k % 3 } else { 0 };
            self.vertices[triangle[next as usize] as usize].position
        });
        (self.origin.as_vec3() + (a + b) / 2.0).to_array()
    }
}
