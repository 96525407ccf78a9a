// The orbit about one inverse-square centre: P is constant.

fn orbit_center() -> Real3 {
    return inverse_square[0].position;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    return inverse_square[0].strength;
}

// The pull has no size of its own that a step could be measured by.
fn orbit_calm() -> Real {
    return 0.0;
}
