// An orthographic camera: rays start on a plane, all in the same direction (G95 §2.2: the image plane that flows need).

struct Camera {
    position: Real3,
    forward: Real3,
    // The vectors to the edges of the image.
    right: Real3,
    up: Real3,
}

var<uniform> camera: Camera;

// Returns the ray through `point` on the image plane: x to the right and y up, both in [-1, 1].
fn camera_ray(point: Real2) -> CameraRay {
    let x = camera.position + point.x * camera.right + point.y * camera.up;
    return CameraRay(x, camera.forward, ALIVE);
}
