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
// Uses of random points.
const AIM: u32 = 2u;
const LAMP: u32 = 3u;
// What of all aimed rays goes to all lamps alike, however far and faint.
const ALIKE: f32 = 0.1;

// Behind an aimed ray, wherever it ended, the path's own may wait: which of the two it was is not known before all that is carried.
fn may_scatter(code: u32) -> bool {
    return code == HIT || code == ESCAPED || code == CAPTURED || code == ENDED;
}

// An aimed ray that met nothing has found the sky, if any light.
fn met_nothing(ray: Ray, pixel: vec2u) -> Ray {
    if carried.flight == OWN {
        return ray;
    }
    if ray.status == ESCAPED {
        let end = path_end(ray, Hit(0.0, NOTHING));
        filter_last(ray, end);
        gather(sky_radiance(vec3f(normalize(end.v))), end.x);
    }
    return own_ray(ray, pixel);
}

fn ended(ray: Ray, code: u32, pixel: vec2u) -> Ray {
    if carried.flight == AIMED {
        return own_ray(ray, pixel);
    }
    var next = ray;
    next.status = code;
    carried.flight = OVER;
    return next;
}

fn own_ray(ray: Ray, pixel: vec2u) -> Ray {
    let waiting = waiting_rays[place_of_path(pixel)];
    carried.flight = OWN;
    carried.share = waiting.share;
    carried.scatterings = waiting.scatterings;
    enter_set(waiting.bits);
    return sent_on(ray, waiting.x, waiting.v, waiting.tau, waiting.weight);
}

fn left_vertex(ray: Ray, vertex: PathVertex, onward: vec3f, density: f32, weight: vec3f, pixel: vec2u) -> Ray {
    let before = carried.weight;
    let aim = aimed_way(vertex, pixel);
    carried.scatterings += 1u;
    carried.share = 1.0;
    let own = vertex.speed * Real3(onward);
    if !answers_widely(vertex) {
        return sent_on(ray, vertex.x, own, vertex.tau, weight);
    }
    let share = density / max(density + aim_density(vertex, onward), 1e-30);
    waiting_rays[place_of_path(pixel)] =
        Waiting(vertex.x, vertex.tau, own, share, weight, carried.scatterings, region_bits());
    carried.flight = AIMED;
    carried.weight = before * answered(vertex, aim) / max(answer_density(vertex, aim) + aim_density(vertex, aim), 1e-30);
    if all(carried.weight <= vec3f(0.0)) || dot(aim, vertex.across) <= 0.0 {
        return own_ray(ray, pixel);
    }
    return gone_on(ray, vertex.x, vertex.speed * Real3(aim), vertex.tau, OFF_SURFACE);
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

fn aimed_way(vertex: PathVertex, pixel: vec2u) -> vec3f {
    let x = vec3f(vertex.x);
    let u = path_point(pixel, AIM);
    let count = arrayLength(&lamps);
    let all = brightness_of_all(x);
    var rest = path_point(pixel, LAMP).x;
    var chosen = 0u;
    for (var i = 0u; i < count; i++) {
        work += 1u;
        let share = mix(brightness(lamps[i], lamps[i].center - x) / all, 1.0 / f32(count), ALIKE);
        chosen = select(chosen, i, rest >= 0.0);
        rest -= share;
    }
    let way = lamps[chosen].center - x;
    let wide = cone(lamps[chosen], way).x;
    let off = u.x * wide;
    return way_about(normalize(way), 1.0 - off, sqrt(off * (2.0 - off)), u.y);
}

// Of an aimed ray's direction, per solid angle: of all lamps that it may have been drawn for.
fn aim_density(vertex: PathVertex, d: vec3f) -> f32 {
    let x = vec3f(vertex.x);
    let all = brightness_of_all(x);
    let alike = ALIKE / f32(arrayLength(&lamps));
    var sum = 0.0;
    for (var i = 0u; i < arrayLength(&lamps); i++) {
        work += 1u;
        let way = lamps[i].center - x;
        let wide = cone(lamps[i], way);
        let off = cross(d, normalize(way));
        let inside = wide.y >= 1.0 || (dot(off, off) <= wide.y && dot(d, way) > 0.0);
        let share = (1.0 - ALIKE) * brightness(lamps[i], way) / all + alike;
        sum += select(0.0, share / (2.0 * f32(PI) * wide.x), inside);
    }
    return sum;
}
