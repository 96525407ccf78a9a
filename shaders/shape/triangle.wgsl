// Triangles in a bounding volume hierarchy: nodes in depth-first order, each with the node to go on with when it is missed,
// so that the walk needs no stack and may stop and go on anywhere.

const TRIANGLE: u32 = 0x40000000u;

struct Node {
    lo: Real3,
    // The node after this one's whole subtree.
    skip: u32,
    hi: Real3,
    // 0 inside the tree; in a leaf the number of triangles in the upper eight bits, the first of them in the others.
    leaf: u32,
}

struct Triangle {
    a: u32,
    b: u32,
    c: u32,
    object: u32,
}

struct Vertex {
    position: Real3,
    u: Real,
    normal: Real3,
    v: Real,
}

@group(0) @binding(84) var<storage, read> nodes: array<Node>;
@group(0) @binding(85) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(86) var<storage, read> vertices: array<Vertex>;
@group(0) @binding(87) var<storage, read> object_materials: array<u32>;

const LEAF_FIRST: u32 = 0x00ffffffu;

// Which side of the line along d through the origin the edge p → q passes, as a volume. Both triangles at an edge get the
// same number with opposite signs, whatever the rounding, because it is always computed from the lesser end: so no ray
// slips through between them (after Woop, Benthin and Wald 2013).
fn edge_side(d: Real3, p: Real3, q: Real3) -> Real {
    let swapped = q.x < p.x || (q.x == p.x && (q.y < p.y || (q.y == p.y && q.z < p.z)));
    let side = dot(d, cross(select(p, q, swapped), select(q, p, swapped)));
    return select(side, -side, swapped);
}

// The fraction of the piece from a along d, or 2.
fn triangle_fraction(i: u32, a: Real3, d: Real3) -> Real {
    let triangle = triangles[i];
    let p = vertices[triangle.a].position - a;
    let q = vertices[triangle.b].position - a;
    let r = vertices[triangle.c].position - a;
    let u = edge_side(d, p, q);
    let v = edge_side(d, q, r);
    let w = edge_side(d, r, p);
    let inside = min(u, min(v, w)) >= 0.0 || max(u, max(v, w)) <= 0.0;
    let n = cross(q - p, r - p);
    let through = dot(n, d);
    let t = dot(n, p) / through;
    let met = inside && through != 0.0 && may_cross(triangle.object, through) && !just_left(TRIANGLE | i);
    return select(2.0, t, met && t >= -overlap() && t <= 1.0 + OVERLAP);
}

// Does the piece from a, with 1/d given, meet the box before the fraction limit? The box is grown by what rounding may hide.
fn meets_box(node: Node, a: Real3, inverse: Real3, limit: Real) -> bool {
    let grown = 2e-6 * (max(abs(node.lo), abs(node.hi)) + abs(a));
    let t0 = (node.lo - grown - a) * inverse;
    let t1 = (node.hi + grown - a) * inverse;
    let near = min(t0, t1);
    let far = max(t0, t1);
    let enters = max(max(near.x, near.y), max(near.z, -overlap()));
    let leaves = min(min(far.x, far.y), min(far.z, min(limit, 1.0 + OVERLAP)));
    return enters <= leaves;
}

fn hit_triangle(a: Real3, b: Real3, best: Hit) -> Hit {
    var hit = best;
    let d = b - a;
    let inverse = 1.0 / select(d, Real3(1e-30), abs(d) < Real3(1e-30));
    let count = arrayLength(&nodes);
    var node = walk_begin();
    while node < count && walk_may_go_on() {
        work += 1u;
        let box = nodes[node];
        let met = meets_box(box, a, inverse, hit.t);
        let triangles_here = select(0u, box.leaf >> 24u, met);
        for (var i = 0u; i < triangles_here; i++) {
            work += 1u;
            let t = triangle_fraction((box.leaf & LEAF_FIRST) + i, a, d);
            if t < hit.t {
                hit = Hit(t, TRIANGLE | ((box.leaf & LEAF_FIRST) + i));
            }
        }
        node = select(box.skip, node + 1u, met && box.leaf == 0u);
    }
    walk_stop(node, count);
    return hit;
}

fn surface_triangle(i: u32, x: Real3) -> Surface {
    let triangle = triangles[i];
    let p = vertices[triangle.a];
    let q = vertices[triangle.b];
    let r = vertices[triangle.c];
    let n = cross(q.position - p.position, r.position - p.position);
    let across = normalize(n);
    // Barycentric coordinates of x in the triangle's plane.
    let nn = dot(n, n);
    let v = clamp(dot(n, cross(r.position - x, p.position - x)) / nn, 0.0, 1.0);
    let w = clamp(dot(n, cross(p.position - x, q.position - x)) / nn, 0.0, 1.0 - v);
    let u = 1.0 - v - w;
    let normal = normalize(u * p.normal + v * q.normal + w * r.normal);
    let uv = u * Real2(p.u, p.v) + v * Real2(q.u, q.v) + w * Real2(r.u, r.v);
    let gap = dot(across, x - p.position);
    return Surface(gap, 0.0, across, vec3f(normal), vec2f(uv), object_materials[triangle.object], triangle.object);
}
