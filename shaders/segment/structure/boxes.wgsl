// The nodes of a hierarchy of boxes, and a segment prepared for tests against boxes.

// A node: two reads of four words, because a CPU reads lane by lane, and four words cost little more than one. Boxes have 32 bits in any
// program.
struct Node {
    // The bits of the lower corner, and the node after the node's subtree.
    lo_skip: vec4u,
    // The upper corner's bits, and 0 inside the tree; in a leaf the number of items in the upper four bits, and the first item in the
    // others.
    hi_leaf: vec4u,
}

var<storage, read> nodes: array<Node>;

const LEAF_FIRST: u32 = 0x0fffffffu;
const LEAF_SHIFT: u32 = 28u;

// The effect of rounding, relative to a coordinate. The host has grown all boxes by this fraction of their own coordinates.
const BOX_SLACK: Real = 2e-6;

// The chord of a segment, for tests against boxes.
struct Sweep {
    // Its start, moved up and down each axis by the bulge and by the effect of rounding.
    high: Real3,
    low: Real3,
    // The inverse of its extent.
    inverse: Real3,
}

fn segment_sweep(s: Segment) -> Sweep {
    return sweep_within(s, BOX_SLACK * abs(s.x0));
}

// Returns the sweep of a segment with the margin `slack` for rounding.
fn sweep_within(s: Segment, slack: Real3) -> Sweep {
    let d = s.x1 - s.x0;
    let inverse = 1.0 / select(d, Real3(1e-30), abs(d) < Real3(1e-30));
    let margin = segment_bulge(s) + slack;
    return Sweep(s.x0 + margin, s.x0 - margin, inverse);
}

fn corner(bits: vec4u) -> Real3 {
    return Real3(bitcast<vec3f>(bits.xyz));
}

// Returns the range in which the chord is inside the box, up to `limit`.
fn box_span(lo: Real3, hi: Real3, sweep: Sweep, limit: Real) -> Span {
    let t0 = (lo - sweep.high) * sweep.inverse;
    let t1 = (hi - sweep.low) * sweep.inverse;
    let near = min(t0, t1);
    let far = max(t0, t1);
    let enters = max(max(near.x, near.y), max(near.z, -overlap()));
    let leaves = min(min(far.x, far.y), min(far.z, min(limit, 1.0 + OVERLAP)));
    return Span(enters, leaves);
}

// A leaf whose box is met.
struct Leaf {
    // The range along the segment.
    span: Span,
    // The items of the leaf.
    first: u32,
    count: u32,
    // The node at which the walk continues.
    next: u32,
}

// Returns the next leaf from a node on, before `end`, that is met up to `limit`; without items if there is none, or no room for more loop
// iterations.
fn next_leaf(begin: u32, end: u32, sweep: Sweep, limit: Real) -> Leaf {
    var node = begin;
    var span = Span(0.0, 0.0);
    var leaf = 0u;
    while node < end && leaf == 0u && walk_has_room() {
        let box = nodes[node];
        span = box_span(corner(box.lo_skip), corner(box.hi_leaf), sweep, limit);
        let met = span.enters <= span.leaves;
        leaf = select(0u, box.hi_leaf.w, met);
        node = select(box.lo_skip.w, node + 1u, met && box.hi_leaf.w == 0u);
    }
    return Leaf(span, leaf & LEAF_FIRST, leaf >> LEAF_SHIFT, node);
}
