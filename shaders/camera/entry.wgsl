// A camera's ray: a position and a unit direction in the camera's frame, and whether it ever enters the bounding sphere.

struct CameraRay {
    x: Real3,
    d: Real3,
    missed: bool,
}

// Outside the bounding sphere space is flat: a ray from there starts where it enters.
fn entering_ray(x: Real3, d: Real3) -> CameraRay {
    let entry = bound_entry(x, d);
    return CameraRay(x + max(entry, 0.0) * d, d, entry < 0.0);
}
