// All rays start at one place (W04 §3.1).

struct Camera {
    position: Real3,
    forward: Real3,
    // To the edges of the picture, at distance 1: tan(fov/2) long upwards.
    right: Real3,
    up: Real3,
}

var<uniform> camera: Camera;

// point: on the image plane, x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let d = normalize(camera.forward + point.x * camera.right + point.y * camera.up);
    return CameraRay(camera.position, d, ALIVE);
}
