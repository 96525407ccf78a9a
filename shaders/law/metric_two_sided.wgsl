// Light by a line element of two sides that a throat joins: v = dx/dτ, τ = t_camera − t. Each side is drawn round a mouth of its own, and a
// place is on the side of the mouth that it is nearer to; a little beyond the throat, l < 0, it is still on the side that it came from.

struct Law {
    center: Real3,
    // The other side's mouth.
    other: Real3,
    // ρ₀.
    radius: Real,
}

var<uniform> law: Law;

// 1 on this side, −1 on the other: of the place that was asked for last.
var<private> metric_side: Real;

// From the mouth that is nearer.
fn mouth_offset(x: Real3) -> Real3 {
    let here = x - law.center;
    let there = x - law.other;
    let beyond = dot(there, there) < dot(here, here);
    metric_side = select(Real(1.0), -1.0, beyond);
    return select(here, there, beyond);
}

fn metric_place(x: Real3) -> Real3 {
    return mouth_offset(x);
}

fn law_pull(at: Real3, v: Real3) -> Real3 {
    return metric_pull(metric_bend(mouth_offset(at), v, 0.0), v);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, as_light(metric_at(mouth_offset(x), 0.0), v));
}

fn law_scale(p: Phase) -> Real {
    return abs(metric_scale(mouth_offset(p[0]), 0.0)) / length(p[1]);
}
