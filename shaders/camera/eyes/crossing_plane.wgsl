// Two eyes whose views cross on a plane before them: what is there has the same place in both. Each view stays a flat picture,
// as seen through a window on that plane; eyes that turned inwards would shift its left and right edges up and down.

struct Stereo {
    // From the camera to the right eye.
    offset: Real3,
    // To the plane, along `forward`.
    distance: Real,
}

var<uniform> stereo: Stereo;

fn eye_ray(ray: CameraRay, right: bool) -> CameraRay {
    let offset = select(-stereo.offset, stereo.offset, right);
    let reach = stereo.distance / dot(ray.d, camera.forward);
    return CameraRay(ray.x + offset, normalize(reach * ray.d - offset), ray.status);
}
