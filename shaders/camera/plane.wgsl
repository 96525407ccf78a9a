// Rays start on a plane, all in the same direction (G95 §2.2: the image plane that flows need).

struct Camera {
    position: vec3f,
    forward: vec3f,
    // To the edges of the picture.
    right: vec3f,
    up: vec3f,
}

@group(0) @binding(2) var<uniform> camera: Camera;

// point: on the image plane, x to the right and y up, both in [-1, 1].
fn camera_ray(point: vec2f) -> CameraRay {
    return entering_ray(camera.position + point.x * camera.right + point.y * camera.up, camera.forward);
}
