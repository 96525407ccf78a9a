// Light around a black hole with spin and charge (Kerr–Newman), in Cartesian ingoing Kerr–Schild coordinates: g = η + f l l, l_t = 1 and
// |l| = 1, regular on the axis and at the horizon. Rays go into the past, by τ = t_camera − t, and v = dx/dτ: light is null if |v|² = 1 − f
// W², with W = 1 − l·v.
//
// The congruence l has no shear: ∂ᵢlⱼ is its expansion θ and its twist ω about l, and θ + iω = 1/(r + ia cos θ). So the geodesic equation
// needs no Christoffel symbols:
//     dv/dτ = ½W² ∇f + Ḟ (l − v) − 2ωF l × v,   F = f W,   Ḟ = W v·∇f − f (½W² l·∇f + θ (|v|² − (l·v)²))

struct Law {
    center: Real3,
    mass: Real,
    // The spin a, along the axis.
    spin: Real3,
    // The squared charge Q².
    charge_squared: Real,
    // The direction of the axis, also without spin.
    axis: Real3,
}

var<uniform> law: Law;

// The quantities of the metric at a position.
struct KerrSchild {
    l: Real3,
    f: Real,
    // ∇f.
    slope: Real3,
    expansion: Real,
    twist: Real,
}

fn kerr_schild(x: Real3) -> KerrSchild {
    let spheroid = spheroid_of(x, law.spin);
    let r = spheroid.x;
    let d = spheroid.y;
    let a_cos = spheroid.z / r;
    let k = d - a_cos * a_cos;
    // The direction in which r grows, times 2d.
    let outwards = r * x + a_cos * law.spin;
    let f = (law.mass * r - 0.5 * law.charge_squared) / d;
    let slope = (0.5 * law.mass * outwards - f * (k * x + spheroid.z * law.spin)) / (d * d);
    let l = (outwards + cross(x, law.spin)) / (r * r + dot(law.spin, law.spin));
    return KerrSchild(l, f, slope, 0.5 * r / d, 0.5 * a_cos / d);
}

fn law_acceleration_by_velocity(at: Real3, v: Real3) -> Real3 {
    let g = kerr_schild(at - law.center);
    let along = dot(g.l, v);
    let w = 1.0 - along;
    let half = 0.5 * w * w;
    let rate = w * dot(v, g.slope) - g.f * (half * dot(g.l, g.slope) + g.expansion * (dot(v, v) - along * along));
    return half * g.slope + rate * (g.l - v) - (2.0 * g.twist * g.f * w) * cross(g.l, v);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    let g = kerr_schild(x - law.center);
    let along = dot(g.l, v);
    let b = g.f * along;
    return Phase(x, v / light_speed(1.0 - g.f, b, b * along + dot(v, v)));
}

// Returns the tau over which the law changes: r, because light has speed 1 far away. Near the horizon light slows down, but the pull does
// not.
fn law_scale(p: Phase) -> Real {
    return spheroid_of(p[0] - law.center, law.spin).x;
}
