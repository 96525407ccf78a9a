// What shooting finds (G95 §6, his open problem): a path from a light to a place.

struct Shot {
    found: bool,
    // Its unit direction at the light, and at the place.
    leaves: Real3,
    arrives: Real3,
    // The area that the bundle about it has at the place, square to it, for each solid angle at the light.
    spread: Real,
    // What it misses the place by, as an angle at the light.
    error: Real,
}

const NO_SHOT: Shot = Shot(false, Real3(0.0), Real3(0.0), 0.0, 0.0);

// A search between two of its parts, each of which has room in an invocation.
struct ShotSearch {
    // As far as they are known.
    shot: Shot,
    // Where the path is nearest to the place: how far off, and its length up to there.
    offset: Real3,
    gap: Real,
    passed: Real,
    // How many parts are done, or that all are.
    parts: u32,
}

const SEARCHED: u32 = 64u;

// Two unit vectors square to d and to each other.
fn square_to(d: Real3) -> mat2x3<Real> {
    let other = select(Real3(1.0, 0.0, 0.0), Real3(0.0, 1.0, 0.0), abs(d.x) > 0.7);
    let a = normalize(cross(d, other));
    return mat2x3<Real>(a, cross(d, a));
}

// Where on a segment a place is nearest, as a fraction of it.
fn nearest_fraction(s: Segment, x: Real3) -> Real {
    let c = s.x1 - s.x0;
    let inverse = 1.0 / max(dot(c, c), 1e-30);
    var t = clamp(dot(x - s.x0, c) * inverse, 0.0, 1.0);
    t = clamp(t + dot(x - segment_point(s, t), c) * inverse, 0.0, 1.0);
    return clamp(t + dot(x - segment_point(s, t), c) * inverse, 0.0, 1.0);
}

fn shot_start(source: Real3, d: Real3) -> Ray {
    let phase = opaque_phase(law_start(source, d));
    return Ray(phase, 0.0, 0.0, first_memory(phase), 0.0, 0u, 0u, 0u, ALIVE);
}

// How near the path comes to the place, in parts of the distance between both. Nearer to it nothing is asked.
const REACH: Real = 1e-3;

// A path that was found, followed once more as any ray is, against what is opaque, from the light to the place.
fn shot_clear(source: Real3, d: Real3, place: Real3) -> bool {
    if !HAS_OBJECTS {
        return true;
    }
    rejoin();
    let reach = REACH * distance(source, place);
    var ray = shot_start(source, d);
    clear_last_hit();
    var there = false;
    var clear = true;
    for (var k = 0u; k < schedule.max_segments && clear && !there; k++) {
        if !has_room() {
            unfinished = true;
            break;
        }
        var next = ray;
        let s = follow_segment(&next);
        let t = nearest_fraction(s, place);
        there = distance(segment_point(s, t), place) < reach;
        let pieces = segment_pieces(s);
        let hit = first_met(s, pieces);
        let before = hit.primitive != NOTHING && (!there || hit.t < t);
        clear = !(before && distance(segment_point(s, hit.t), place) > reach);
        clear = clear && (there || open_status(s, next.tau, 0u) == ALIVE);
        ray = next;
    }
    walk_anew();
    return clear && there;
}
