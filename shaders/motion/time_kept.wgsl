// τ along an orbit: dτ = ds/u², by Gauss's rule of three points on the cubic through both ends' u and w.

fn orbit_time(o: Orbit, end: Orbit, s: Real) -> Real {
    let middle = 4.0 / 9.0 * pace_at(o, end, s, 0.5);
    let sides = pace_at(o, end, s, 0.1127016653792583) + pace_at(o, end, s, 0.8872983346207417);
    return s * (middle + 5.0 / 18.0 * sides);
}

// 1/u² at a fraction of the step.
fn pace_at(o: Orbit, end: Orbit, s: Real, f: Real) -> Real {
    let c = end.u - o.u;
    let g = 1.0 - f;
    let u = o.u + f * (c + g * (g * (s * o.w - c) + f * (c - s * end.w)));
    return 1.0 / (u * u);
}
