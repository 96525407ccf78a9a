// Treats a segment as its chord.

fn may_meet_objects(s: Segment) -> bool {
    return true;
}

fn segment_pieces(s: Segment) -> u32 {
    return 1u;
}

fn segment_bulge(s: Segment) -> Real3 {
    return Real3(0.0);
}

fn segment_point(s: Segment, t: Real) -> Real3 {
    return mix(s.x0, s.x1, t);
}
