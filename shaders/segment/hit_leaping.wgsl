// Segments that lead through a whole region, in which nothing else is, are not walked: they end on its surface.

fn first_hit(s: Segment, pixel: vec2u) -> Hit {
    if leaps() {
        return leap_hit(s);
    }
    return walked_hit(s, pixel);
}
