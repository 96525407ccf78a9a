// Two eyes whose views cross on a sphere round the camera, for those that see more than a plane before them: what is there has
// the same place in both.

struct Stereo {
    // From the camera to the right eye.
    offset: Real3,
    // The sphere's radius.
    distance: Real,
}

var<uniform> stereo: Stereo;

fn eye_ray(ray: CameraRay, right: bool) -> CameraRay {
    let offset = select(-stereo.offset, stereo.offset, right);
    return CameraRay(ray.x + offset, normalize(stereo.distance * ray.d - offset), ray.status);
}
