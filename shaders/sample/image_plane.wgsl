// A point in pixels, from the top left of the whole picture, to the image plane's [-1, 1]², y up.

fn image_plane(point: vec2f) -> vec2f {
    let p = 2.0 * point / vec2f(frame.image) - 1.0;
    return vec2f(p.x, -p.y);
}
