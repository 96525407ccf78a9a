// Steps in the plane of an orbit are measured in s, with ds = dτ/r²; those of a separated orbit in Mino's s, of momenta to its scale.

// τ in that measure, along the line from p: for a straight line s = τ/(r₀ r₁), as far as an angle is its sine.
fn own_measure(p: Phase, tau: Real) -> Real {
    let x = p[0] - orbit_center();
    if IS_PLANE {
        return tau * inverseSqrt(dot(x, x) * dot(x + tau * p[1], x + tau * p[1]));
    }
    let first = own_pace(p);
    return tau * sqrt(dot(x, x) / dot(x + tau * p[1], x + tau * p[1])) / first;
}

// How fast τ goes in it.
fn own_pace(p: Phase) -> Real {
    if IS_PLANE {
        let x = p[0] - orbit_center();
        return dot(x, x);
    }
    let o = orbit_of(p[0], p[1]);
    return orbit_pace(o, o.u, o.n.z, o.gap);
}

// A fraction of a step's τ as a fraction of its size.
fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    let at = distance(mix(p[0], end[0], t), orbit_center());
    return t * distance(end[0], orbit_center()) / at;
}
