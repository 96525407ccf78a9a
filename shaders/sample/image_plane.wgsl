// A point in pixels, from the top left of a view of so many, to the image plane's [-1, 1]², y up.

fn image_plane(point: vec2f, size: vec2u) -> vec2f {
    let p = 2.0 * point / vec2f(size) - 1.0;
    return vec2f(p.x, -p.y);
}
