// Which pixel an invocation works on, and the arguments of indirect dispatches.

struct Place {
    pixel: vec2u,
    // Invocations past the end of the work have none.
    valid: bool,
}

struct Living {
    x: atomic<u32>,
    y: atomic<u32>,
    z: atomic<u32>,
    count: atomic<u32>,
}
