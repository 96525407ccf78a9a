// The size of the step that a pass took, for the pass that intersects: an arc's tangents need it, and a chord no more than its ends.

fn store_taken(pixel: vec2u, h: Real) {
    if KEEPS_TAKEN {
        put_taken(pixel, h);
    }
}

fn taken_step(pixel: vec2u) -> Real {
    if KEEPS_TAKEN {
        return load_taken(pixel);
    }
    return 0.0;
}
