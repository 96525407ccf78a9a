// The rate of static clocks around a charged black hole, also with a cosmological constant.

// Returns −g_tt.
fn law_clock(x: Real3) -> Real {
    let d = x - law.center;
    let r2 = dot(d, d);
    return 1.0 - 2.0 * law.mass * inverseSqrt(r2) + law.charge_squared / r2 - law.third * r2;
}

// Returns dφ/dt of the circular orbit at a distance from the axis, with φ (1) or against it (−1); not a number if there is none.
fn law_orbiting(r: Real, sense: Real) -> Real {
    let pull = (law.mass * r - law.charge_squared) / (r * r * r * r) - law.third;
    return sense * sqrt(select(not_a_number(), pull, pull >= 0.0));
}
