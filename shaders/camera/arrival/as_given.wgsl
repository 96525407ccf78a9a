// Given rays start where they are, and only what moves away from outside the bounding sphere never comes inside.

fn arrived(ray: CameraRay) -> CameraRay {
    return CameraRay(ray.x, ray.d, entering(ray.status, left_bound(ray.x, ray.d)));
}
