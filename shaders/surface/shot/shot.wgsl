// The result of the shooting method (G95 §6, an open problem there): a path from a light to a position.

struct Shot {
    found: bool,
    // The unit direction of the path at the light, and at the position.
    leaves: Real3,
    arrives: Real3,
    // The area of the ray bundle around it at the position, perpendicular to it, per solid angle at the light.
    spread: Real,
    // The distance by which it misses the position, as an angle at the light.
    error: Real,
}

const NO_SHOT: Shot = Shot(false, Real3(0.0), Real3(0.0), 0.0, 0.0);

// The state of a search between two of its parts, each of which fits into an invocation.
struct ShotSearch {
    // The members that are known so far.
    shot: Shot,
    // The offset of the path from the position at its nearest point, and its length up to there.
    offset: Real3,
    gap: Real,
    passed: Real,
    // The number of finished parts, or a number that means that all are.
    parts: u32,
}

const SEARCHED: u32 = 64u;

// Returns two unit vectors perpendicular to d and to each other.
fn square_to(d: Real3) -> mat2x3<Real> {
    let other = select(Real3(1.0, 0.0, 0.0), Real3(0.0, 1.0, 0.0), abs(d.x) > 0.7);
    let a = normalize(cross(d, other));
    return mat2x3<Real>(a, cross(d, a));
}

// Returns the fraction of a segment at its nearest point to a position.
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

// The end of the tested stretch: within this fraction of the distance from light to position nothing is tested.
const REACH: Real = 1e-3;

// Follows a path that was found once more, like any ray, and returns `true` if nothing opaque is between the light and the position.
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
