// The momentum of light in a custom metric. With U = (v, −1), which v = dx/dτ makes null, it is gU. If no observer can be static, light
// may have two speeds in one direction; the length of v selects one.

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let m = metric_at(metric_place(x), 0.0);
    return Real4(metric_lowered(m, v) - m.shift, dot(m.shift, v) - m.clock);
}

// Returns the position of x relative to the center of symmetry of the law.
fn law_arm(x: Real3) -> Real3 {
    return metric_place(x);
}

// Returns g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    return metric_square(metric_at(metric_place(x), 0.0), k);
}

// Returns the momentum of light that leaves x into the past with velocity v, up to a positive factor, at tau before the time of the camera.
fn law_momentum_at(x: Real3, v: Real3, tau: Real) -> Real4 {
    let m = metric_at(metric_place(x), law.time - tau);
    return Real4(metric_lowered(m, v) - m.shift, dot(m.shift, v) - m.clock);
}

// Returns g(k, k) at that time.
fn law_square_at(x: Real3, k: Real4, tau: Real) -> Real {
    return metric_square(metric_at(metric_place(x), law.time - tau), k);
}

// Returns the four-velocity of the Eulerian observer.
fn law_eulerian(x: Real3) -> Real4 {
    let m = metric_at(metric_place(x), law.time);
    let shift = metric_raised(metric_factor(m), m.shift);
    let lapse = possible(dot(m.shift, shift) - m.clock);
    return Real4(-lapse * shift, lapse);
}

// The squared lapse below which a path is near a horizon.
const NEAR_HORIZON: Real = 0.1;

// Returns the rate at which captured light nears a horizon, where the lapse is 0, and 0 far from one. There α² decreases by the rate 2κ, where
// κ = |∇α| is the surface gravity, whatever the light's direction; rounding of its velocity does not matter.
fn law_descent(x: Real3, v: Real3, horizon: Real) -> Real {
    let q = metric_place(x);
    let lapse = metric_lapse(q);
    let raised = metric_raised(metric_factor(metric_at(q, law.time)), lapse.xyz);
    return select(Real(0.0), sqrt(dot(lapse.xyz, raised) / lapse.w), lapse.w > 0.0 && lapse.w < NEAR_HORIZON);
}

// Returns the metric along ∂t and ∂φ.
fn law_turning(spot: Spot) -> Turning {
    let around = Real4(cross(frequency.axis, law_arm(spot.x)), 0.0);
    let m = metric_at(metric_place(spot.x), law.time);
    let mixed = dot(around.xyz, m.shift);
    let own = metric_square(m, around);
    return Turning(m.clock, mixed, own, m.clock * own - mixed * mixed);
}
