// Phase for laws that carry time: the columns are (x, t) and (v, ṫ). The scene is stationary, so that only ṫ is kept
// between passes (W04 App. A), beside the state. For light whose frequency is asked for under a law that changes with t they are (x, ln k)
// and (v, τ), where k (v, −1) is light's momentum and k is 1 at the camera; both are kept.

alias Phase = mat2x4<Real>;

fn unpack_phase(state: State, pixel: vec2u) -> Phase {
    if FOLLOWS_SHIFT {
        return Phase(Real4(state[0].xyz, load_stretch(pixel)), Real4(state[1].xyz, load_clock(pixel)));
    }
    return Phase(Real4(state[0].xyz, 0.0), Real4(state[1].xyz, load_clock(pixel)));
}

fn unpack_slot(state: State, slot: u32, pixel: vec2u) -> Phase {
    if FOLLOWS_SHIFT {
        return Phase(Real4(state[0].xyz, slot_stretch(slot, pixel)), Real4(state[1].xyz, slot_clock(slot, pixel)));
    }
    return Phase(Real4(state[0].xyz, 0.0), Real4(state[1].xyz, slot_clock(slot, pixel)));
}

fn store_clock(pixel: vec2u, p: Phase) {
    put_clock(pixel, p[1].w);
    if FOLLOWS_SHIFT {
        put_stretch(pixel, p[0].w);
    }
}

fn opaque_phase(p: Phase) -> Phase {
    return Phase(opaque4(p[0]), opaque4(p[1]));
}
