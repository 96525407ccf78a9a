// Light in a custom metric: v = dx/dτ, τ = t_camera − t. If a throat joins two sides of space, each side is drawn around its
// own mouth, and a position belongs to the side of the nearer mouth. Slightly beyond the throat, at l < 0, it still belongs to the side that it
// came from.

struct Law {
    center: Real3,
    // The coordinate time at the camera.
    time: Real,
    // The mouth of the other side, and ρ₀.
    other: Real3,
    radius: Real,
}

var<uniform> law: Law;

// 1 on this side, −1 on the other: for the position that was evaluated last.
var<private> metric_side: Real;

// Returns the position of x relative to the nearer mouth.
fn mouth_offset(x: Real3) -> Real3 {
    let here = x - law.center;
    let there = x - law.other;
    let beyond = dot(there, there) < dot(here, here);
    metric_side = select(Real(1.0), -1.0, beyond);
    return select(here, there, beyond);
}

fn metric_place(x: Real3) -> Real3 {
    if HAS_THROAT {
        return mouth_offset(x);
    }
    return x - law.center;
}

fn law_acceleration_by_velocity(at: Real3, v: Real3) -> Real3 {
    return metric_pull(metric_bend(metric_place(at), v, 0.0), v);
}

fn law_acceleration_by_time(at: Real3, v: Real3, tau: Real) -> Real3 {
    return metric_pull(metric_bend(metric_place(at), v, law.time - tau), v);
}

fn law_stretch_at(at: Real3, v: Real3, tau: Real) -> Real4 {
    return metric_stretch(metric_bend(metric_place(at), v, law.time - tau), v);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    if CARRIES_TIME {
        return Phase(Real4(x, 0.0), Real4(as_light(metric_at(metric_place(x), law.time), v), 0.0));
    }
    return Phase(x, as_light(metric_at(metric_place(x), 0.0), v));
}

fn law_scale(p: Phase) -> Real {
    if CARRIES_TIME {
        return abs(metric_scale(metric_place(p[0].xyz), law.time - p[1].w)) / length(p[1].xyz);
    }
    return abs(metric_scale(metric_place(p[0]), 0.0)) / length(p[1]);
}
