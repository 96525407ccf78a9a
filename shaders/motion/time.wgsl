// Computes τ along an orbit, if it is needed, by the three-point Gauss rule on the cubics through both ends: on a plane orbit dτ = ds/u².

fn orbit_time(o: Orbit, end: Orbit, s: Real) -> Real {
    if !ASKS_TAU {
        return 0.0;
    }
    let middle = 4.0 / 9.0 * pace_at(o, end, s, 0.5);
    let sides = pace_at(o, end, s, 0.1127016653792583) + pace_at(o, end, s, 0.8872983346207417);
    return s * (middle + 5.0 / 18.0 * sides);
}

// Returns dτ/ds at a fraction of the step.
fn pace_at(o: Orbit, end: Orbit, s: Real, f: Real) -> Real {
    if IS_PLANE {
        let c = end.u - o.u;
        let g = 1.0 - f;
        let u = o.u + f * (c + g * (g * (s * o.w - c) + f * (c - s * end.w)));
        return 1.0 / (u * u);
    }
    let u = cubic_at(o.u, s * o.w, end.u, s * end.w, f);
    let height = cubic_at(o.n.z, s * o.t.z, end.n.z, s * end.t.z, f);
    let w = select(u.y / s, o.w, s == 0.0);
    return orbit_pace(o, u.x, height.x, orbit_gap(o, u.x, w));
}

// Returns a cubic and its slope, from its values and slopes at 0 and 1.
fn cubic_at(a: Real, slope: Real, b: Real, end_slope: Real, f: Real) -> Real2 {
    let c = b - a;
    let g = 1.0 - f;
    let over = slope - c;
    let under = c - end_slope;
    return Real2(a + f * (c + g * (g * over + f * under)), c + g * (g - 2.0 * f) * over + f * (2.0 * g - f) * under);
}
