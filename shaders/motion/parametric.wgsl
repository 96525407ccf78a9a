// Curves in closed form, as a tree of boxes (G95 §3.2, after Ballard's strip trees): a ray passes in one step over the part of its curve
// that is near no object, and only the rest becomes arcs that are tested.
//
// The start of a ray only shifts its curve, so that one tree serves all rays of an image (G95: "ray coherence"). The host builds it, and
// its boxes contain their pieces entirely, by interval arithmetic. It is traversed together with the hierarchy of the scene's objects: both
// trees from the root down, and the ray's tree from its beginning on ("bvh/hier", G95 §4.3).

// Pieces are contiguous, so that the beginning of a node is the end of the one before. A node whose `skip` is the next node in the list is
// a leaf.
struct RayNode {
    lo: vec3f,
    // The node after this one's subtree.
    skip: u32,
    hi: vec3f,
    // The tau at the end of the piece.
    end: f32,
}

var<storage, read> ray_nodes: array<RayNode>;

struct ObjectNode {
    lo: vec3f,
    // The node after this one's subtree.
    skip: u32,
    hi: vec3f,
    leaf: u32,
}

var<storage, read> object_nodes: array<ObjectNode>;

// The number of object nodes that a box is compared with: a box that has not been cleared by then counts as near.
const VISITS: u32 = 48u;
// The number of ray nodes in one step. A tree is at most `DEPTH` deep, and on the way down no level has more than two of them.
const NODES: u32 = 64u;
const DEPTH: u32 = 14u;
const CLEAR: u32 = 0xffffffffu;

// Returns the first object node from `first` on that a box overlaps, or the node where the walk stopped; `first` if the box is not entirely
// inside the bounding sphere, where paths end; CLEAR if there is none.
fn box_near(lo: vec3f, hi: vec3f, first: u32) -> u32 {
    let far = max(abs(lo - vec3f(bound.center)), abs(hi - vec3f(bound.center)));
    let count = arrayLength(&object_nodes);
    var node = first;
    var near = dot(far, far) > f32(bound.radius) * f32(bound.radius);
    for (var k = 0u; k < VISITS && node < count && !near; k++) {
        let own = object_nodes[node];
        let overlaps = all(lo <= own.hi) && all(hi >= own.lo);
        near = overlaps && own.leaf == 1u;
        node = select(select(own.skip, node + 1u, overlaps), node, near);
    }
    return select(CLEAR, node, near || node < count);
}

struct Piece {
    // The size, in tau.
    size: Real,
    // True if no object is near it.
    free: bool,
}

// Returns the next piece of the curve: everything up to the first leaf that is near an object, or that leaf.
fn next_piece(p: Phase) -> Piece {
    let tau = f32(p[1].w);
    let anchor = vec3f(p[0].xyz - ray_curve(p[1].w)[0]);
    let slack = 2e-6 * abs(anchor);
    // The distance by which rounding may move the ends.
    let unit = 1e-6 * f32(limit.length);
    let count = arrayLength(&ray_nodes);
    var reached = tau;
    var end = f32(limit.length);
    var node = 0u;
    var begin = 0.0;
    // The search for the parts of a piece starts at the first object near the piece; the parts end at node `parts_end`.
    var first = 0u;
    var parts_end = 0u;
    for (var k = 0u; k < NODES && node < count; k++) {
        let own = ray_nodes[node];
        first = select(0u, first, node < parts_end);
        let passed = own.end <= reached + unit;
        var near = 0u;
        if !passed && begin >= reached - unit {
            near = box_near(own.lo + anchor - slack, own.hi + anchor + slack, first);
            first = select(near, first, near == CLEAR);
            parts_end = select(own.skip, parts_end, near == CLEAR);
        }
        if passed || near == CLEAR {
            reached = select(reached, own.end, near == CLEAR);
            begin = own.end;
            node = own.skip;
        } else if own.skip == node + 1u {
            end = own.end;
            break;
        } else {
            node += 1u;
        }
    }
    let free = reached > tau + unit;
    return Piece(Real(select(end, reached, free)) - p[1].w, free);
}

fn retaken_step(p: Phase, h: Real) -> Phase {
    let here = ray_curve(p[1].w);
    let there = ray_curve(p[1].w + h);
    return Phase(Real4(p[0].xyz + (there[0] - here[0]), 0.0), Real4(there[1], p[1].w + h));
}

fn accepted_step(ray: Ray) -> Ray {
    let piece = next_piece(ray.phase);
    var h = limited_step(piece.size, ray);
    var end = retaken_step(ray.phase, h);
    // A closed curve may return to its start: the ray does not move only if all of its points agree.
    if all(end[0].xyz == ray.phase[0].xyz) {
        h *= 0.618;
        end = retaken_step(ray.phase, h);
    }
    var next = after_step(ray, end, h);
    // A stretch that is clear of all objects is not tested as an arc.
    next.taken = select(next.taken, 0.0, piece.free);
    return next;
}
