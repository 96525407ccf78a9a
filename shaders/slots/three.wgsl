// Reading an ended ray's state from the slot that its status names, of three: `paper` keeps a segment's start while the
// other two ping-pong under its steps.

fn slot_x(slot: u32, pixel: vec2u) -> Real4 {
    let first = select(x_at_0(pixel), x_at_1(pixel), slot == 1u);
    return select(first, x_at_2(pixel), slot == 2u);
}

fn slot_v(slot: u32, pixel: vec2u) -> Real4 {
    let first = select(v_at_0(pixel), v_at_1(pixel), slot == 1u);
    return select(first, v_at_2(pixel), slot == 2u);
}

fn slot_clock(slot: u32, pixel: vec2u) -> Real {
    let first = select(clock_at_0(pixel), clock_at_1(pixel), slot == 1u);
    return select(first, clock_at_2(pixel), slot == 2u);
}

fn slot_error(slot: u32, pixel: vec2u) -> Real {
    let first = select(error_at_0(pixel), error_at_1(pixel), slot == 1u);
    return select(first, error_at_2(pixel), slot == 2u);
}
