// Steps in the plane of an orbit are measured in s, with ds = dτ/r².

// τ in that measure, along the line from p: for a straight line s = τ/(r₀ r₁), as far as an angle is its sine.
fn own_measure(p: Phase, tau: Real) -> Real {
    let x = p[0] - orbit_center();
    return tau * inverseSqrt(dot(x, x) * dot(x + tau * p[1], x + tau * p[1]));
}

// How fast τ goes in it.
fn own_pace(p: Phase) -> Real {
    let x = p[0] - orbit_center();
    return dot(x, x);
}

// A fraction of a step's τ as a fraction of its size.
fn own_fraction(p: Phase, end: Phase, t: Real) -> Real {
    let at = distance(mix(p[0], end[0], t), orbit_center());
    return t * distance(end[0], orbit_center()) / at;
}
