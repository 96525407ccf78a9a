// The rate of static clocks around a Schwarzschild black hole.

// Returns −g_tt.
fn law_clock(x: Real3) -> Real {
    return 1.0 - 2.0 * law.mass / distance(x, law.center);
}

// Returns dφ/dt of the circular orbit at a distance from the axis, with φ (1) or against it (−1).
fn law_orbiting(r: Real, sense: Real) -> Real {
    return sense * sqrt(law.mass / (r * r * r));
}
