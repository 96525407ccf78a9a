// A wall that light bounces off, moving along its normal: a smooth step of potential, so steep that it turns
// slower rays back. Rays that meet the wall while it approaches come back faster.

fn law_acceleration_by_time(x: Real3, v: Real3, tau: Real) -> Real3 {
    let depth = (dot(x, law.normal) - law.offset - law.speed * tau) / law.width;
    // The slope of height / (1 + e^(-depth)), without overflow on either side.
    let e = real_exp(-abs(depth));
    let slope = law.height * e / (law.width * (1.0 + e) * (1.0 + e));
    return -slope * law.normal;
}

// Steps shrink towards the wall, down to its own width.
fn law_scale(p: Phase) -> Real {
    let depth = abs(dot(p[0].xyz, law.normal) - law.offset - law.speed * p[1].w);
    return max(depth, law.width) / length(p[1].xyz);
}
