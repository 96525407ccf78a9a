// All rays start at one place: longitude to the right and latitude upwards, as an equirectangular sky is laid out, with
// `forward` in the middle.

struct Camera {
    position: Real3,
    forward: Real3,
    right: Real3,
    up: Real3,
    // From the middle to the edges of the picture, in quarter turns.
    quarters: Real2,
}

var<uniform> camera: Camera;

// point: on the image plane, x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let longitude = quarters_sin_cos(point.x * camera.quarters.x);
    let latitude = quarters_sin_cos(point.y * camera.quarters.y);
    let level = longitude.y * camera.forward + longitude.x * camera.right;
    return CameraRay(camera.position, latitude.y * level + latitude.x * camera.up, ALIVE);
}
