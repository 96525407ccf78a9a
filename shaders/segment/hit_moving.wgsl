// Beside what rests some objects move. Against each the segment is held in that object's own rest, where the segment is bent by the object's
// way as well: where both stay within the arcs' tolerance of a chord is a piece.

// Of the segment under way.
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

// How far the segment at rest is from its chord, at most: by its own bulge, and by turning through the angle of its time.
fn moving_sag(own: Travel, s: Segment) -> Real {
    let angle = abs(own.turning * s.h);
    let farthest = max(length(s.x0 - own.center), length(s.x1 - own.center));
    return length(segment_bulge(s)) + angle * (0.125 * angle * farthest + 0.25 * length(s.x1 - s.x0));
}

// Does the chord from a to b come so near to a place?
fn passes(a: Real3, b: Real3, place: Real3, reach: Real) -> bool {
    let d = b - a;
    let t = clamp(dot(place - a, d) / max(dot(d, d), 1e-30), 0.0, 1.0);
    let miss = a + t * d - place;
    // So that what is no number does.
    return !(dot(miss, miss) > reach * reach);
}

fn is_near_moving(own: Travel, s: Segment) -> bool {
    let slack = 1e-5 * (length(s.x0) + length(s.x1) + own.reach);
    // Far from all of an orbit a segment may be long, and turn through more than this knows.
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
            // A piece that meets it is the last one.
            k = select(k + 1u, pieces, t <= 1.5);
        }
    }
    return Hit(select(hit.t, 0.0, hit.primitive == NOTHING), hit.primitive);
}
