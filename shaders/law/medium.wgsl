// A medium whose index n varies with position: dx = v, dv = ∇(n²/2) = n∇n, with |v| = n constant along a ray (the F = ma form of Evans and
// Rosenquist 1985 for T Eq. 15; dτ = ds/n).

fn law_acceleration(x: Real3, constant: Real) -> Real3 {
    return medium_pull(x);
}

fn law_scale(p: Phase) -> Real {
    return medium_length(p[0]) / length(p[1]);
}
