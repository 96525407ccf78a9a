// G95's Table 1 under a flow: v ← F(x).

fn next_velocity(p: Phase) -> Real3 {
    return flow_field(p[0]);
}
