// A law of the second order that depends on tau too, dx = v, dv = a(x, v, tau), with what light's frequency follows from: a state carries
// tau beside its velocity, and ln k beside its place.

fn law_derivative(p: Phase) -> Phase {
    let pull = law_stretch_at(p[0].xyz, p[1].xyz, p[1].w);
    return Phase(Real4(p[1].xyz, pull.w), Real4(pull.xyz, 1.0));
}

fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1].xyz;
}
