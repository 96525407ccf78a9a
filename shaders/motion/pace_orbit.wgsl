// The step parameter of orbits: s with ds = dτ/r² in the plane of an orbit, and the Mino s with scaled momenta on a separated orbit.

// Returns τ in that parameter, along the line from p: for a straight line s = τ/(r₀ r₁), while the angle is close to its sine.
fn own_measure(p: Phase, tau: Real) -> Real {
    let x = p[0] - orbit_center();
    if IS_PLANE {
        return tau * inverseSqrt(dot(x, x) * dot(x + tau * p[1], x + tau * p[1]));
    }
    let first = own_pace(p);
    return tau * sqrt(dot(x, x) / dot(x + tau * p[1], x + tau * p[1])) / first;
}

// Returns the rate of τ in that parameter.
fn own_pace(p: Phase) -> Real {
    if IS_PLANE {
        let x = p[0] - orbit_center();
        return dot(x, x);
    }
    let o = orbit_of(p[0], p[1]);
    return orbit_pace(o, o.u, o.n.z, o.gap);
}

// Converts a fraction of a step's τ to a fraction of the step's size.
fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    let at = distance(mix(p[0], end[0], t), orbit_center());
    return t * distance(end[0], orbit_center()) / at;
}
