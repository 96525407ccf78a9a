// The state `Phase` of laws in space alone: its columns are x and v.

alias Phase = mat2x3<Real>;

fn unpack_phase(state: State) -> Phase {
    return Phase(state[0].xyz, state[1].xyz);
}

fn phase_times(p: Phase) -> Real2 {
    return Real2(0.0);
}

fn opaque_phase(p: Phase) -> Phase {
    return Phase(opaque3(p[0]), opaque3(p[1]));
}
