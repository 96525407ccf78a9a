// A law of the second order, dx = v, dv = a(x): with a constant of its own that each ray holds, or with none.

fn law_derivative(p: Phase) -> Phase {
    return Phase(p[1], law_acceleration(p[0], law_held(p)));
}

// dv, for the control by curvature.
fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1];
}

// G95's Table 1 under forces: v ← v − Σ M d(r) n̂.
fn next_velocity(p: Phase) -> Real3 {
    return p[1] + law_acceleration(p[0], law_held(p));
}
