// A dynamical system's field as an acceleration: W04's Eq. 1 read literally, dx = v, dv = F(x).

// Nothing is held.
fn law_held(p: Phase) -> Real {
    return 0.0;
}

fn law_acceleration(x: Real3, held: Real) -> Real3 {
    return flow_field(x);
}

fn law_start(x: Real3, v: Real3) -> Phase {
    return Phase(x, v);
}

fn law_projected(p: Phase) -> Phase {
    return p;
}

// An acceleration of rate² changes v over the square root of the flow's time.
fn law_scale(p: Phase) -> Real {
    return sqrt(flow_time());
}
