// By a line element that changes with t. With U = (v, −1), which v = dx/dτ makes light, it is gU.

// Of light that goes into the past from x at v, up to a positive factor; tau before the picture was taken.
fn law_momentum_at(x: Real3, v: Real3, tau: Real) -> Real4 {
    let m = metric_at(x - law.center, law.time - tau);
    return Real4(metric_lowered(m, v) - m.shift, dot(m.shift, v) - m.clock);
}

// g(k, k) then.
fn law_square_at(x: Real3, k: Real4, tau: Real) -> Real {
    return metric_square(metric_at(x - law.center, law.time - tau), k);
}
