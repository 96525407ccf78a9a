// Ambient occlusion (T 6.2): a position receives the fraction of the ambient light for which its hemisphere is open, weighted by the
// cosine. Each sample follows one direction, drawn like the diffuse one: along a straight line whatever the law, or along the law, which
// may bend the view of the surroundings, with the speed of the ray that sees the position. If that ray is captured or hits anything, no
// light comes along it.

struct Ambient {
    // The distance up to which objects occlude.
    distance: Real,
    // The fraction that remains if the hemisphere is closed.
    floor: f32,
    // The treatment of transparent objects, as for lights.
    shadows: u32,
}

var<uniform> ambient: Ambient;

// The number of this use of random points; other numbers are segments.
const OCCLUSION: u32 = 0x80000000u;

var<private> shaded_pixel: vec2u;

fn note_pixel(pixel: vec2u) {
    shaded_pixel = pixel;
}

fn open_part(lit: Lit) -> Share {
    let u = lobe_point(shaded_pixel, OCCLUSION);
    let open = open_share(lit, way_about(lit.normal, sqrt(1.0 - u.x), sqrt(u.x), u.y));
    return ambient.floor + (1.0 - ambient.floor) * open;
}

// The end of the ray that reached the position.
var<private> arrival: PathPoint;

fn note_arrival(end: PathPoint) {
    arrival = end;
}

fn open_share(lit: Lit, way: vec3f) -> Share {
    if !OCCLUDES_ALONG_LAW {
        return light_share(ambient.shadows, dot(way, lit.normal) > 0.0, lit.start, ambient.distance * Real3(way));
    }
    let before = region_bits();
    let phase = opaque_phase(law_start(lit.start, length(arrival.v) * Real3(way)));
    var ray = Ray(phase, arrival.tau, 0.0, first_memory(phase), 0.0, 0u, 0u, 0u, ALIVE);
    clear_last_hit();
    var passed: Real = 0.0;
    var met = false;
    for (var k = 0u; k < schedule.max_segments && passed < ambient.distance && !met && ray.status == ALIVE; k++) {
        if !has_room() {
            unfinished = true;
            break;
        }
        // The first segment begins on the surface; the later ones are contiguous.
        mark_line(k == 0u);
        var next = ray;
        let s = follow_segment(&next);
        let hit = first_met(s, segment_pieces(s));
        let part = segment_length(s);
        met = hit.primitive != NOTHING && passed + hit.t * part < ambient.distance;
        next.status = open_status(s, next.tau, k);
        passed += part;
        ray = next;
    }
    walk_anew();
    mark_line(false);
    enter_set(before);
    // A ray that ends farther away is not occluded.
    let ended = ray.status != ALIVE && ray.status != ESCAPED && ray.status != ENDED && passed < ambient.distance;
    unfinished = unfinished || (ended && !met && ray.status != CAPTURED);
    return select(Share(1.0), Share(0.0), met || ended);
}

// Approximate: between the length of its chord and the length of its Bézier polygon.
fn segment_length(s: Segment) -> Real {
    let chord = distance(s.x0, s.x1);
    let b1 = s.x0 + (s.h / 3.0) * s.v0;
    let b2 = s.x1 - (s.h / 3.0) * s.v1;
    return 0.5 * (chord + distance(s.x0, b1) + distance(b1, b2) + distance(b2, s.x1));
}
