// Two eyes that look the same way: what is infinitely far has the same place in both views.

struct Stereo {
    // From the camera to the right eye.
    offset: Real3,
}

var<uniform> stereo: Stereo;

fn eye_ray(ray: CameraRay, right: bool) -> CameraRay {
    return CameraRay(ray.x + select(-stereo.offset, stereo.offset, right), ray.d, ray.status);
}
