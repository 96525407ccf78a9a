// Two views share the picture: the left eye's is the upper half. A pixel's half is its own, wherever rounding puts its samples.

fn picture_ray(pixel: vec2u) -> CameraRay {
    let size = vec2u(frame.image.x, frame.image.y / 2u);
    let right = pixel.y >= size.y;
    let corner = vec2u(0u, select(0u, size.y, right));
    return eye_ray(camera_ray(image_plane(sample_point(pixel) - vec2f(corner), size)), right);
}

// Are the corners of a pixel of the picture all of its own view?
fn corners_shared(pixel: vec2u) -> bool {
    return pixel.y + 1u != frame.image.y / 2u;
}
