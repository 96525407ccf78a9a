//! Cross sections of meshes: one segment per triangle that crosses the plane, joined to lines.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use super::{LocalPlane, Outline};
use crate::assets::Mesh;

/// An edge of the mesh, by the positions of its ends; equal for both triangles of the edge.
type Edge = [[u32; 3]; 2];

/// A segment between two edges.
type Segment = [Edge; 2];

/// Returns the lines in which a mesh crosses a plane; they are closed if its surface is closed. For every triangle, a vertex in the plane
/// counts as in front of it, so that lines do not break there.
pub(in crate::model) fn cut(mesh: &Mesh, plane: LocalPlane) -> Vec<Outline> {
    let height = |p: Vec3| plane.normal.dot(p.as_dvec3()) - plane.offset;
    let crossing = |a: Vec3, b: Vec3| ((height(a) < 0.0) != (height(b) < 0.0)).then(|| edge(a, b));
    let segments: Vec<Segment> = mesh
        .triangles
        .iter()
        .filter_map(|corners| {
            let [a, b, c] = corners.map(|i| mesh.vertices[i as usize].position);
            let mut crossed = [(a, b), (b, c), (c, a)].into_iter().filter_map(|(a, b)| crossing(a, b));
            Some([crossed.next()?, crossed.next()?])
        })
        .collect();
    let place = |edge: &Edge| {
        let [a, b] = edge.map(|bits| Vec3::from(bits.map(f32::from_bits)));
        let (from, to) = (height(a), height(b));
        a.as_dvec3().lerp(b.as_dvec3(), from / (from - to))
    };
    let outline = |(edges, closed): (Vec<Edge>, bool)| {
        let mut points: Vec<DVec3> = edges.iter().map(place).collect();
        points.dedup();
        Outline { points, closed }
    };
    chains(&segments).into_iter().map(outline).filter(|line| line.points.len() >= 2).collect()
}

/// Creates an edge, with 0 and −0 as one coordinate.
fn edge(a: Vec3, b: Vec3) -> Edge {
    let mut ends = [a, b].map(|p| (p + Vec3::ZERO).to_array().map(f32::to_bits));
    ends.sort_unstable();
    ends
}

/// Joins segments that share an edge, and returns each line with `true` if it is closed.
fn chains(segments: &[Segment]) -> Vec<(Vec<Edge>, bool)> {
    let mut at: HashMap<Edge, Vec<usize>> = HashMap::new();
    for (i, ends) in segments.iter().enumerate() {
        for end in ends {
            at.entry(*end).or_default().push(i);
        }
    }
    let mut used = vec![false; segments.len()];
    let is_end = |i: &usize| segments[*i].iter().any(|end| at[end].len() == 1);
    // Open lines start at one of their ends; the remaining lines are closed.
    let order = (0..segments.len()).filter(is_end).chain(0..segments.len());
    let mut lines = Vec::new();
    for first in order {
        if used[first] {
            continue;
        }
        let [mut from, mut to] = segments[first];
        if at[&to].len() == 1 {
            [from, to] = [to, from];
        }
        let mut line = vec![from, to];
        used[first] = true;
        while let Some(&next) = at[&to].iter().find(|next| !used[**next]) {
            used[next] = true;
            let [a, b] = segments[next];
            to = if a == to { b } else { a };
            line.push(to);
        }
        let closed = line.len() > 3 && line.first() == line.last();
        if closed {
            line.pop();
        }
        lines.push((line, closed));
    }
    lines
}
