// The orbit equation around a Schwarzschild black hole, the path form: u″ + u = 3M u² (Binet).

fn orbit_center() -> Real3 {
    return law.center;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    return 3.0 * law.mass * hh * u * u;
}

// Returns the u up to which the pull is small compared with h² u.
fn orbit_calm() -> Real {
    return 1.0 / (3.0 * law.mass);
}
