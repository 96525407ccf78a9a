// Curves in closed form, as a tree of boxes (G95 §3.2, after Ballard's strip trees): a ray passes in one step over all of its curve that
// is near nothing, and only what is near something becomes an arc that is tested.
//
// Where a ray starts only moves its curve, so that one tree serves all rays of a picture (G95: "ray coherence"). The host builds it, and
// its boxes hold the whole of their pieces, by interval arithmetic. It is walked together with the hierarchy of the scene's objects:
// both trees from the root down, the ray's from its beginning on ("bvh/hier", G95 §4.3).

// Pieces lie one behind the other, so that where a node begins is known from the one before; and one whose next is the next in the list
// is a leaf.
struct RayNode {
    lo: vec3f,
    // The node after this one's subtree.
    skip: u32,
    hi: vec3f,
    // tau at the piece's end.
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

// Nodes of objects that a box is held against: one that has not been cleared by then counts as near.
const VISITS: u32 = 48u;
// Nodes of the ray in one step. A tree is at most `DEPTH` deep, and on the way down no level has more than two of them.
const NODES: u32 = 64u;
const DEPTH: u32 = 14u;
const CLEAR: u32 = 0xffffffffu;

// The first node of objects from `first` on that a box is about, or where the walk stopped; `first` if the box is not all in the bounding
// sphere, where paths end; CLEAR if there is none.
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
    // In tau.
    size: Real,
    // Is nothing near it?
    free: bool,
}

// The next piece of the curve: all up to the first leaf that is near something, or that leaf.
fn next_piece(p: Phase) -> Piece {
    let tau = f32(p[1].w);
    let anchor = vec3f(p[0].xyz - ray_curve(p[1].w)[0]);
    let slack = 2e-6 * abs(anchor);
    // Ends that rounding moves.
    let unit = 1e-6 * f32(limit.length);
    let count = arrayLength(&ray_nodes);
    var reached = tau;
    var end = f32(limit.length);
    var node = 0u;
    var begin = 0.0;
    // What a piece is near, its parts are not near anything before; up to this node they are its parts.
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
    // A closed curve may lead back to where it began: the ray stands still only if it does so everywhere.
    if all(end[0].xyz == ray.phase[0].xyz) {
        h *= 0.618;
        end = retaken_step(ray.phase, h);
    }
    var next = after_step(ray, end, h);
    // A stretch that is clear of all objects is not tested as an arc.
    next.taken = select(next.taken, 0.0, piece.free);
    return next;
}
