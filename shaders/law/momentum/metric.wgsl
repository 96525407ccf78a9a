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
// The part of the length scale over which a slope is measured.
const SLOPE_PART: Real = 0.01;

// Returns the rate at which captured light nears a horizon, and 0 far from one. If the lapse is 0 there, α² decreases by the rate 2κ, where
// κ = |∇α| is the surface gravity, whatever the light's direction; rounding of its velocity does not matter. In coordinates that continue
// below the horizon, the lapse of observers without angular momentum is 0 there.
fn law_descent(x: Real3, v: Real3, horizon: Real) -> Real {
    let q = metric_place(x);
    let lapse = metric_lapse(q);
    if lapse.w > 0.0 && lapse.w < NEAR_HORIZON {
        return sqrt(dot(lapse.xyz, metric_raised(metric_factor(metric_at(q, law.time)), lapse.xyz)) / lapse.w);
    }
    let size = SLOPE_PART * metric_scale(q, law.time);
    let here = zamo_lapse(x);
    // A straight line around the axis would leave the horizon.
    let around = cross(frequency.axis, law_arm(x));
    let way = size * (v - (dot(around, v) / max(dot(around, around), 1e-30)) * around);
    let rate = log_ratio(zamo_lapse(x - way), zamo_lapse(x + way)) / (2.0 * size);
    return select(Real(0.0), rate, here > 0.0 && here < NEAR_HORIZON);
}

// Returns the squared lapse of observers without angular momentum.
fn zamo_lapse(x: Real3) -> Real {
    let g = metric_turning(x);
    return select(-g.determinant / g.own, -g.tt, g.own <= 0.0);
}

// Returns the metric along ∂t and ∂φ.
fn law_turning(spot: Spot) -> Turning {
    return metric_turning(spot.x);
}

fn metric_turning(x: Real3) -> Turning {
    let around = Real4(cross(frequency.axis, law_arm(x)), 0.0);
    let m = metric_at(metric_place(x), law.time);
    let mixed = dot(around.xyz, m.shift);
    let own = metric_square(m, around);
    return Turning(m.clock, mixed, own, m.clock * own - mixed * mixed);
}
