// Round a hole with a spin and a charge. With U = (v, −1) it is gU.

// Of light that goes into the past from x along d, but for a factor.
fn law_momentum(x: Real3, d: Real3) -> Real4 {
    let v = law_start(x, d)[1];
    let g = kerr_schild(x - law.center);
    let dragged = g.f * (dot(g.l, v) - 1.0);
    return Real4(v + dragged * g.l, 1.0 + dragged);
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let g = kerr_schild(x - law.center);
    let along = dot(g.l, k.xyz) + k.w;
    return dot(k.xyz, k.xyz) - k.w * k.w + g.f * along * along;
}
