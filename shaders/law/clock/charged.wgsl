// The rate of static clocks around a charged black hole, also with a cosmological constant.

// Returns −g_tt.
fn law_clock(x: Real3) -> Real {
    let d = x - law.center;
    let r2 = dot(d, d);
    return 1.0 - 2.0 * law.mass * inverseSqrt(r2) + law.charge_squared / r2 - law.third * r2;
}
