//! A hierarchy of boxes over a scene's items, laid out depth first.
//!
//! *Practice.* It is the crate's (PLOC, then reinsertion), built on all cores.

use std::collections::HashSet;

use glam::{DVec3, Vec3};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;

/// What can be met: its primitive, and its box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Item {
    /// Kind and index, as in `shaders/segment/ray.wgsl`.
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
    /// The node after this one's subtree.
    pub skip: u32,
    /// 0 inside the tree; in a leaf the number of items in the upper four bits, the first of them in the others.
    pub leaf: u32,
}

/// Items in one leaf, at most.
pub(super) const LEAF: u32 = 4;

/// The bits of a leaf's word that are its first item.
const FIRST_BITS: u32 = 28;

impl Node {
    /// A leaf's first item, and how many it has; none inside the tree.
    #[must_use]
    pub fn items(&self) -> Option<(u32, u32)> {
        (self.leaf != 0).then_some((self.leaf & ((1 << FIRST_BITS) - 1), self.leaf >> FIRST_BITS))
    }

    /// Its box, grown by what rounding may hide of it: this part of its coordinates.
    #[must_use]
    pub fn grown(&self, slack: f64) -> [DVec3; 2] {
        let (lo, hi) = (self.lo.as_dvec3(), self.hi.as_dvec3());
        let slack = slack * lo.abs().max(hi.abs());
        [lo - slack, hi + slack]
    }

    /// The same node where as many nodes lie before its hierarchy, and as many items before its own.
    pub(super) fn behind(self, nodes: u32, items: u32) -> Self {
        let leaf = if self.leaf == 0 { 0 } else { self.leaf + items };
        Self { skip: self.skip + nodes, leaf, ..self }
    }
}

/// The nodes, and the items in the order of the leaves, of which none has more than `leaf`.
pub(super) fn hierarchy(items: &[Item], leaf: u32) -> (Vec<Node>, Vec<u32>) {
    let boxes: Vec<Aabb> = items.iter().enumerate().map(|(i, item)| apart(i, item)).collect();
    // Where most boxes coincide nothing is gained by moving them about, and it would take minutes.
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

/// An item's box as the builder sees it, grown by a little of its own. PLOC joins boxes that choose each other; where many of one size
/// lie in one place all choose the same, and only two are joined in each pass over them all: 30,000 took 40 s and made a tree as deep
/// as half their number.
fn apart(i: usize, item: &Item) -> Aabb {
    // Points that fill a cube evenly, from first to last: Roberts's R3 sequence.
    let own = (i as f64 * DVec3::new(0.819_172_513_396, 0.671_043_606_703, 0.549_700_477_901)).fract().as_vec3();
    // More than a rounding where the box lies, and little beside its size.
    let rounding = 1e-6 * item.lo.abs().max(item.hi.abs()).max_element();
    let most = (6e-5 * (item.hi - item.lo).max_element()).max(rounding);
    Aabb::new(item.lo.into(), (item.hi + most * own).into())
}

/// Depth first, so that the next node to visit is the next in the list where the box is met, and `skip` where it is missed. Boxes are
/// those of the items.
fn flatten(bvh: &Bvh2, items: &[Item], nodes: &mut Vec<Node>, order: &mut Vec<u32>) {
    // An explicit stack: a degenerate mesh makes a tree too deep for recursion. `Err` closes the node whose subtree ended.
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

/// What is known of a node when its subtree has ended: a leaf's items are the last in the order, and the first of two children is
/// the node after their parent.
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

    /// The most nodes from the root to a leaf, each of whose boxes is the least about its items.
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
