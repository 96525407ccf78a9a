// Light by a line element that changes with t: v = dx/dτ, τ = t_camera − t.

struct Law {
    center: Real3,
    // When the picture is taken.
    time: Real,
}

var<uniform> law: Law;

fn metric_place(x: Real3) -> Real3 {
    return x - law.center;
}

fn law_pull_at(at: Real3, v: Real3, tau: Real) -> Real3 {
    return metric_pull(metric_bend(at - law.center, v, law.time - tau), v);
}

fn law_stretch_at(at: Real3, v: Real3, tau: Real) -> Real4 {
    return metric_stretch(metric_bend(at - law.center, v, law.time - tau), v);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(Real4(x, 0.0), Real4(as_light(metric_at(x - law.center, law.time), v), 0.0));
}

fn law_scale(p: Phase) -> Real {
    return abs(metric_scale(p[0].xyz - law.center, law.time - p[1].w)) / length(p[1].xyz);
}
