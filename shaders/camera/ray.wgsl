// A camera ray: its start, and its unit direction in the frame of the camera.

struct CameraRay {
    x: Real3,
    d: Real3,
    // ALIVE, or the reason why there is no ray to follow: MISSED or OUTSIDE.
    status: u32,
}

// Returns MISSED if an active ray never enters the bounding sphere, else its status.
fn entering(status: u32, missed: bool) -> u32 {
    return select(status, MISSED, status == ALIVE && missed);
}

// Converts a point in pixels, from the top left of a view of `size` pixels, to the image plane [-1, 1]² with y up.
fn image_plane(point: vec2f, size: vec2u) -> Real2 {
    let p = 2.0 * Real2(point) / Real2(size) - 1.0;
    return Real2(p.x, -p.y);
}
