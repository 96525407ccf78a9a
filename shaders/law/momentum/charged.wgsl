// Round a charged hole. v is K's part in space, but for a factor, and K_t follows from K's being light.

// −g_tt.
fn law_clock(x: Real3) -> Real {
    let d = x - law.center;
    let r2 = dot(d, d);
    return 1.0 - 2.0 * law.mass * inverseSqrt(r2) + law.charge_squared / r2 - law.third * r2;
}

// Of light that goes into the past from x along d, but for a factor.
fn law_momentum(x: Real3, d: Real3) -> Real4 {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(d, n);
    let across = d - radial * n;
    return Real4(across + (radial / clock) * n, sqrt(radial * radial + clock * dot(across, across)));
}
