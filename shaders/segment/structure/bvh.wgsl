// A bounding volume hierarchy over curved arcs: nodes in depth-first order, each with the node to go on with when it is missed, so
// that the walk needs no stack and may stop and go on anywhere.
//
// A segment is walked once, as its chord, however many pieces it has: all of them stay, at each fraction, within the segment's
// bulge of the chord, so that a box grown by the bulge is met by the chord, at that fraction, where the box is met by the arc.

// Two reads of four words, which lavapipe makes lane by lane, each at nearly the price of one word. Boxes are of 32 bits in any program.
struct Node {
    // The lower corner's bits, and the node after this one's whole subtree.
    lo_skip: vec4u,
    // The upper corner's bits, and 0 inside the tree; in a leaf the number of items in the upper eight bits, the first of them in the
    // others.
    hi_leaf: vec4u,
}

@group(0) @binding(90) var<storage, read> nodes: array<Node>;

const LEAF_FIRST: u32 = 0x00ffffffu;

// What rounding may hide, as a part of a coordinate. The host has grown all boxes by as much of their own.
const BOX_SLACK: Real = 2e-6;

// A segment's chord, as boxes see it.
struct Sweep {
    // Its start, moved up and down each axis by the bulge and by what rounding may hide.
    high: Real3,
    low: Real3,
    // One over its extent.
    inverse: Real3,
}

fn segment_sweep(s: Segment) -> Sweep {
    let d = s.x1 - s.x0;
    let inverse = 1.0 / select(d, Real3(1e-30), abs(d) < Real3(1e-30));
    let margin = segment_bulge(s) + BOX_SLACK * abs(s.x0);
    return Sweep(s.x0 + margin, s.x0 - margin, inverse);
}

fn corner(bits: vec4u) -> Real3 {
    return Real3(bitcast<vec3f>(bits.xyz));
}

// Where the chord is inside the box, up to `limit`.
fn box_span(lo: Real3, hi: Real3, sweep: Sweep, limit: Real) -> Span {
    let t0 = (lo - sweep.high) * sweep.inverse;
    let t1 = (hi - sweep.low) * sweep.inverse;
    let near = min(t0, t1);
    let far = max(t0, t1);
    let enters = max(max(near.x, near.y), max(near.z, -overlap()));
    let leaves = min(min(far.x, far.y), min(far.z, min(limit, 1.0 + OVERLAP)));
    return Span(enters, leaves);
}

fn structure_hit(s: Segment, pieces: u32, nearest: Hit) -> Hit {
    var hit = nearest;
    let sweep = segment_sweep(s);
    let count = arrayLength(&nodes);
    var node = select(count, walk_begin(), pieces > 0u);
    // In turns: every ray to its next leaf, then all of them through their items, for neighbours run side by side.
    while node < count && walk_has_room() {
        work += 1u;
        var span = Span(0.0, 0.0);
        var leaf = 0u;
        while node < count && leaf == 0u && walk_has_room() {
            work += 1u;
            let box = nodes[node];
            span = box_span(corner(box.lo_skip), corner(box.hi_leaf), sweep, hit.t);
            let met = span.enters <= span.leaves;
            leaf = select(0u, box.hi_leaf.w, met);
            node = select(box.lo_skip.w, node + 1u, met && box.hi_leaf.w == 0u);
        }
        hit = items_hit(s, pieces, span, leaf & LEAF_FIRST, leaf >> 24u, hit);
    }
    walk_stop(node, node >= count);
    return hit;
}
