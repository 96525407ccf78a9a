// Light round a Schwarzschild hole, in path form: x″ = −3M h² x/r⁵ with h = |x × v|, in pseudo-Cartesian Schwarzschild
// coordinates. It is the geodesic equation with the null condition put in: the same path in the same affine parameter
// (Binet's u″ + u = 3Mu² in the plane), regular at r = 2M. h is evaluated anew at every call: holding it costs float32 digits.

struct Law {
    center: vec3f,
    mass: f32,
}

@group(0) @binding(50) var<uniform> law: Law;

fn law_rate(p: Phase) -> Phase {
    let x = p[0] - law.center;
    let l = cross(x, p[1]);
    let r2 = dot(x, x);
    return Phase(p[1], (-3.0 * law.mass * dot(l, l) / (r2 * r2 * sqrt(r2))) * x);
}

fn law_start(x: vec3f, v: vec3f) -> Phase {
    return Phase(x, v);
}

fn law_settled(p: Phase) -> Phase {
    return p;
}

// The tau over which the law changes: the distance r over the speed.
fn law_scale(p: Phase) -> f32 {
    let x = p[0] - law.center;
    return sqrt(dot(x, x) / dot(p[1], p[1]));
}
