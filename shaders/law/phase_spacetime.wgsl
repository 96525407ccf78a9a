// The state `Phase` of laws that carry time: its columns are (x, t) and (v, ṫ). The scene is stationary, so that only ṫ is stored between
// passes (W04 App. A). If the redshift is needed under a law that depends on t, the columns are (x, ln k) and (v, τ), where k (v, −1) is
// the momentum of light and k is 1 at the camera; both are stored.

alias Phase = mat2x4<Real>;

fn unpack_phase(state: State) -> Phase {
    return Phase(Real4(state[0].xyz, state[2].w), Real4(state[1].xyz, state[2].x));
}

// Returns the values that W stores: ṫ, and ln k if it is followed.
fn phase_times(p: Phase) -> Real2 {
    if FOLLOWS_SHIFT {
        return Real2(p[1].w, p[0].w);
    }
    return Real2(p[1].w, 0.0);
}

fn opaque_phase(p: Phase) -> Phase {
    return Phase(opaque4(p[0]), opaque4(p[1]));
}
