//! Builds a bounding volume hierarchy over the items of a scene, stored depth first.
//!
//! *Practice.* The crate obvhs builds the hierarchy on all cores (PLOC, then reinsertion).

use std::collections::HashSet;

use glam::{DVec3, Vec3};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;

/// An item of the hierarchy: a primitive and its box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Item {
    /// The kind and index of the primitive, encoded as in `shaders/segment/ray.wgsl`.
    pub primitive: u32,
    /// The box's lower corner.
    pub lo: Vec3,
    /// The box's upper corner.
    pub hi: Vec3,
}

/// A node of the hierarchy, in depth-first order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// The box's lower corner.
    pub lo: Vec3,
    /// The box's upper corner.
    pub hi: Vec3,
    /// The index of the node that follows this node's subtree.
    pub skip: u32,
    /// The word of a leaf: the number of items in the upper four bits, and the index of the first item in the others; 0 in an inner node.
    pub leaf: u32,
}

/// The maximum number of items in one leaf.
pub(super) const LEAF: u32 = 4;

/// The number of bits of a leaf's word that store its first item.
const FIRST_BITS: u32 = 28;

impl Node {
    /// Returns the first item of a leaf and its number of items, or `None` for an inner node.
    #[must_use]
    pub fn items(&self) -> Option<(u32, u32)> {
        (self.leaf != 0).then_some((self.leaf & ((1 << FIRST_BITS) - 1), self.leaf >> FIRST_BITS))
    }

    /// Returns the box of the node, enlarged by `slack` times its coordinates to allow for rounding.
    #[must_use]
    pub fn grown(&self, slack: f64) -> [DVec3; 2] {
        let (lo, hi) = (self.lo.as_dvec3(), self.hi.as_dvec3());
        let slack = slack * lo.abs().max(hi.abs());
        [lo - slack, hi + slack]
    }

    /// Returns the node for a list in which `nodes` nodes and `items` items precede its own hierarchy.
    pub(super) fn behind(self, nodes: u32, items: u32) -> Self {
        let leaf = if self.leaf == 0 { 0 } else { self.leaf + items };
        Self { skip: self.skip + nodes, leaf, ..self }
    }
}

/// Returns the nodes, and the items in the order of the leaves; no leaf has more than `leaf` items.
pub(super) fn hierarchy(items: &[Item], leaf: u32) -> (Vec<Node>, Vec<u32>) {
    let boxes: Vec<Aabb> = items.iter().enumerate().map(|(i, item)| apart(i, item)).collect();
    // If most boxes coincide, reinsertion gains nothing and would take minutes.
    let distinct: HashSet<_> = items.iter().map(bits).collect();
    let preset = if 2 * distinct.len() < items.len() {
        BvhBuildParams { reinsertion_batch_ratio: 0.0, ..BvhBuildParams::medium_build() }
    } else {
        BvhBuildParams::medium_build()
    };
    let params = BvhBuildParams { max_prims_per_leaf: leaf, pre_split: false, ..preset };
    let bvh = build_bvh2(&boxes, params, &mut std::time::Duration::default());
    let (mut nodes, mut order) = (Vec::new(), Vec::with_capacity(items.len()));
    flatten(&bvh, items, &mut nodes, &mut order);
    (nodes, order)
}

fn bits(item: &Item) -> [[u32; 3]; 2] {
    [item.lo, item.hi].map(|corner| corner.to_array().map(f32::to_bits))
}

/// Returns the box of an item for the builder, enlarged by a small amount that differs between items. PLOC joins pairs of boxes that choose
/// each other. If many boxes of one size coincide, all choose the same one, and each pass over all boxes joins only two: 30,000 boxes took
/// 40 s and gave a tree half as deep as their number.
fn apart(i: usize, item: &Item) -> Aabb {
    // Points that fill a cube evenly, from first to last: the R3 sequence of Roberts.
    let own = (i as f64 * DVec3::new(0.819_172_513_396, 0.671_043_606_703, 0.549_700_477_901)).fract().as_vec3();
    // More than the rounding error at the box, but small compared with its size.
    let rounding = 1e-6 * item.lo.abs().max(item.hi.abs()).max_element();
    let most = (6e-5 * (item.hi - item.lo).max_element()).max(rounding);
    Aabb::new(item.lo.into(), (item.hi + most * own).into())
}

