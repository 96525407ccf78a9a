// Outside the bounding sphere space is flat: a camera's ray from there starts where it enters.

fn arrived(ray: CameraRay) -> CameraRay {
    let entry = bound_entry(ray.x, ray.d);
    let x = ray.x + max(entry, 0.0) * ray.d;
    return CameraRay(x, frame_velocity(x, ray.d), entering(ray.status, entry < 0.0));
}
