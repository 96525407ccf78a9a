// Light around a Schwarzschild black hole, in path form: x″ = −3M h² x/r⁵ with h = |x × v|, in pseudo-Cartesian Schwarzschild coordinates.
// It is the geodesic equation with the null condition substituted: the same path in the same affine parameter (Binet's u″ + u = 3Mu² in the
// plane), regular at r = 2M. h is recomputed at every call: storing it costs float32 digits.

struct Law {
    center: Real3,
    mass: Real,
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
    return (-3.0 * law.mass * constant / (r2 * r2 * sqrt(r2))) * x;
}

// Returns the tau over which the law changes: the distance r divided by the speed.
fn law_scale(p: Phase) -> Real {
    let x = p[0] - law.center;
    return sqrt(dot(x, x) / dot(p[1], p[1]));
}
