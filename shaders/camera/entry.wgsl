// A camera's ray: a position and a unit direction in the camera's frame, and whether it ever enters the bounding sphere.

struct CameraRay {
    x: vec3f,
    d: vec3f,
    missed: bool,
}

// Outside the bounding sphere space is flat: a ray from there starts where it enters.
fn entering_ray(x: vec3f, d: vec3f) -> CameraRay {
    let entry = bound_entry(x, d);
    return CameraRay(x + max(entry, 0.0) * d, d, entry < 0.0);
}
