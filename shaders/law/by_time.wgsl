// A second-order law that depends on tau too, dx = v, dv = a(x, v, tau): a state carries tau next to its velocity, and ln k next to its
// position if the frequency of light depends on it.

fn law_derivative(p: Phase) -> Phase {
    if FOLLOWS_SHIFT {
        let pull = law_stretch_at(p[0].xyz, p[1].xyz, p[1].w);
        return Phase(Real4(p[1].xyz, pull.w), Real4(pull.xyz, 1.0));
    }
    return Phase(Real4(p[1].xyz, 0.0), Real4(law_acceleration_by_time(p[0].xyz, p[1].xyz, p[1].w), 1.0));
}

fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1].xyz;
}
