// Intersects a segment with a scene in which nothing moves. Segments that lead through a whole region that contains nothing else are not
// walked: they end on its surface.

fn nearby(s: Segment) -> u32 {
    if !HAS_OBJECTS {
        return 0u;
    }
    if HAS_LEAPS {
        return select(items_near(s), 0xffffffffu, leaps());
    }
    return items_near(s);
}

fn first_hit(s: Segment, near: u32, pixel: vec2u) -> Hit {
    if !HAS_OBJECTS {
        return Hit(0.0, NOTHING);
    }
    if HAS_LEAPS {
        if leaps() {
            return leap_hit(s);
        }
    }
    return walked_hit(s, near, pixel);
}
