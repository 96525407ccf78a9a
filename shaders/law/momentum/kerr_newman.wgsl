// Round a hole with a spin and a charge. With U = (v, −1), which v = dx/dτ makes light, it is gU: of two ways that light
// goes along a direction where nothing rests, v's length says which.

// Of light that goes into the past from x at v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let g = kerr_schild(x - law.center);
    let dragged = g.f * (dot(g.l, v) - 1.0);
    return Real4(v + dragged * g.l, 1.0 + dragged);
}

// From the middle of what the law is the same around.
fn law_arm(x: Real3) -> Real3 {
    return x - law.center;
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let g = kerr_schild(x - law.center);
    let along = dot(g.l, k.xyz) + k.w;
    return dot(k.xyz, k.xyz) - k.w * k.w + g.f * along * along;
}
