// The orbit equation around one inverse-square center: P is constant.

fn orbit_center() -> Real3 {
    return inverse_square[0].position;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    return inverse_square[0].strength;
}

// The pull has no characteristic u that could limit a step.
fn orbit_calm() -> Real {
    return 0.0;
}
