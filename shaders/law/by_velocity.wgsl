// A law of the second order whose acceleration depends on place and velocity, dx = v, dv = a(x, v).

fn law_derivative(p: Phase) -> Phase {
    return Phase(p[1], law_pull(p[0], p[1]));
}

// dv, for the control by curvature.
fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1];
}
