// Samples emitters: directions in the cone around each emitter's bounding sphere, with a frequency that follows its brightness and
// distance.

// The bounding sphere of an emitter.
struct Emitter {
    center: vec3f,
    radius: f32,
    // Its radiance times its area, summed over the colors.
    power: f32,
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
    let wide = cone(emitters[chosen], way).x;
    let off = clamp((u.x - before) / within, 0.0, 1.0) * wide;
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
        sum += select(0.0, emitter_share(emitters[i], way, total) / (2.0 * f32(PI) * wide.x), inside);
    }
    return sum;
}
