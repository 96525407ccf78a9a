// A camera's ray: where it starts, with a unit direction in the camera's frame.

struct CameraRay {
    x: Real3,
    d: Real3,
    // ALIVE, or why there is nothing to follow: MISSED or OUTSIDE.
    status: u32,
}

// The status of a ray that may be found to never come inside the bounding sphere.
fn entering(status: u32, missed: bool) -> u32 {
    return select(status, MISSED, status == ALIVE && missed);
}

// A point in pixels, from the top left of a view of so many, to the image plane's [-1, 1]², y up.
fn image_plane(point: vec2f, size: vec2u) -> Real2 {
    let p = 2.0 * Real2(point) / Real2(size) - 1.0;
    return Real2(p.x, -p.y);
}
