// A segment's straight pieces share their ends exactly, so that no ray tunnels between two.

const BELOW_ONE: f32 = 0.99999994;

fn piece_end(s: Segment, k: u32, pieces: u32) -> vec3f {
    return select(segment_point(s, f32(k + 1u) / f32(pieces)), s.x1, k + 1u == pieces);
}

// A fraction of piece k as one of its segment.
fn segment_fraction(k: u32, pieces: u32, t: f32) -> f32 {
    return min((f32(k) + clamp(t, 0.0, 1.0)) / f32(pieces), BELOW_ONE);
}

// The ray's status after a segment: hits come first, except that what lies inside a horizon is not seen.
fn segment_fate(s: Segment, tau: f32, index: u32, hit: Hit) -> u32 {
    if hit.primitive == NOTHING {
        return open_fate(s, tau, index);
    }
    return select(HIT, CAPTURED, law_captured(segment_point(s, hit.t), s.x1 - s.x0));
}
