//! Edges: which corners are at one place, and whether every edge has two triangles.

use foldhash::{HashMap, HashMapExt};
use glam::Vec3;

use super::Mesh;

/// For each position the number of the first that is equal.
pub(super) fn welded(positions: impl ExactSizeIterator<Item = Vec3>) -> Vec<u32> {
    let mut first: HashMap<[u32; 3], u32> = HashMap::with_capacity(positions.len());
    let same = positions.enumerate().map(|(i, position)| {
        // 0 and −0 are one place.
        let key = (position + Vec3::ZERO).to_array().map(f32::to_bits);
        *first.entry(key).or_insert(i as u32)
    });
    same.collect()
}

impl Mesh {
    /// The middle of an edge at which the surface is open, if it is: closed surfaces have every edge twice, once in each
    /// direction. Corners are the same where their positions are.
    #[must_use]
    pub fn hole(&self) -> Option<[f32; 3]> {
        let same = welded(self.vertices.iter().map(|vertex| vertex.position));
        let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        // Both directions of an edge have one name, and each a sign.
        let named = |[a, b]: [u32; 2]| {
            let (a, b) = (same[a as usize], same[b as usize]);
            ((a.min(b), a.max(b)), (a < b, a > b))
        };
        let mut edges: Vec<_> = self.triangles.iter().flat_map(sides).map(named).collect();
        edges.sort_unstable();
        let open = edges.chunk_by(|(a, _), (b, _)| a == b).filter(|edge| {
            let along = edge.iter().filter(|(_, (along, _))| *along).count();
            let against = edge.iter().filter(|(_, (_, against))| *against).count();
            along != against
        });
        let open: Vec<_> = open.map(|edge| edge[0].0).collect();
        // Of those the first in the file.
        let mut all = self.triangles.iter().flat_map(sides);
        let found = if open.is_empty() { None } else { all.find(|edge| open.binary_search(&named(*edge).0).is_ok()) };
        found.map(|[a, b]| {
            let place = |i: u32| self.vertices[i as usize].position;
            ((place(a) + place(b)) / 2.0).to_array()
        })
    }
}
