// A second-order law whose acceleration depends on position and velocity, dx = v, dv = a(x, v).

fn law_derivative(p: Phase) -> Phase {
    return Phase(p[1], law_acceleration_by_velocity(p[0], p[1]));
}

// Returns dv/dτ, for the step control by curvature.
fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1];
}
