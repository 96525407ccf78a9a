// In flat space light's momentum is along its way.

// Of light that goes into the past from x along d, but for a factor.
fn law_momentum(x: Real3, d: Real3) -> Real4 {
    return Real4(d, 1.0);
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    return dot(k.xyz, k.xyz) - k.w * k.w;
}
