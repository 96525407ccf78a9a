// What is filtered is the light on a ray's own path.

fn track_place(p: Phase, h: Real) -> Real4 {
    return path_place(p, h);
}

fn track_pace(p: Phase) -> Real {
    return path_pace(p);
}

fn take_piece(filter_at: Filter, x: Real3, depth: vec4f) {
    pass_piece(filter_at, x, depth);
}
