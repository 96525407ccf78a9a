// Intersects triangles, which are always in the acceleration structure.

// The data that a segment is tested against, contiguous in memory.
struct Corners {
    p: Real3,
    // The bit of its object in the set of regions, or NO_BIT.
    bit: u32,
    q: Real3,
    r: Real3,
}

var<storage, read> corners: array<Corners>;

// The data of surfaces, in words: for each triangle the start of its vertices, its object and that object's material; then for each vertex
// its normal, u and v, and its color if any mesh has colors.
var<storage, read> mesh: array<u32>;

const TRIANGLE_WORDS: u32 = 5u;

struct Vertex {
    normal: Real3,
    uv: Real2,
}

fn mesh_vector(at: u32) -> vec3f {
    return bitcast<vec3f>(vec3u(mesh[at], mesh[at + 1u], mesh[at + 2u]));
}

fn mesh_vertex(at: u32) -> Vertex {
    return Vertex(Real3(mesh_vector(at)), Real2(bitcast<vec2f>(vec2u(mesh[at + 3u], mesh[at + 4u]))));
}

// Returns the side on which the line along d through the origin passes the edge p → q, as a volume. Both triangles at an edge get the same
// number with opposite signs, whatever the rounding, because it is always computed from the lesser end: so no ray slips through between
// them (after Woop, Benthin and Wald 2013).
fn edge_side(d: Real3, p: Real3, q: Real3) -> Real {
    let swapped = q.x < p.x || (q.x == p.x && (q.y < p.y || (q.y == p.y && q.z < p.z)));
    let side = dot(d, cross(select(p, q, swapped), select(q, p, swapped)));
    return select(side, -side, swapped);
}

// The intersection of a line with a triangle.
struct Meeting {
    // The fraction of its piece, or 2.
    t: Real,
    // Above 0 if the line leaves through the triangle.
    through: Real,
}

fn meet_triangle(i: u32, a: Real3, d: Real3) -> Meeting {
    let p = corners[i].p - a;
    let q = corners[i].q - a;
    let r = corners[i].r - a;
    let u = edge_side(d, p, q);
    let v = edge_side(d, q, r);
    let w = edge_side(d, r, p);
    let inside = min(u, min(v, w)) >= 0.0 || max(u, max(v, w)) <= 0.0;
    let n = cross(q - p, r - p);
    let through = dot(n, d);
    let t = dot(n, p) / through;
    return Meeting(select(2.0, t, inside && through != 0.0 && t >= -overlap() && t <= 1.0 + OVERLAP), through);
}

// Returns the fraction of the piece from a along d, or 2.
fn triangle_fraction(i: u32, a: Real3, d: Real3) -> Real {
    let meeting = meet_triangle(i, a, d);
    let met = may_cross(corners[i].bit, meeting.through) && !is_last_hit(TRIANGLE | i);
    return select(2.0, meeting.t, met);
}

// Returns the barycentric coordinates of a point in the triangle's plane.
fn triangle_shares(p: Real3, q: Real3, r: Real3, x: Real3) -> Real3 {
    let n = cross(q - p, r - p);
    let nn = dot(n, n);
    let v = clamp(dot(n, cross(r - x, p - x)) / nn, 0.0, 1.0);
    let w = clamp(dot(n, cross(p - x, q - x)) / nn, 0.0, 1.0 - v);
    return Real3(1.0 - v - w, v, w);
}

fn mesh_vertices(i: u32) -> array<Vertex, 3> {
    let at = TRIANGLE_WORDS * i;
    return array<Vertex, 3>(mesh_vertex(mesh[at]), mesh_vertex(mesh[at + 1u]), mesh_vertex(mesh[at + 2u]));
}

fn surface_triangle(i: u32, x: Real3) -> Surface {
    let place = corners[i];
    let v = mesh_vertices(i);
    let normal = normalize(cross(place.q - place.p, place.r - place.p));
    let share = triangle_shares(place.p, place.q, place.r, x);
    let shading_normal = normalize(share.x * v[0].normal + share.y * v[1].normal + share.z * v[2].normal);
    let uv = share.x * v[0].uv + share.y * v[1].uv + share.z * v[2].uv;
    let signed_distance = dot(normal, x - place.p);
    if HAS_VERTEX_COLORS {
        note_corners(i, share);
    }
    let at = TRIANGLE_WORDS * i;
    return Surface(signed_distance, 0.0, normal, vec3f(shading_normal), vec2f(uv), mesh[at + 4u], mesh[at + 3u]);
}
