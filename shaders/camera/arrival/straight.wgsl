// Outside the bounding sphere space is flat: a camera's ray from there starts where it enters, on the line along which it comes to the camera.
// To an observer who moves it seems to come from elsewhere.

fn arrived(ray: CameraRay) -> CameraRay {
    let v = frame_velocity(ray.x, ray.d);
    let entry = bound_entry(ray.x, v);
    let x = ray.x + max(entry, 0.0) * v;
    return CameraRay(x, v, entering(ray.status, entry < 0.0));
}
