// Light around a Schwarzschild black hole as Weiskopf et al. (2004) integrate it: the geodesic equation in pseudo-Cartesian Schwarzschild
// coordinates, with Christoffel symbols contracted (W04 §5.4, App. A), and ṫ carried from the null condition at the start.
//
// Departure: at the horizon the equation is 0/0, and float32 loses it before. Inside r = 2M/(1 − NEAR) the null condition is substituted,
// which leaves the regular limit −3M |v⊥|²/r² n̂ (the path form) for the same path in the same parameter.

struct Law {
    center: Real3,
    mass: Real,
}

var<uniform> law: Law;

const NEAR: Real = 0.05;

fn law_derivative(p: Phase) -> Phase {
    let x = p[0].xyz - law.center;
    let v = p[1].xyz;
    let clock = p[1].w;
    let inverse_r = inverseSqrt(dot(x, x));
    let n = inverse_r * x;
    let radial = dot(n, v);
    // |v|² − ṙ² as the square of one vector: the difference loses digits on nearly radial rays.
    let across = v - radial * n;
    let across2 = dot(across, across);
    let f = 1.0 - 2.0 * law.mass * inverse_r;
    let near = f < NEAR;
    let safe = max(f, NEAR);
    let inverse_f = 1.0 / safe;
    let pull = law.mass * inverse_r * inverse_r;
    let far_pull = pull * (radial * radial * inverse_f - safe * clock * clock - 2.0 * across2);
    let near_pull = -3.0 * pull * across2;
    let clock_rate = select(-2.0 * pull * inverse_f * radial * clock, 0.0, near);
    return Phase(Real4(v, clock), Real4(select(far_pull, near_pull, near) * n, clock_rate));
}

// ṫ from the null condition (1 − 2M/r) ṫ² = |v⊥|² + ṙ²/(1 − 2M/r).
fn law_start(x: Real3, v: Real3) -> Phase {
    let r = length(x - law.center);
    let n = (x - law.center) / r;
    let radial = dot(n, v);
    let across = v - radial * n;
    let f = 1.0 - 2.0 * law.mass / r;
    return Phase(Real4(x, 0.0), Real4(v, sqrt((dot(across, across) + radial * radial / f) / f)));
}

fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    return rate[1].xyz;
}

// ṫ changes over r − 2M, so that steps shrink towards the horizon, down to where the regular limit takes over.
fn law_scale(p: Phase) -> Real {
    let r = length(p[0].xyz - law.center);
    return max(r - 2.0 * law.mass, 2.0 * NEAR * law.mass) / length(p[1].xyz);
}
