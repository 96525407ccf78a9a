// Every segment is walked.

fn nearby(s: Segment) -> u32 {
    return items_near(s);
}

fn first_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    return walked_hit(s, near, pixel);
}
