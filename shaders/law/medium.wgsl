// A medium whose index n varies with place: dx = v, dv = ∇(n²/2) = n∇n, with |v| = n kept along a ray (the F = ma form of
// Evans and Rosenquist 1985 for the thesis' Eq. 15; dτ = ds/n).

// Nothing is held.
fn law_held(p: Phase) -> Real {
    return 0.0;
}

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    return medium_pull(x);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, medium_index(x) * normalize(v));
}

fn law_projected(p: Phase) -> Phase {
    return p;
}

fn law_scale(p: Phase) -> Real {
    return medium_length(p[0]) / length(p[1]);
}
