// Aims at lamps: into the cone about each one's ball, as often as it is bright and near.

// The ball about a lamp.
struct Lamp {
    center: vec3f,
    radius: f32,
    // Its radiance times its area, of all colours together.
    power: f32,
}

var<storage, read> lamps: array<Lamp>;

// What of all rays that go to lamps goes to all alike, however far and faint.
const ALIKE: f32 = 0.1;

// A lamp from a place: 1 less the cosine of the angle to the edge of the ball about it, and the squared sine; all directions from inside
// of that.
fn cone(lamp: Lamp, way: vec3f) -> vec2f {
    let s = lamp.radius * lamp.radius / max(dot(way, way), 1e-30);
    return select(vec2f(2.0, 2.0), vec2f(s / (1.0 + sqrt(max(1.0 - s, 0.0))), s), s < 1.0);
}

// What a lamp gets of the rays that go to bright and near ones, before it is divided by that of all.
fn brightness(lamp: Lamp, way: vec3f) -> f32 {
    return lamp.power / max(dot(way, way), lamp.radius * lamp.radius);
}

fn lamps_brightness(vertex: PathVertex) -> f32 {
    let x = vec3f(vertex.x);
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        sum += brightness(lamps[i], lamps[i].center - x);
    }
    return max(sum, 1e-30);
}

// How often a lamp is aimed at.
fn lamp_share(lamp: Lamp, way: vec3f, total: f32) -> f32 {
    return mix(brightness(lamp, way) / total, 1.0 / f32(arrayLength(&lamps)), ALIKE);
}

// The same number chooses the lamp and, stretched to what is left of it, the angle to its middle.
fn lamps_way(vertex: PathVertex, total: f32, u: vec2f) -> vec3f {
    let x = vec3f(vertex.x);
    var chosen = 0u;
    var before = 0.0;
    var within = 1.0;
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        let share = lamp_share(lamps[i], lamps[i].center - x, total);
        let reached = u.x >= sum;
        chosen = select(chosen, i, reached);
        before = select(before, sum, reached);
        within = select(within, share, reached);
        sum += share;
    }
    let way = lamps[chosen].center - x;
    let wide = cone(lamps[chosen], way).x;
    let off = clamp((u.x - before) / within, 0.0, 1.0) * wide;
    return way_about(normalize(way), 1.0 - off, sqrt(off * (2.0 - off)), u.y);
}

// Of an aimed ray's direction, per solid angle: of all lamps that it may have been drawn for.
fn lamps_density(vertex: PathVertex, total: f32, d: vec3f) -> f32 {
    let x = vec3f(vertex.x);
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        let way = lamps[i].center - x;
        let wide = cone(lamps[i], way);
        let off = cross(d, normalize(way));
        let inside = wide.y >= 1.0 || (dot(off, off) <= wide.y && dot(d, way) > 0.0);
        sum += select(0.0, lamp_share(lamps[i], way, total) / (2.0 * f32(PI) * wide.x), inside);
    }
    return sum;
}
