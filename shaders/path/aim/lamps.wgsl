// Aimed rays. A shadow ray assumes a straight line of sight; an aimed ray assumes nothing. At each vertex one more ray than the path's
// own leaves in a direction that is drawn towards a lamp, and is followed under the law like any other, off mirrors and through clear
// objects too. What it finds up to its first vertex counts, and nothing after that. Both rays may find the same light, so that each
// counts by the balance of the two densities where it left (Veach 1997), whatever the law does to it later: aims that miss cost time,
// and never bias.
//
// It flies first, in the same pixel's place; then the path goes back to the vertex for its own.

// The ball about a lamp.
struct Lamp {
    center: vec3f,
    radius: f32,
    // Its radiance times its area, of all colours together.
    power: f32,
}

@group(0) @binding(45) var<storage, read> lamps: array<Lamp>;

// The path's own ray, while an aimed one flies.
struct Waiting {
    x: Real3,
    tau: Real,
    v: Real3,
    share: f32,
    weight: vec3f,
    scatterings: u32,
    // The set of regions.
    bits: u32,
}

@group(0) @binding(44) var<storage, read_write> waiting_rays: array<Waiting>;

const AIMED: u32 = 2u;
// This use of random points.
const AIM: u32 = 2u;
// What of all aimed rays goes to all lamps alike, however far and faint.
const ALIKE: f32 = 0.1;

// Behind an aimed ray, wherever it ended, the path's own may wait: which of the two it was is not known before all that is carried.
fn may_scatter(code: u32) -> bool {
    return code == HIT || code == ESCAPED || code == CAPTURED || code == ENDED;
}

// Behind an aimed ray, which ended as `code` says, the path's own flies.
fn after_flight(leg: Leg, code: u32, pixel: vec2u) -> Leg {
    if leg.code == ALIVE || carried.flight != AIMED {
        return leg;
    }
    let waiting = waiting_rays[place_of_path(pixel)];
    carried.flight = OWN;
    carried.share = waiting.share;
    carried.scatterings = waiting.scatterings;
    enter_set(waiting.bits);
    return own_leg(waiting.x, waiting.v, waiting.tau, waiting.weight, code);
}

fn left_vertex(vertex: PathVertex, onward: vec3f, density: f32, weight: vec3f, pixel: vec2u) -> Leg {
    let total = brightness_of_all(vec3f(vertex.x));
    let aim = aimed_way(vertex, total, pixel);
    let both = answer_density(vertex, aim) + aim_density(vertex, total, aim);
    let aimed_weight = carried.weight * answered(vertex, aim) / max(both, 1e-30);
    let widely = answers_widely(vertex);
    let finds = widely && any(aimed_weight > vec3f(0.0)) && dot(aim, vertex.across) > 0.0;
    let share = density / max(density + aim_density(vertex, total, onward), 1e-30);
    let own = vertex.speed * Real3(onward);
    carried.scatterings += 1u;
    carried.share = select(1.0, share, widely);
    if !finds {
        return own_leg(vertex.x, own, vertex.tau, weight, HIT);
    }
    waiting_rays[place_of_path(pixel)] =
        Waiting(vertex.x, vertex.tau, own, share, weight, carried.scatterings, region_bits());
    carried.flight = AIMED;
    carried.share = 1.0;
    return own_leg(vertex.x, vertex.speed * Real3(aim), vertex.tau, aimed_weight, HIT);
}

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

fn brightness_of_all(x: vec3f) -> f32 {
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        work += 1u;
        sum += brightness(lamps[i], lamps[i].center - x);
    }
    return max(sum, 1e-30);
}

// How often a lamp is aimed at.
fn lamp_share(lamp: Lamp, way: vec3f, total: f32) -> f32 {
    return mix(brightness(lamp, way) / total, 1.0 / f32(arrayLength(&lamps)), ALIKE);
}

// The same number chooses the lamp and, stretched to what is left of it, the angle to its middle.
fn aimed_way(vertex: PathVertex, total: f32, pixel: vec2u) -> vec3f {
    let x = vec3f(vertex.x);
    let u = path_point(pixel, AIM);
    var chosen = 0u;
    var before = 0.0;
    var within = 1.0;
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        work += 1u;
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
fn aim_density(vertex: PathVertex, total: f32, d: vec3f) -> f32 {
    let x = vec3f(vertex.x);
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        work += 1u;
        let way = lamps[i].center - x;
        let wide = cone(lamps[i], way);
        let off = cross(d, normalize(way));
        let inside = wide.y >= 1.0 || (dot(off, off) <= wide.y && dot(d, way) > 0.0);
        sum += select(0.0, lamp_share(lamps[i], way, total) / (2.0 * f32(PI) * wide.x), inside);
    }
    return sum;
}
