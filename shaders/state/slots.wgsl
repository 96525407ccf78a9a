// Reading an ended ray's state from the slot that its status names, of two or three: `paper` keeps a segment's start while the other two
// ping-pong under its steps.

fn slot_state(slot: u32, pixel: vec2u) -> State {
    let first = chosen_state(state_at_0(pixel), state_at_1(pixel), slot == 1u);
    if !HAS_THREE_SLOTS {
        return first;
    }
    return chosen_state(first, state_at_2(pixel), slot == 2u);
}

fn slot_clock(slot: u32, pixel: vec2u) -> Real {
    let first = select(clock_at_0(pixel), clock_at_1(pixel), slot == 1u);
    if !HAS_THREE_SLOTS {
        return first;
    }
    return select(first, clock_at_2(pixel), slot == 2u);
}

fn slot_error(slot: u32, pixel: vec2u) -> Real {
    let first = select(error_at_0(pixel), error_at_1(pixel), slot == 1u);
    if !HAS_THREE_SLOTS {
        return first;
    }
    return select(first, error_at_2(pixel), slot == 2u);
}

fn slot_rest(slot: u32, pixel: vec2u) -> Real {
    let first = select(rest_at_0(pixel), rest_at_1(pixel), slot == 1u);
    if !HAS_THREE_SLOTS {
        return first;
    }
    return select(first, rest_at_2(pixel), slot == 2u);
}

fn slot_stretch(slot: u32, pixel: vec2u) -> Real {
    let first = select(stretch_at_0(pixel), stretch_at_1(pixel), slot == 1u);
    if !HAS_THREE_SLOTS {
        return first;
    }
    return select(first, stretch_at_2(pixel), slot == 2u);
}
