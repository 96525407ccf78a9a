// A flow whose characteristic time is given by the scene.

fn flow_time() -> Real {
    return own_scale.scale;
}
