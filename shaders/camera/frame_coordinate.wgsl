// Takes the camera's directions as coordinate directions (W04 §5.4).

fn frame_velocity(x: Real3, d: Real3) -> Real3 {
    return d;
}
