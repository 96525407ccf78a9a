// A segment is its chord.

fn segment_pieces(s: Segment) -> u32 {
    return 1u;
}

fn segment_point(s: Segment, t: f32) -> vec3f {
    return mix(s.x0, s.x1, t);
}
