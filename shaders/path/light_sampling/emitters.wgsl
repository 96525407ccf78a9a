// Samples emitters: points on the visible faces of an emitter's bounding box, or directions in the cone around its bounding sphere, with a
// frequency that follows its brightness and distance.

// The bounding volumes of an emitter.
struct Emitter {
    // The center of both.
    center: vec3f,
    // The radius of the sphere.
    radius: f32,
    // Half the edges of the box, and the rows of the map from the scene to the cube |x|, |y|, |z| ≤ 1.
    edge_x: vec3f,
    // Its radiance times its area, summed over the colors.
    power: f32,
    edge_y: vec3f,
    // The volume of the box; 0 if the sphere is sampled.
    volume: f32,
    edge_z: vec3f,
    row_x: vec3f,
    row_y: vec3f,
    row_z: vec3f,
}

// The bounding box of an emitter from a position.
struct BoxView {
    // The position in the coordinates of the cube.
    x: vec3f,
    // The approximate share of each face pair in the solid angle of the visible faces, x, y, z; 0 if the sphere is sampled.
    shares: vec3f,
}

var<storage, read> emitters: array<Emitter>;

// The share of samples that is divided equally among emitters, however far and faint they are.
const ALIKE: f32 = 0.1;

// Returns the cone of an emitter from a position: one minus the cosine of the angle to the edge of its bounding sphere, and the squared
// sine; all directions from inside the sphere.
fn cone(emitter: Emitter, way: vec3f) -> vec2f {
    let s = emitter.radius * emitter.radius / max(dot(way, way), 1e-30);
    return select(vec2f(2.0, 2.0), vec2f(s / (1.0 + sqrt(max(1.0 - s, 0.0))), s), s < 1.0);
}

// The largest distance, in radii, at which a box is sampled: beyond it, rounded directions may miss the box.
const FARTHEST_BOX: f32 = 1e4;

// Returns the share of a face at `to` from a position, before normalization; above: the distance of the position from its plane, in
// multiples that are equal for all faces after multiplication by their areas.
fn face_share(above: f32, to: vec3f) -> f32 {
    let d2 = dot(to, to);
    return max(above, 0.0) / max(d2 * sqrt(d2), 1e-30);
}

fn box_view(emitter: Emitter, way: vec3f) -> BoxView {
    let x = -vec3f(dot(emitter.row_x, way), dot(emitter.row_y, way), dot(emitter.row_z, way));
    let side = sign(x);
    let above = abs(x) - 1.0;
    let shares = vec3f(
        face_share(above.x, way + side.x * emitter.edge_x),
        face_share(above.y, way + side.y * emitter.edge_y),
        face_share(above.z, way + side.z * emitter.edge_z));
    let sum = shares.x + shares.y + shares.z;
    let farthest = FARTHEST_BOX * emitter.radius;
    let is_sampled = (emitter.volume > 0.0) & (sum > 0.0) & (dot(way, way) < farthest * farthest);
    return BoxView(x, select(vec3f(0.0), shares / max(sum, 1e-30), is_sampled));
}

// Returns the direction to a point on a visible face. One number chooses the face and, rescaled, the first coordinate on it.
fn box_way(emitter: Emitter, view: BoxView, way: vec3f, u: vec2f) -> vec3f {
    let on_z = u.x >= view.shares.x + view.shares.y;
    let on_y = u.x >= view.shares.x && !on_z;
    var first = u.x / max(view.shares.x, 1e-30);
    first = select(first, (u.x - view.shares.x) / max(view.shares.y, 1e-30), on_y);
    first = select(first, (u.x - view.shares.x - view.shares.y) / max(view.shares.z, 1e-30), on_z);
    let on_face = 2.0 * vec2f(clamp(first, 0.0, 1.0), u.y) - 1.0;
    let side = sign(view.x);
    var p = vec3f(side.x, on_face);
    p = select(p, vec3f(on_face.x, side.y, on_face.y), on_y);
    p = select(p, vec3f(on_face, side.z), on_z);
    return normalize(way + p.x * emitter.edge_x + p.y * emitter.edge_y + p.z * emitter.edge_z);
}

