// A flow that changes over a time that the scene gives.

fn flow_time() -> Real {
    return own_scale.scale;
}
