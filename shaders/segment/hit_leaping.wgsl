// Segments that lead through a whole region, in which nothing else is, are not walked: they end on its surface.

fn nearby(s: Segment) -> u32 {
    return select(items_near(s), 0xffffffffu, leaps());
}

fn first_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    if leaps() {
        return leap_hit(s);
    }
    return walked_hit(s, near, pixel);
}
