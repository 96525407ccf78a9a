// The path form's orbit: u″ + u = 3M u² (Binet).

fn orbit_center() -> Real3 {
    return law.center;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    return 3.0 * law.mass * hh * u * u;
}

// Up to this u the pull is small beside h² u.
fn orbit_calm() -> Real {
    return 1.0 / (3.0 * law.mass);
}
