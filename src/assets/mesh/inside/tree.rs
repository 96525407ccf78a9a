//! A tree of bounding boxes over the triangles of a mesh's shells, which finds close triangles of different shells, and crossings of a ray.

use glam::{DVec2, DVec3, Vec3, Vec3Swizzles};

use super::super::Mesh;
use super::shells::{NONE, Shells};

/// The largest number of triangles in a leaf.
const LEAF: usize = 6;

/// A bounding box and its contents.
struct Node {
    lo: Vec3,
    hi: Vec3,
    /// The shell of all its triangles; [`NONE`] if there are several.
    shell: u32,
    /// The range of a leaf's triangles in the order, or the two child nodes.
    start: u32,
    end: u32,
    is_leaf: bool,
}

/// A tree of bounding boxes over triangles.
pub(super) struct Tree<'a> {
    mesh: &'a Mesh,
    shells: &'a Shells,
    nodes: Vec<Node>,
    order: Vec<u32>,
    /// The axis along which the mesh is shortest: rays along it cross the fewest shells.
    shortest: usize,
}

impl<'a> Tree<'a> {
    /// Builds the tree over all triangles that belong to a shell.
    pub fn new(mesh: &'a Mesh, shells: &'a Shells) -> Self {
        let order = (0..mesh.triangles.len() as u32).filter(|i| shells.of[*i as usize] != NONE).collect();
        let mut tree = Self { mesh, shells, nodes: Vec::new(), order, shortest: 0 };
        tree.build();
        tree.shortest = tree.nodes.first().map_or(0, |whole| (whole.hi - whole.lo).min_position());
        tree
    }

    fn build(&mut self) {
        let mut order = std::mem::take(&mut self.order);
        self.nodes.push(self.node(&order, 0));
        let mut open = vec![0];
        while let Some(at) = open.pop() {
            let Node { start, end, .. } = self.nodes[at];
            let own = &mut order[start as usize..end as usize];
            if own.len() <= LEAF {
                continue;
            }
            let middle = |i: &u32| self.corners(*i).into_iter().sum::<Vec3>();
            let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let (lo, hi) = own.iter().map(middle).fold(nothing, |(lo, hi), x| (lo.min(x), hi.max(x)));
            let axis = (hi - lo).max_position();
            let half = own.len() / 2;
            own.select_nth_unstable_by(half, |i, j| middle(i)[axis].total_cmp(&middle(j)[axis]));
            let (low, high) = own.split_at(half);
            let below = self.nodes.len() as u32;
            let pair = [self.node(low, start), self.node(high, start + half as u32)];
            self.nodes.extend(pair);
            let node = &mut self.nodes[at];
            (node.start, node.end, node.is_leaf) = (below, below + 1, false);
            open.extend([below as usize, below as usize + 1]);
        }
        self.order = order;
    }

    fn node(&self, triangles: &[u32], start: u32) -> Node {
        let corners = triangles.iter().flat_map(|i| self.corners(*i));
        let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (lo, hi) = corners.fold(nothing, |(lo, hi), x| (lo.min(x), hi.max(x)));
        let mut shells = triangles.iter().map(|i| self.shells.of[*i as usize]);
        let first = shells.next().unwrap_or(NONE);
        let shell = if shells.all(|shell| shell == first) { first } else { NONE };
        Node { lo, hi, shell, start, end: start + triangles.len() as u32, is_leaf: true }
    }

    fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.mesh.triangles[triangle as usize].map(|corner| self.mesh.vertices[corner as usize].position)
    }

    /// Returns the corners of a triangle in 64 bits.
    pub fn triangle(&self, triangle: u32) -> [DVec3; 3] {
        self.corners(triangle).map(Vec3::as_dvec3)
    }

    fn triangles(&self, node: &Node) -> &[u32] {
        &self.order[node.start as usize..node.end as usize]
    }

    /// Visits all pairs of triangles of different shells whose boxes are at most `slack` apart, with their shells.
    pub fn pairs(&self, slack: f32, mut visit: impl FnMut([u32; 2], [u32; 2])) {
        let mut open = vec![(0, 0)];
        while let Some((i, j)) = open.pop() {
            let (a, b): (&Node, &Node) = (&self.nodes[i as usize], &self.nodes[j as usize]);
            let apart = (a.lo - Vec3::splat(slack)).cmpgt(b.hi).any() || (b.lo - Vec3::splat(slack)).cmpgt(a.hi).any();
            if apart || (a.shell == b.shell && a.shell != NONE) {
                continue;
            }
            match (a.is_leaf, b.is_leaf) {
                (true, true) => self.leaf_pairs(i == j, [a, b], &mut visit),
                _ if i == j => open.extend([(a.start, a.start), (a.end, a.end), (a.start, a.end)]),
                (false, true) => open.extend([(a.start, j), (a.end, j)]),
                (true, false) => open.extend([(i, b.start), (i, b.end)]),
                (false, false) => {
                    open.extend([(a.start, b.start), (a.start, b.end), (a.end, b.start), (a.end, b.end)]);
                }
            }
        }
    }

    fn leaf_pairs(&self, is_same: bool, [a, b]: [&Node; 2], visit: &mut impl FnMut([u32; 2], [u32; 2])) {
        for (k, t) in self.triangles(a).iter().enumerate() {
            let others = &self.triangles(b)[if is_same { k + 1 } else { 0 }..];
            for u in others {
                let shells = [t, u].map(|i| self.shells.of[*i as usize]);
                if shells[0] != shells[1] {
                    visit([*t, *u], shells);
                }
            }
        }
    }

    /// Visits all triangles whose boxes are at most `slack` away from a point, each with its shell.
    pub fn near(&self, point: DVec3, slack: f64, mut visit: impl FnMut(u32, u32)) {
        let mut open = vec![0_u32];
        while let Some(i) = open.pop() {
            let node = &self.nodes[i as usize];
            let (lo, hi) = (node.lo.as_dvec3() - slack, node.hi.as_dvec3() + slack);
            if point.cmplt(lo).any() || point.cmpgt(hi).any() {
                continue;
            }
            if node.is_leaf {
                self.triangles(node).iter().for_each(|triangle| visit(*triangle, self.shells.of[*triangle as usize]));
            } else {
                open.extend([node.start, node.end]);
            }
        }
    }

    /// Returns a position rotated so that the shortest axis is x. A rotation preserves the sides of triangles.
    fn turned(&self, place: DVec3) -> DVec3 {
        match self.shortest {
            0 => place,
            1 => place.yzx(),
            _ => place.zxy(),
        }
    }

    /// Visits all crossings of a ray from a point, except crossings of the shell `own`: a shell, and 1 if the ray leaves through
    /// its triangle according to the winding, −1 if it enters.
    ///
    /// No line passes between two triangles that share an edge, or hits both: its side relative to an edge is always computed
    /// from the edge's lesser end, and a line through the edge is treated as if it were shifted infinitesimally.
    pub fn crossings(&self, from: DVec3, own: u32, mut visit: impl FnMut(u32, i32)) {
        let from = self.turned(from);
        let mut open = vec![0_u32];
        while let Some(i) = open.pop() {
            let node = &self.nodes[i as usize];
            let [lo, hi] = [node.lo, node.hi].map(|corner| self.turned(corner.as_dvec3()));
            let misses = lo.y > from.y || hi.y < from.y || lo.z > from.z || hi.z < from.z || hi.x < from.x;
            if misses || node.shell == own {
                continue;
            }
            if !node.is_leaf {
                open.extend([node.start, node.end]);
                continue;
            }
            for triangle in self.triangles(node) {
                let shell = self.shells.of[*triangle as usize];
                let met = crossing(self.triangle(*triangle).map(|corner| self.turned(corner)), from);
                if let Some((_, winding)) = met.filter(|(distance, _)| *distance > 0.0 && shell != own) {
                    visit(shell, if self.shells.turned[*triangle as usize] { -winding } else { winding });
                }
            }
        }
    }
}

/// Returns the crossing of the line from a point along x with a triangle: the distance, and 1 if the line runs along the normal, else −1.
fn crossing([a, b, c]: [DVec3; 3], from: DVec3) -> Option<(f64, i32)> {
    let sides = [passes_left(a, b, from), passes_left(b, c, from), passes_left(c, a, from)];
    if sides.iter().any(|side| *side != sides[0]) {
        return None;
    }
    let normal = (b - a).cross(c - a);
    let x = a.x - (normal.y * (from.y - a.y) + normal.z * (from.z - a.z)) / normal.x;
    let (lo, hi) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
    // The crossing with a triangle seen edge-on is only known to be in its box.
    let x = if x.is_finite() { x.clamp(lo, hi) } else { 0.5 * (lo + hi) };
    Some((x - from.x, if sides[0] { 1 } else { -1 }))
}

/// Returns `true` if, seen along −x, a point is to the left of the line from p to q.
fn passes_left(p: DVec3, q: DVec3, at: DVec3) -> bool {
    let key = |p: DVec3| [p.y, p.z, p.x];
    let swapped = key(q) < key(p);
    let (p, q) = if swapped { (q, p) } else { (p, q) };
    let flat = |p: DVec3| DVec2::new(p.y, p.z);
    let side = (flat(q) - flat(p)).perp_dot(flat(at) - flat(p));
    (side >= 0.0) != swapped
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;
    use std::path::Path;

    use super::*;

    /// Returns a row of tetrahedra along an axis.
    fn row(axis: usize, count: usize) -> Mesh {
        let mut text = String::new();
        for i in 0..count {
            for corner in [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z] {
                let mut place = corner;
                place[axis] += 2.0 * i as f32;
                writeln!(text, "v {} {} {}", place.x, place.y, place.z).unwrap();
            }
            text += "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n";
        }
        Mesh::parse(&text, Path::new("a.obj")).unwrap()
    }

    #[test]
    fn rays_from_a_row_of_shells_do_not_run_along_it() {
        for axis in 0..3 {
            let mesh = row(axis, 50);
            let shells = Shells::of(&mesh).unwrap();
            let tree = Tree::new(&mesh, &shells);
            let from = DVec3::splat(0.2);
            let mut crossed = 0;
            tree.crossings(from, NONE - 1, |_, winding| crossed += winding.abs());
            // The ray leaves the first tetrahedron, in which it begins.
            assert_eq!((shells.all.len(), crossed), (50, 1), "along axis {axis}");
        }
    }
}
