// A panoramic camera: all rays start at one point, with longitude to the right and latitude upwards, in the layout of an equirectangular
// environment map with `forward` at its center.

struct Camera {
    position: Real3,
    forward: Real3,
    right: Real3,
    up: Real3,
    // The angles from the center to the edges of the image, in quarter turns.
    quarters: Real2,
}

var<uniform> camera: Camera;

// Returns the ray through `point` on the image plane: x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let longitude = quarters_sin_cos(point.x * camera.quarters.x);
    let latitude = quarters_sin_cos(point.y * camera.quarters.y);
    let level = longitude.y * camera.forward + longitude.x * camera.right;
    return CameraRay(camera.position, latitude.y * level + latitude.x * camera.up, ALIVE);
}