/// Flattens the tree depth first: if a ray meets a box, the next node to visit is the next in the list, otherwise `skip`. Boxes are
/// computed from the items.
fn flatten(bvh: &Bvh2, items: &[Item], nodes: &mut Vec<Node>, order: &mut Vec<u32>) {
    // Use an explicit stack, because a degenerate mesh makes the tree too deep for recursion. `Err` closes the node whose subtree ended.
    let mut open = vec![Ok(0)];
    while let Some(next) = open.pop() {
        let at: usize = match next {
            Ok(at) => at,
            Err(node) => {
                close(node, items, nodes, order);
                continue;
            }
        };
        let node = &bvh.nodes[at];
        let mut leaf = 0;
        open.push(Err(nodes.len()));
        if node.prim_count > 0 {
            leaf = (node.prim_count << FIRST_BITS) | order.len() as u32;
            let first = node.first_index as usize;
            order.extend(&bvh.primitive_indices[first..first + node.prim_count as usize]);
        } else {
            open.extend([Ok(node.first_index as usize + 1), Ok(node.first_index as usize)]);
        }
        nodes.push(Node { lo: Vec3::INFINITY, hi: Vec3::NEG_INFINITY, skip: 0, leaf });
    }
}

/// Completes a node when its subtree has ended: the items of a leaf are the last in `order`, and the first child of an inner node follows
/// its parent.
fn close(node: usize, items: &[Item], nodes: &mut [Node], order: &[u32]) {
    let join = |(lo, hi): (Vec3, Vec3), (lo_2, hi_2): (Vec3, Vec3)| (lo.min(lo_2), hi.max(hi_2));
    let inside = |child: &Node| (child.lo, child.hi);
    let (lo, hi) = match nodes[node].leaf >> FIRST_BITS {
        0 => join(inside(&nodes[node + 1]), inside(&nodes[nodes[node + 1].skip as usize])),
        count => order[order.len() - count as usize..]
            .iter()
            .map(|&i| (items[i as usize].lo, items[i as usize].hi))
            .fold(inside(&nodes[node]), join),
    };
    nodes[node] = Node { lo, hi, skip: nodes.len() as u32, ..nodes[node] };
}

#[cfg(test)]
mod tests {
    use super::*;

    fn items(boxes: impl IntoIterator<Item = (Vec3, Vec3)>) -> Vec<Item> {
        boxes.into_iter().zip(0..).map(|((lo, hi), primitive)| Item { primitive, lo, hi }).collect()
    }

    /// Returns the largest number of nodes from the root to a leaf, and checks that each box is the smallest around its items.
    fn depth(items: &[Item], nodes: &[Node], order: &[u32]) -> usize {
        let mut ends: Vec<(usize, usize)> = Vec::new();
        let mut deepest = 0;
        for (at, node) in nodes.iter().enumerate() {
            ends.retain(|(_, end)| *end > at);
            ends.push((at, node.skip as usize));
            deepest = deepest.max(ends.len());
            let leaves = nodes[at..node.skip as usize].iter().filter(|node| node.leaf != 0);
            let held = leaves.flat_map(|leaf| {
                let (first, count) = leaf.items().unwrap_or_default();
                order[first as usize..(first + count) as usize].iter().map(|&i| items[i as usize])
            });
            let nothing = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let all = held.fold(nothing, |all, item| (all.0.min(item.lo), all.1.max(item.hi)));
            assert_eq!((node.lo, node.hi), all, "node {at}");
        }
        deepest
    }

    #[test]
    fn what_lies_in_one_place_makes_no_deep_tree() {
        let wall = |i: u32| Vec3::new(5.0, 5.0, 1e-6 * i as f32);
        let walls = items((0..3000).map(|i| (wall(i) * Vec3::new(-1.0, -1.0, 1.0), wall(i))));
        let same = items((0..3000).map(|_| (Vec3::splat(1e3), Vec3::splat(1e3 + 1.0))));
        let side = |i: u32| Vec3::new((i % 50) as f32, (i / 50) as f32, 0.0);
        let floor = items((0..3000).map(|i| (side(i), side(i) + Vec3::new(1.0, 1.0, 0.0))));
        for (name, items) in [("walls", walls), ("same", same), ("floor", floor)] {
            let (nodes, order) = hierarchy(&items, LEAF);
            let mut each = order.clone();
            each.sort_unstable();
            assert!(each.into_iter().eq(0..3000), "{name}");
            let depth = depth(&items, &nodes, &order);
            assert!(depth < 200, "{name}: {depth} deep");
        }
    }
}
