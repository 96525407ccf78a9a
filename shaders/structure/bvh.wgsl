// A bounding volume hierarchy over curved arcs: nodes in depth-first order, each with the node to go on with when it is missed, so
// that the walk needs no stack and may stop and go on anywhere.
//
// A segment is walked once, as its chord, however many pieces it has: all of them stay, at each fraction, within the segment's
// bulge of the chord, so that a box grown by the bulge is met by the chord, at that fraction, where the box is met by the arc.

struct Node {
    lo: Real3,
    // The node after this one's whole subtree.
    skip: u32,
    hi: Real3,
    // 0 inside the tree; in a leaf the number of items in the upper eight bits, the first of them in the others.
    leaf: u32,
}

@group(0) @binding(98) var<storage, read> nodes: array<Node>;

const LEAF_FIRST: u32 = 0x00ffffffu;

// Where the chord from a, with 1/d given, is inside the box, up to `limit`. The box is grown by the bulge and by what rounding may
// hide.
fn box_span(lo: Real3, hi: Real3, a: Real3, inverse: Real3, bulge: Real3, limit: Real) -> Span {
    let grown = 2e-6 * (max(abs(lo), abs(hi)) + abs(a)) + bulge;
    let t0 = (lo - grown - a) * inverse;
    let t1 = (hi + grown - a) * inverse;
    let near = min(t0, t1);
    let far = max(t0, t1);
    let enters = max(max(near.x, near.y), max(near.z, -overlap()));
    let leaves = min(min(far.x, far.y), min(far.z, min(limit, 1.0 + OVERLAP)));
    return Span(enters, leaves);
}

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let d = s.x1 - s.x0;
    let inverse = 1.0 / select(d, Real3(1e-30), abs(d) < Real3(1e-30));
    let bulge = segment_bulge(s);
    let count = arrayLength(&nodes);
    var node = select(count, walk_begin(), pieces > 0u);
    // In turns: every ray to its next leaf, then all of them through their items, for neighbours run side by side.
    while node < count && walk_may_go_on() {
        work += 1u;
        var span = Span(0.0, 0.0);
        var leaf = 0u;
        while node < count && leaf == 0u && walk_may_go_on() {
            work += 1u;
            let box = nodes[node];
            span = box_span(box.lo, box.hi, s.x0, inverse, bulge, hit.t);
            let met = span.enters <= span.leaves;
            leaf = select(0u, box.leaf, met);
            node = select(box.skip, node + 1u, met && box.leaf == 0u);
        }
        hit = items_hit(s, pieces, span, leaf & LEAF_FIRST, leaf >> 24u, hit);
    }
    walk_stop(node, node >= count);
    return hit;
}
