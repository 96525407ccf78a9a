// The field of a dynamical system as an acceleration: W04 Eq. 1 read literally, dx = v, dv = F(x).

fn law_acceleration(x: Real3, constant: Real) -> Real3 {
    return flow_field(x);
}

// An acceleration of rate² changes v over the square root of the flow's time.
fn law_scale(p: Phase) -> Real {
    return sqrt(flow_time());
}
