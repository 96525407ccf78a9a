// The momentum of light around a black hole without spin: g_rr is −1/g_tt. v is the spatial part of K up to a factor, and K_t follows from
// the null condition.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(v, n);
    let across = v - radial * n;
    return Real4(across + (radial / clock) * n, sqrt(radial * radial + clock * dot(across, across)));
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return x - law.center;
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(k.xyz, n);
    let across = k.xyz - radial * n;
    return radial * radial / clock + dot(across, across) - clock * k.w * k.w;
}
