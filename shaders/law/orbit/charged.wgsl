// The orbit equation around a charged black hole: u″ + u = 3M u² − 2Q² u³.

fn orbit_center() -> Real3 {
    return law.center;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    return hh * u * u * (3.0 * law.mass - 2.0 * law.charge_squared * u);
}

// Returns the u up to which the pull is small compared with h² u.
fn orbit_calm() -> Real {
    return 1.0 / (3.0 * law.mass);
}
