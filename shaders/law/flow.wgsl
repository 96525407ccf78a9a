// A dynamical system as a first-order flow (G95 §2.2): dx = F(x). The direction of view has no effect; v is F(x), recomputed after each
// step, so that arcs and outputs find the tangent of the path where other laws store it.

fn law_derivative(p: Phase) -> Phase {
    return Phase(flow_field(p[0]), Real3(0.0));
}

// Along the flow F changes as DF · F; the curvature needs only its direction and magnitude, so that a small step is sufficient.
fn path_acceleration(p: Phase, rate: Phase) -> Real3 {
    let small = 1e-3 * flow_time();
    return (flow_field(p[0] + small * rate[0]) - rate[0]) / small;
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, flow_field(x));
}

fn law_projected(p: Phase) -> Phase {
    return Phase(p[0], flow_field(p[0]));
}

fn law_scale(p: Phase) -> Real {
    return flow_time();
}

// Returns the new velocity of G95 Table 1 under a flow: v ← F(x).
fn next_velocity(p: Phase) -> Real3 {
    return flow_field(p[0]);
}
