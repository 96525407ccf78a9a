// Round a hole without spin: g_rr is −1/g_tt. v is K's part in space, but for a factor, and K_t follows from K's being light.

// Of light that goes into the past from x at v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(v, n);
    let across = v - radial * n;
    return Real4(across + (radial / clock) * n, sqrt(radial * radial + clock * dot(across, across)));
}

// From the middle of what the law is the same around.
fn law_arm(x: Real3) -> Real3 {
    return x - law.center;
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(k.xyz, n);
    let across = k.xyz - radial * n;
    return radial * radial / clock + dot(across, across) - clock * k.w * k.w;
}
