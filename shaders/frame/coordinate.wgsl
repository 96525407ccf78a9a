// The camera's directions are coordinate directions (W04 §5.4).

fn frame_velocity(x: vec3f, d: vec3f) -> vec3f {
    return d;
}
