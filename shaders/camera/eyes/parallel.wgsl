// Moves a ray to one of two eyes that look in the same direction: points at infinity have the same position in both views.

struct Stereo {
    // The vector from the camera to the right eye.
    offset: Real3,
}

var<uniform> stereo: Stereo;

fn eye_ray(ray: CameraRay, right: bool) -> CameraRay {
    return CameraRay(ray.x + select(-stereo.offset, stereo.offset, right), ray.d, ray.status);
}
