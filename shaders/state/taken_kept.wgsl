// An arc's tangents need the size of its step, from the pass that took it.

fn store_taken(pixel: vec2u, h: Real) {
    put_taken(pixel, h);
}

fn taken_step(pixel: vec2u) -> Real {
    return load_taken(pixel);
}
