// A dynamical system as a first-order flow (G95 §2.2): dx = F(x). The direction of view does not matter; v is F(x), set
// anew after each step, so that arcs and outputs find the path's tangent where other laws keep it.

fn law_rate(p: Phase) -> Phase {
    return Phase(flow_field(p[0]), vec3f(0.0));
}

fn law_start(x: vec3f, v: vec3f) -> Phase {
    return Phase(x, flow_field(x));
}

fn law_settled(p: Phase) -> Phase {
    return Phase(p[0], flow_field(p[0]));
}

fn law_scale(p: Phase) -> f32 {
    return flow_time();
}
