// The orbit equation around one center with the local falloff: P = strength · d(r) r².

fn orbit_center() -> Real3 {
    return cubic[0].position;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    let r = 1.0 / u;
    let q = min(r / cubic[0].radius, 1.0);
    return cubic[0].strength * (q * q * (2.0 * q - 3.0) + 1.0) * r * r;
}

// The pull has no characteristic u that could limit a step.
fn orbit_calm() -> Real {
    return 0.0;
}
