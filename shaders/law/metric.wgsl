// Light by a line element that does not change with t: v = dx/dτ, τ = t_camera − t.

struct Law {
    center: Real3,
}

var<uniform> law: Law;

fn metric_place(x: Real3) -> Real3 {
    return x - law.center;
}

fn law_pull(at: Real3, v: Real3) -> Real3 {
    return metric_pull(metric_bend(at - law.center, v, 0.0), v);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, as_light(metric_at(x - law.center, 0.0), v));
}

fn law_scale(p: Phase) -> Real {
    return abs(metric_scale(p[0] - law.center, 0.0)) / length(p[1]);
}
