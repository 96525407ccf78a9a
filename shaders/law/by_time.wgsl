// A law of the second order that depends on tau too, dx = v, dv = a(x, v, tau): a state carries tau beside its velocity.

fn law_derivative(p: Phase) -> Phase {
    return Phase(Real4(p[1].xyz, 0.0), Real4(law_pull_at(p[0].xyz, p[1].xyz, p[1].w), 1.0));
}

fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1].xyz;
}
