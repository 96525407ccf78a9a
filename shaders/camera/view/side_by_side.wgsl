// Two views share the picture: the left eye's is the left half. A pixel's half is its own, wherever rounding puts its samples.

fn picture_ray(pixel: vec2u) -> CameraRay {
    let size = vec2u(frame.image.x / 2u, frame.image.y);
    let right = pixel.x >= size.x;
    let corner = vec2u(select(0u, size.x, right), 0u);
    return eye_ray(camera_ray(image_plane(sample_point(pixel) - vec2f(corner), size)), right);
}

// Are the corners of a pixel of the picture all of its own view?
fn corners_shared(pixel: vec2u) -> bool {
    return pixel.x + 1u != frame.image.x / 2u;
}
