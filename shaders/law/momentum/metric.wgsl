// By a line element. With U = (v, −1), which v = dx/dτ makes light, it is gU: of two ways that light goes along a direction
// where nothing rests, v's length says which.

// Of light that goes into the past from x at v, up to a positive factor.
fn law_momentum(x: Real3, v: Real3) -> Real4 {
    let m = metric_at(metric_place(x), 0.0);
    return Real4(metric_lowered(m, v) - m.shift, dot(m.shift, v) - m.clock);
}

// From the middle of what the law is the same around.
fn law_arm(x: Real3) -> Real3 {
    return metric_place(x);
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    return metric_square(metric_at(metric_place(x), 0.0), k);
}

// Of light that goes into the past from x at v, up to a positive factor; tau before the picture was taken.
fn law_momentum_at(x: Real3, v: Real3, tau: Real) -> Real4 {
    let m = metric_at(metric_place(x), law.time - tau);
    return Real4(metric_lowered(m, v) - m.shift, dot(m.shift, v) - m.clock);
}

// g(k, k) then.
fn law_square_at(x: Real3, k: Real4, tau: Real) -> Real {
    return metric_square(metric_at(metric_place(x), law.time - tau), k);
}
