// Light around a black hole with charge and without spin (Reissner–Nordström), also with a cosmological constant, in path form: x″ = h²
// (−3M/r⁵ + 2Q²/r⁶) x with h = |x × v|, in pseudo-Cartesian coordinates of areal r. The cosmological constant bends no path: it drops out.

struct Law {
    center: Real3,
    mass: Real,
    // Q².
    charge_squared: Real,
    // Λ/3.
    third: Real,
}

var<uniform> law: Law;

// Returns h² = |x × v|².
fn law_ray_constant(p: Phase) -> Real {
    let l = cross(p[0] - law.center, p[1]);
    return dot(l, l);
}

fn law_acceleration(at: Real3, constant: Real) -> Real3 {
    let x = at - law.center;
    let r2 = dot(x, x);
    let r = sqrt(r2);
    return (constant / (r2 * r2 * r2) * (2.0 * law.charge_squared - 3.0 * law.mass * r)) * x;
}

// Returns the tau over which the law changes: the distance r divided by the speed.
fn law_scale(p: Phase) -> Real {
    let x = p[0] - law.center;
    return sqrt(dot(x, x) / dot(p[1], p[1]));
}
