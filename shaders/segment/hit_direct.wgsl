// Every segment is walked.

fn first_hit(s: Segment, pixel: vec2u) -> Hit {
    return walked_hit(s, pixel);
}
