// Phase for laws that carry time: the columns are (x, t) and (v, ṫ). The scene is stationary, so that only ṫ is kept
// between passes (W04 App. A), beside the state.

alias Phase = mat2x4<Real>;

fn unpack_phase(state: State, pixel: vec2u) -> Phase {
    return Phase(Real4(state[0].xyz, 0.0), Real4(state[1].xyz, load_clock(pixel)));
}

fn unpack_slot(state: State, slot: u32, pixel: vec2u) -> Phase {
    return Phase(Real4(state[0].xyz, 0.0), Real4(state[1].xyz, slot_clock(slot, pixel)));
}

fn store_clock(pixel: vec2u, p: Phase) {
    put_clock(pixel, p[1].w);
}

fn opaque_phase(p: Phase) -> Phase {
    return Phase(opaque4(p[0]), opaque4(p[1]));
}
