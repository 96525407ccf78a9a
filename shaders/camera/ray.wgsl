// A camera's ray: where it starts, with a unit direction in the camera's frame.

struct CameraRay {
    x: Real3,
    d: Real3,
    // There is no ray, or it never comes inside the bounding sphere.
    missed: bool,
}
