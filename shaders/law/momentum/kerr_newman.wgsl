// The momentum of light around a black hole with spin and charge. With U = (v, −1), which v = dx/dτ makes null, it is gU. If no observer
// can be static, light may have two speeds in one direction; the length of v selects one.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let g = kerr_schild(x - law.center);
    let dragged = g.f * (dot(g.l, v) - 1.0);
    return Real4(v + dragged * g.l, 1.0 + dragged);
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return x - law.center;
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let g = kerr_schild(x - law.center);
    let along = dot(g.l, k.xyz) + k.w;
    return dot(k.xyz, k.xyz) - k.w * k.w + g.f * along * along;
}
