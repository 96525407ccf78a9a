// Intersects a segment with static and moving objects. For each moving object the segment is transformed to the object's rest frame, where
// the object's motion bends it too: pieces are as short as both bends require within the tolerance of arcs.

// The tau of the segment under way.
var<private> segment_tau: Real;

struct MovingArcs {
    // The tolerance, in scene units.
    tolerance: Real,
}

var<uniform> moving_arcs: MovingArcs;

const MOVING_PIECES: Real = 64.0;

fn note_segment(tau: Real) {
    segment_tau = tau;
}

// Returns a bound on the distance of the segment in the rest frame from its chord: by its own bulge, and by the rotation during its time.
fn moving_sag(own: Travel, s: Segment) -> Real {
    let angle = abs(own.turning * s.h);
    let farthest = max(length(s.x0 - own.center), length(s.x1 - own.center));
    return length(segment_bulge(s)) + angle * (0.125 * angle * farthest + 0.25 * length(s.x1 - s.x0));
}

// Returns `true` if the chord from a to b comes within `reach` of a position.
fn passes(a: Real3, b: Real3, place: Real3, reach: Real) -> bool {
    let d = b - a;
    let t = clamp(dot(place - a, d) / max(dot(d, d), 1e-30), 0.0, 1.0);
    let miss = a + t * d - place;
    // Written so that NaN counts as within reach.
    return !(dot(miss, miss) > reach * reach);
}

fn is_near_moving(own: Travel, s: Segment) -> bool {
    let slack = 1e-5 * (length(s.x0) + length(s.x1) + own.reach);
    // Far from the whole orbit a segment may be long, and turn through more than this estimate covers.
    let around = passes(s.x0, s.x1, own.center, own.reach + length(segment_bulge(s)) + slack);
    let a = resting_place(own, s.x0, segment_tau);
    let b = resting_place(own, s.x1, segment_tau + s.h);
    return (around | (own.turning == 0.0)) & passes(a, b, own.middle, own.radius + moving_sag(own, s) + slack);
}

fn nearby(s: Segment) -> u32 {
    var near = items_near(s);
    for (var i = 0u; i < TRAVEL_COUNT; i++) {
        near |= select(0u, NEAR_STRUCTURE, is_near_moving(travels[i], s));
    }
    return near;
}

fn first_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    let still = walked_hit(s, near, pixel);
    var hit = Hit(select(still.t, 2.0, still.primitive == NOTHING), still.primitive);
    for (var i = 0u; i < TRAVEL_COUNT; i++) {
        let own = travels[i];
        let pieces = u32(clamp(ceil(sqrt(moving_sag(own, s) / moving_arcs.tolerance)), 1.0, MOVING_PIECES));
        var k = select(pieces, 0u, is_near_moving(own, s));
        var a = resting_place(own, s.x0, segment_tau);
        while k < pieces {
            let b = resting_place(own, piece_end(s, k, pieces), segment_tau + s.h * (Real(k + 1u) / Real(pieces)));
            let t = moving_fraction(own.item, a, b - a);
            hit = nearer_hit(hit, select(segment_fraction(k, pieces, t), 2.0, t > 1.5), own.item);
            a = b;
            // A piece with a hit is the last one.
            k = select(k + 1u, pieces, t <= 1.5);
        }
    }
    return Hit(select(hit.t, 0.0, hit.primitive == NOTHING), hit.primitive);
}