// Returns the density of the direction d, per solid angle: of points on the face through which it enters the box.
fn box_density(emitter: Emitter, view: BoxView, d: vec3f) -> f32 {
    let along = vec3f(dot(emitter.row_x, d), dot(emitter.row_y, d), dot(emitter.row_z, d));
    let inverse = 1.0 / select(along, vec3f(1e-30), abs(along) < vec3f(1e-30));
    let enters = -view.x * inverse - abs(inverse);
    let leaves = -view.x * inverse + abs(inverse);
    let t = max(enters.x, max(enters.y, enters.z));
    let hits = t > 0.0 && t <= min(leaves.x, min(leaves.y, leaves.z));
    var face = vec2f(view.shares.x, inverse.x);
    face = select(face, vec2f(view.shares.y, inverse.y), enters.y == t);
    face = select(face, vec2f(view.shares.z, inverse.z), enters.z == t);
    return select(0.0, 2.0 * face.x * t * t * abs(face.y) / max(emitter.volume, 1e-30), hits);
}

// Returns an emitter's share of the samples for bright and near emitters, before normalization.
fn brightness(emitter: Emitter, way: vec3f) -> f32 {
    return emitter.power / max(dot(way, way), emitter.radius * emitter.radius);
}

fn emitters_brightness(vertex: PathVertex) -> f32 {
    let x = vec3f(vertex.x);
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&emitters); i++) {
        sum += brightness(emitters[i], emitters[i].center - x);
    }
    return max(sum, 1e-30);
}

// Returns the probability that an emitter is sampled.
fn emitter_share(emitter: Emitter, way: vec3f, total: f32) -> f32 {
    return mix(brightness(emitter, way) / total, 1.0 / f32(arrayLength(&emitters)), ALIKE);
}

// One number chooses the emitter and, rescaled, the angle to its center.
fn emitters_way(vertex: PathVertex, total: f32, u: vec2f) -> vec3f {
    let x = vec3f(vertex.x);
    var chosen = 0u;
    var before = 0.0;
    var within = 1.0;
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&emitters); i++) {
        let share = emitter_share(emitters[i], emitters[i].center - x, total);
        let reached = u.x >= sum;
        chosen = select(chosen, i, reached);
        before = select(before, sum, reached);
        within = select(within, share, reached);
        sum += share;
    }
    let way = emitters[chosen].center - x;
    let own = clamp((u.x - before) / within, 0.0, 1.0);
    if EMITS_FROM_BOXES {
        let view = box_view(emitters[chosen], way);
        if any(view.shares > vec3f(0.0)) {
            return box_way(emitters[chosen], view, way, vec2f(own, u.y));
        }
    }
    let wide = cone(emitters[chosen], way).x;
    let off = own * wide;
    return way_about(normalize(way), 1.0 - off, sqrt(off * (2.0 - off)), u.y);
}

// Returns the density of an aimed ray's direction, per solid angle: summed over all emitters for which it may have been drawn.
fn emitters_density(vertex: PathVertex, total: f32, d: vec3f) -> f32 {
    let x = vec3f(vertex.x);
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&emitters); i++) {
        let way = emitters[i].center - x;
        let wide = cone(emitters[i], way);
        let off = cross(d, normalize(way));
        let inside = wide.y >= 1.0 || (dot(off, off) <= wide.y && dot(d, way) > 0.0);
        var density = select(0.0, 1.0 / (2.0 * f32(PI) * wide.x), inside);
        if EMITS_FROM_BOXES {
            let view = box_view(emitters[i], way);
            density = select(density, box_density(emitters[i], view, d), any(view.shares > vec3f(0.0)));
        }
        sum += emitter_share(emitters[i], way, total) * density;
    }
    return sum;
}
