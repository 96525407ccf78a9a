// Phase for laws that carry time: the columns are (x, t) and (v, ṫ). The scene is stationary, so that only ṫ is kept
// between passes (W04 App. A). For light whose frequency is asked for under a law that changes with t they are (x, ln k)
// and (v, τ), where k (v, −1) is light's momentum and k is 1 at the camera; both are kept.

alias Phase = mat2x4<Real>;

fn unpack_phase(state: State) -> Phase {
    return Phase(Real4(state[0].xyz, state[2].w), Real4(state[1].xyz, state[2].x));
}

// What W keeps of it: ṫ, and ln k where it is followed.
fn phase_times(p: Phase) -> Real2 {
    if FOLLOWS_SHIFT {
        return Real2(p[1].w, p[0].w);
    }
    return Real2(p[1].w, 0.0);
}

fn opaque_phase(p: Phase) -> Phase {
    return Phase(opaque4(p[0]), opaque4(p[1]));
}
