// Starts a ray in a medium with a speed equal to the index: v = n d, with τ for which dτ = ds/n.

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, medium_index(x) * normalize(v));
}
