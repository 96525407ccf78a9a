// Moves a ray to one of two eyes whose views cross on a sphere around the camera, for wide fields of view: points on the sphere have the
// same position in both views.

struct Stereo {
    // The vector from the camera to the right eye.
    offset: Real3,
    // The radius of the sphere.
    distance: Real,
}

var<uniform> stereo: Stereo;

fn eye_ray(ray: CameraRay, right: bool) -> CameraRay {
    let offset = select(-stereo.offset, stereo.offset, right);
    return CameraRay(ray.x + offset, normalize(stereo.distance * ray.d - offset), ray.status);
}
