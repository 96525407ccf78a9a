// The orbit equation around one screened center: P = strength · e^(−μr)(1 + μr).

fn orbit_center() -> Real3 {
    return yukawa[0].position;
}

fn orbit_pull(u: Real, hh: Real) -> Real {
    let m = yukawa[0].mu / u;
    return yukawa[0].strength * real_exp(-m) * (1.0 + m);
}

// The pull has no characteristic u that could limit a step.
fn orbit_calm() -> Real {
    return 0.0;
}
