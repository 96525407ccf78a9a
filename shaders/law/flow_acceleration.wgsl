// A dynamical system's field as an acceleration: W04's Eq. 1 read literally, dx = v, dv = F(x).

fn law_rate(p: Phase) -> Phase {
    return Phase(p[1], flow_field(p[0]));
}

fn law_start(x: vec3f, v: vec3f) -> Phase {
    return Phase(x, v);
}

fn law_settled(p: Phase) -> Phase {
    return p;
}

// An acceleration of rate² changes v over the square root of the flow's time.
fn law_scale(p: Phase) -> f32 {
    return sqrt(flow_time());
}
