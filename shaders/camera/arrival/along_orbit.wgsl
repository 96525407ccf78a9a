// A camera outside the bounding sphere sees along orbits, which start on it at once. Those that miss it go on from the camera.

fn arrived(ray: CameraRay) -> CameraRay {
    let v = frame_velocity(ray.x, ray.d);
    let entry = bound_entry(ray.x, v);
    if entry == 0.0 || entry < 0.0 {
        return CameraRay(ray.x, v, entering(ray.status, entry < 0.0));
    }
    return arriving(orbit_of(ray.x, v), 1.0 / bound.radius, ray.status);
}
