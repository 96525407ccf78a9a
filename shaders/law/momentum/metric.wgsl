// By a line element. With U = (v, −1) it is gU.

// Of light that goes into the past from x along d, but for a factor.
fn law_momentum(x: Real3, d: Real3) -> Real4 {
    let m = metric_at(metric_place(x), 0.0);
    let v = as_light(m, d);
    return Real4(metric_lowered(m, v) - m.shift, dot(m.shift, v) - m.clock);
}

// g(k, k).
fn law_square(x: Real3, k: Real4) -> Real {
    return metric_square(metric_at(metric_place(x), 0.0), k);
}
