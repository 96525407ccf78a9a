// A pinhole camera: all rays start at one point (W04 §3.1).

struct Camera {
    position: Real3,
    forward: Real3,
    // The vectors to the edges of the image at distance 1; the upward one has the length tan(fov/2).
    right: Real3,
    up: Real3,
}

var<uniform> camera: Camera;

// Returns the ray through `point` on the image plane: x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let d = normalize(camera.forward + point.x * camera.right + point.y * camera.up);
    return CameraRay(camera.position, d, ALIVE);
}
