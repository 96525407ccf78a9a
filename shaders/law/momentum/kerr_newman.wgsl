// The momentum of light around a black hole with spin and charge. With U = (v, −1), which v = dx/dτ makes null, it is gU. If no observer
// can be static, light may have two speeds in one direction; the length of v selects one.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let g = kerr_schild(x - law.center);
    let dragged = g.f * (dot(g.l, v) - 1.0);
    return Real4(v + dragged * g.l, 1.0 + dragged);
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return x - law.center;
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let g = kerr_schild(x - law.center);
    let along = dot(g.l, k.xyz) + k.w;
    return dot(k.xyz, k.xyz) - k.w * k.w + g.f * along * along;
}

// Returns the radius r of a position relative to the center.
fn law_radius(arm: Real3) -> Real {
    return spheroid_of(arm, law.spin).x;
}

// Returns the rate at which light of this velocity nears a horizon of this radius: the decrease of its height divided by the height.
fn law_descent(x: Real3, v: Real3, horizon: Real) -> Real {
    let arm = law_arm(x);
    let spheroid = spheroid_of(arm, law.spin);
    let rise = (spheroid.x * arm + (spheroid.z / spheroid.x) * law.spin) / (2.0 * spheroid.y);
    return -dot(rise, v) / (spheroid.x - horizon);
}

// Returns the distance from the axis at radius r on the equator.
fn law_axial(r: Real) -> Real {
    return sqrt(r * r + dot(law.spin, law.spin));
}

// Returns the four-velocity of the Eulerian observer.
fn law_eulerian(x: Real3) -> Real4 {
    let g = kerr_schild(x - law.center);
    let lapse = inverseSqrt(1.0 + g.f);
    return Real4((-g.f * lapse) * g.l, 1.0 / lapse);
}

// Returns the metric along ∂t and ∂φ, whose determinant is −Δ sin²θ.
fn law_turning(spot: Spot) -> Turning {
    let a2 = dot(law.spin, law.spin);
    let r = spot.r;
    let r2 = r * r;
    let sine2 = spot.sine * spot.sine;
    let sigma = r2 + a2 * spot.cosine * spot.cosine;
    let pull = (2.0 * law.mass * r - law.charge_squared) / sigma;
    let a = dot(law.spin, frequency.axis);
    let root = sqrt(max(law.mass * law.mass - a2 - law.charge_squared, 0.0));
    let away = r - law.mass;
    let delta = select(away * away - (law.mass * law.mass - a2 - law.charge_squared), (away - root) * (away + root), root > 0.0);
    return Turning(pull - 1.0, -a * pull * sine2, sine2 * (r2 + a2 + a2 * pull * sine2), -delta * sine2);
}

// Returns dφ/dt of the circular orbit at a distance from the axis, with φ (1) or against it (−1).
fn law_orbiting(r: Real, sense: Real) -> Real {
    let speed = sqrt(max(law.mass * r - law.charge_squared, 0.0));
    return sense * speed / (r * r + sense * dot(law.spin, frequency.axis) * speed);
}

// Returns the four-velocity of matter of these constants E and L that falls with constant θ, not a number where it cannot be.
fn law_falling(x: Real3, energy: Real, momentum: Real) -> Real4 {
    let arm = x - law.center;
    let a2 = dot(law.spin, law.spin);
    let a = dot(law.spin, frequency.axis);
    let around = cross(frequency.axis, arm);
    let spheroid = spheroid_of(arm, law.spin);
    let r = spheroid.x;
    let s = r * r + a2;
    let n = 2.0 * law.mass * r - law.charge_squared;
    let sigma = 2.0 * spheroid.y;
    let sine2 = max(dot(around, around) / s, 1e-30);
    let p = s * energy - a * momentum;
    // (L − a E sin²θ)²/sin²θ + Σ
    let k = momentum * (momentum / sine2 - 2.0 * a * energy) + a * energy * a * energy * sine2 + sigma;
    let square = p * p - (s - n) * k;
    let inwards = sqrt(select(not_a_number(), square, square >= 0.0));
    let w = k / (p + inwards);
    let turning = a * (w - energy) + momentum / sine2;
    let time = p + n * w + a * (momentum - a * energy * sine2);
    return Real4(turning * around - inwards * kerr_schild(arm).l, time) / sigma;
}
