// In a medium a ray is as fast as the index is large: v = n d, with τ for which dτ = ds/n.

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, medium_index(x) * normalize(v));
}
