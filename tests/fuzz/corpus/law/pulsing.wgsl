// A mass that pulses: its pull swings with tau about a mean. It is soft in the middle, where it stays finite.

fn law_acceleration_by_time(x: Real3, v: Real3, tau: Real) -> Real3 {
    let swing = real_sin_cos(0.75 * tau).x;
    let r2 = dot(x, x) + 0.75 * 0.75;
    return (-0.75 * (1.0 + 0.75 * swing) / (r2 * sqrt(r2))) * x;
}

fn law_scale(p: Phase) -> Real {
    return min(sqrt(dot(p[0].xyz, p[0].xyz) + 0.75 * 0.75) / length(p[1].xyz), 1.0 / 0.75);
}
