// Reading an ended ray's state from the slot that its status names, of two.

fn slot_state(slot: u32, pixel: vec2u) -> State {
    return chosen_state(state_at_0(pixel), state_at_1(pixel), slot == 1u);
}

fn slot_clock(slot: u32, pixel: vec2u) -> Real {
    return select(clock_at_0(pixel), clock_at_1(pixel), slot == 1u);
}

fn slot_error(slot: u32, pixel: vec2u) -> Real {
    return select(error_at_0(pixel), error_at_1(pixel), slot == 1u);
}

fn slot_rest(slot: u32, pixel: vec2u) -> Real {
    return select(rest_at_0(pixel), rest_at_1(pixel), slot == 1u);
}

fn slot_stretch(slot: u32, pixel: vec2u) -> Real {
    return select(stretch_at_0(pixel), stretch_at_1(pixel), slot == 1u);
}
