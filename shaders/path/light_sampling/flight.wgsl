// Next-event estimation under any law. A shadow ray assumes a straight line of sight; an aimed ray assumes nothing. At each vertex one ray
// in addition to the path leaves in a direction that is drawn towards light, and is followed under the law like any other, also off mirrors
// and through transparent objects. Light that it finds up to its first vertex counts, and nothing after that. Both rays may find the same
// light, so that each is weighted by the balance of the two densities where it left (Veach 1997), whatever the law does to it later: rays
// that miss cost time, but the result is unbiased.
//
// The aimed ray is followed first, in the storage of the pixel; then the path continues from the vertex. Its own ray is in memory only
// between passes.

// The path's own ray, while an aimed ray is followed.
struct Waiting {
    x: Real3,
    tau: Real,
    v: Real3,
    share: f32,
    throughput: vec3f,
    scatterings: u32,
    // The set of regions.
    bits: u32,
    dispersed: u32,
}

var<storage, read_write> pixel_waiting: array<Waiting>;

var<private> waiting: Waiting;

const AIMED: u32 = 2u;
// The number of this use of random points.
const AIM: u32 = 2u;

fn load_waiting(pixel: vec2u) {
    waiting = pixel_waiting[place_in_tile(pixel)];
}

fn store_waiting(pixel: vec2u) {
    pixel_waiting[place_in_tile(pixel)] = waiting;
}

// Returns `true` also after a ray that met no surface: it may have found light from the sky, and if it was an aimed ray, the path's own ray
// is waiting. Which of the two rays ended is known only after all of its state is loaded.
fn may_scatter(code: u32) -> bool {
    if !AIMS {
        return code == HIT || code == ESCAPED;
    }
    return code == HIT || code == ESCAPED || code == CAPTURED || code == ENDED;
}

// Returns the path's own ray, after an aimed ray that ended with the status `code`.
fn after_flight(leg: Leg, code: u32) -> Leg {
    if !AIMS {
        return leg;
    }
    if leg.code == ALIVE || carried.flight != AIMED {
        return leg;
    }
    carried.flight = OWN;
    carried.share = waiting.share;
    carried.scatterings = waiting.scatterings;
    carried.dispersed = waiting.dispersed;
    enter_set(waiting.bits);
    return own_leg(waiting.x, waiting.v, waiting.tau, waiting.throughput, code);
}

fn left_vertex(vertex: PathVertex, onward: vec3f, density: f32, throughput: vec3f, pixel: vec2u) -> Leg {
    if !AIMS {
        carried.scatterings += 1u;
        return own_leg(vertex.x, vertex.speed * Real3(onward), vertex.tau, throughput, HIT);
    }
    let aims = aims_at(vertex);
    let aim = aimed_way(vertex, aims, path_point(pixel, AIM));
    let aimed = aim_density(vertex, aims, aim);
    let aimed_throughput = carried.throughput * bsdf_cosine(vertex, aim) / max(bsdf_density(vertex, aim) + aimed, 1e-30);
    let finds = bsdf_is_wide(vertex) && aimed > 0.0 && any(aimed_throughput > vec3f(0.0)) && dot(aim, vertex.normal) > 0.0;
    let share = density / max(density + aim_density(vertex, aims, onward), 1e-30);
    let own = vertex.speed * Real3(onward);
    carried.scatterings += 1u;
    carried.share = select(1.0, share, bsdf_is_wide(vertex));
    if !finds {
        return own_leg(vertex.x, own, vertex.tau, throughput, HIT);
    }
    waiting = Waiting(vertex.x, vertex.tau, own, share, throughput, carried.scatterings, region_bits(), carried.dispersed);
    carried.flight = AIMED;
    carried.share = 1.0;
    return own_leg(vertex.x, vertex.speed * Real3(aim), vertex.tau, aimed_throughput, HIT);
}
