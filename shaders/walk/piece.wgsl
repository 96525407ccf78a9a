// A segment's straight pieces share their ends exactly, so that no ray tunnels between two.

const BELOW_ONE: Real = 0.99999994;

fn piece_start(s: Segment, k: u32, pieces: u32) -> Real3 {
    return select(segment_point(s, Real(k) / Real(pieces)), s.x0, k == 0u);
}

fn piece_end(s: Segment, k: u32, pieces: u32) -> Real3 {
    return select(segment_point(s, Real(k + 1u) / Real(pieces)), s.x1, k + 1u == pieces);
}

// A fraction of piece k as one of its segment.
fn segment_fraction(k: u32, pieces: u32, t: Real) -> Real {
    return min((Real(k) + clamp(t, 0.0, 1.0)) / Real(pieces), BELOW_ONE);
}

// The nearer of a hit and what is met at `t`, or missed where that is 2; of two at the same place the lesser primitive, so that
// the order in which they are found does not matter.
fn nearer_hit(hit: Hit, t: Real, primitive: u32) -> Hit {
    let nearer = t < hit.t || (t == hit.t && t < 2.0 && primitive < hit.primitive);
    return Hit(select(hit.t, t, nearer), select(hit.primitive, primitive, nearer));
}

// The ray's status after a segment: hits come first, except that what lies inside a horizon is not seen.
fn segment_fate(s: Segment, tau: Real, index: u32, hit: Hit) -> u32 {
    if hit.primitive == NOTHING {
        return open_fate(s, tau, index);
    }
    return select(HIT, CAPTURED, law_captured(segment_point(s, hit.t), s.x1 - s.x0));
}
