// No picture: a pixel is only a ray's number, for `trace`.

fn sample_point(pixel: vec2u) -> vec2f {
    return vec2f(pixel);
}

fn image_plane(point: vec2f, size: vec2u) -> vec2f {
    return point;
}
