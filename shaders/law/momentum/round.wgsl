// The momentum of light around a black hole without spin: g_rr is −1/g_tt. v is the spatial part of K up to a factor, and K_t follows from
// the null condition.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(v, n);
    let across = v - radial * n;
    return Real4(across + (radial / clock) * n, sqrt(radial * radial + clock * dot(across, across)));
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return x - law.center;
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    let n = normalize(x - law.center);
    let clock = law_clock(x);
    let radial = dot(k.xyz, n);
    let across = k.xyz - radial * n;
    return radial * radial / clock + dot(across, across) - clock * k.w * k.w;
}

// Returns the four-velocity of the Eulerian observer, who is static.
fn law_eulerian(x: Real3) -> Real4 {
    return Real4(0.0, 0.0, 0.0, possible(law_clock(x)));
}

// Returns the rate at which light of this velocity nears a horizon of this radius: the decrease of its height divided by the height.
fn law_descent(x: Real3, v: Real3, horizon: Real) -> Real {
    let arm = law_arm(x);
    return -dot(normalize(arm), v) / (length(arm) - horizon);
}

// Returns the metric along ∂t and ∂φ.
fn law_turning(spot: Spot) -> Turning {
    let around = spot.r * spot.sine;
    let own = around * around;
    let clock = law_clock(spot.x);
    return Turning(-clock, 0.0, own, -clock * own);
}

// Returns the four-velocity of matter of these constants E and L that falls with constant θ, not a number where it cannot be.
fn law_falling(x: Real3, energy: Real, momentum: Real) -> Real4 {
    let arm = x - law.center;
    let clock = law_clock(x);
    let around = cross(frequency.axis, arm);
    let turning = momentum / max(dot(around, around), 1e-30);
    let square = energy * energy - clock * (1.0 + momentum * turning);
    let inwards = sqrt(select(not_a_number(), square, square >= 0.0));
    return Real4(turning * around - inwards * normalize(arm), energy / clock);
}
