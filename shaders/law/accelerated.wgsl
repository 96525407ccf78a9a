// A second-order law, dx = v, dv = a(x), with or without a value that is constant along each ray.

fn law_derivative(p: Phase) -> Phase {
    return Phase(p[1], law_acceleration(p[0], law_ray_constant(p)));
}

// Returns dv/dτ, for the step control by curvature.
fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1];
}

// Returns the new velocity of G95 Table 1 under forces: v ← v − Σ M d(r) n̂.
fn next_velocity(p: Phase) -> Real3 {
    return p[1] + law_acceleration(p[0], law_ray_constant(p));
}
