// Phase for laws of space alone: the columns are x and v.

alias Phase = mat2x3<Real>;

fn unpack_phase(state: State, pixel: vec2u) -> Phase {
    return Phase(state[0].xyz, state[1].xyz);
}

fn unpack_slot(state: State, slot: u32, pixel: vec2u) -> Phase {
    return Phase(state[0].xyz, state[1].xyz);
}

fn store_clock(pixel: vec2u, p: Phase) {
}

fn opaque_phase(p: Phase) -> Phase {
    return Phase(opaque3(p[0]), opaque3(p[1]));
}
