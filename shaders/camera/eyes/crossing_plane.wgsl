// Moves a ray to one of two eyes whose views cross on a plane in front of them: points on the plane have the same position in both. Each
// view stays a flat image, as seen through a window on that plane; eyes that turned inwards would shift its left and right edges up and
// down.

struct Stereo {
    // The vector from the camera to the right eye.
    offset: Real3,
    // The distance to the plane, along `forward`.
    distance: Real,
}

var<uniform> stereo: Stereo;

fn eye_ray(ray: CameraRay, right: bool) -> CameraRay {
    let offset = select(-stereo.offset, stereo.offset, right);
    let reach = stereo.distance / dot(ray.d, camera.forward);
    return CameraRay(ray.x + offset, normalize(reach * ray.d - offset), ray.status);
}
