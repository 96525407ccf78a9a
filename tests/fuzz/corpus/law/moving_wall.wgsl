// A wall that light bounces off, moving along its normal: a smooth step of potential, so steep that what comes slower than it is
// turned back. What meets it while it approaches comes back faster.

fn law_acceleration_by_time(x: Real3, v: Real3, tau: Real) -> Real3 {
    let depth = (dot(x, Real3(0.0, 0.0, 1.0)) - 0.75 - 0.75 * tau) / 0.75;
    // The slope of height / (1 + e^(-depth)), without overflow on either side.
    let e = real_exp(-abs(depth));
    let slope = 0.75 * e / (0.75 * (1.0 + e) * (1.0 + e));
    return -slope * Real3(0.0, 0.0, 1.0);
}

// Steps shrink towards the wall, down to its own width.
fn law_scale(p: Phase) -> Real {
    let depth = abs(dot(p[0].xyz, Real3(0.0, 0.0, 1.0)) - 0.75 - 0.75 * p[1].w);
    return max(depth, 0.75) / length(p[1].xyz);
}
