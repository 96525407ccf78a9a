// Which pixel an invocation works on, and the arguments of indirect dispatches.

struct Place {
    // Always one of the tile's, so that nothing outside it is ever read.
    pixel: vec2u,
    // Invocations past the end of the work have no pixel of their own.
    valid: bool,
}

struct Living {
    x: atomic<u32>,
    y: atomic<u32>,
    z: atomic<u32>,
    count: atomic<u32>,
}

// Of dispatches over the whole grid of pixels.
fn grid_pixel(group: vec3u, lane: u32) -> Place {
    let pixel = group.xy * vec2u(8u) + vec2u(lane % 8u, lane / 8u);
    let valid = all(pixel < frame.size);
    return Place(select(vec2u(0u), pixel, valid), valid);
}
