// The rate of static clocks around a Schwarzschild black hole.

// Returns −g_tt.
fn law_clock(x: Real3) -> Real {
    return 1.0 - 2.0 * law.mass / distance(x, law.center);
}
